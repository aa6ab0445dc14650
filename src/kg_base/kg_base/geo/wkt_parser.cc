#include "kg_base/geo/wkt_parser.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"

namespace kg_base {
namespace {

constexpr std::size_t kMaxQuotedBytes = 24;

struct TypeKeyword {
  std::string_view word;
  WktKind kind;
};
constexpr TypeKeyword kKeywords[] = {
    {"POINT", WktKind::kPoint},
    {"LINESTRING", WktKind::kLineString},
    {"POLYGON", WktKind::kPolygon},
    {"MULTIPOINT", WktKind::kMultiPoint},
    {"MULTILINESTRING", WktKind::kMultiLineString},
    {"MULTIPOLYGON", WktKind::kMultiPolygon},
    {"GEOMETRYCOLLECTION", WktKind::kCollection},
};

constexpr double kWgs84Srid = 4326.0;
constexpr double kMaxHeight = 1e9;  // In whatever unit.

constexpr std::string_view kCrs84[] = {
    "http://www.opengis.net/def/crs/OGC/1.3/CRS84",
    "https://www.opengis.net/def/crs/OGC/1.3/CRS84",
    "urn:ogc:def:crs:OGC:1.3:CRS84",
};

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool IsLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
char Upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  WktNode Document() {
    if (!SkipSrid()) SkipCrs();
    WktNode node = Geometry(0);
    SkipSpace();
    if (at_ < text_.size()) Fail("the end of the text");
    return node;
  }

 private:
  [[noreturn]] void Fail(const std::string& expected) const {
    FailAt(at_, expected);
  }
  [[noreturn]] void FailAt(std::size_t at, const std::string& expected) const {
    throw InputError("WKT, character " + std::to_string(at + 1) +
                     ": expected " + expected + ", found " + Quoted(at));
  }
  std::string Quoted(std::size_t at) const;

  void SkipSpace() {
    while (at_ < text_.size() && IsSpace(text_[at_])) ++at_;
  }
  bool TryToken(char token) {
    SkipSpace();
    if (at_ >= text_.size() || text_[at_] != token) return false;
    ++at_;
    return true;
  }
  void Token(char token) {
    if (!TryToken(token)) Fail(std::string("'") + token + "'");
  }
  std::string Word();
  bool SkipSrid();
  void SkipCrs();
  // Reads what may stand between a keyword and its positions.
  void ReadDimension(const std::string& keyword);

  WktNode Geometry(int depth);
  WktNode Body(WktKind kind, int depth);
  WktNode Members(WktKind member, int depth);
  WktNode PointBody();
  WktNode LineBody();
  WktNode PolygonBody();
  std::vector<LonLat> Chain();
  std::vector<LonLat> Ring();
  LonLat Vertex();
  double Number(double limit, const char* what);

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t vertices_ = 0;
  // Heights are read and left out. EWKT has them without a Z, too.
  bool has_height_ = false;
  bool may_have_height_ = false;
};

std::string Parser::Quoted(std::size_t at) const {
  if (at >= text_.size()) return "the end of the text";
  std::string quoted = "\"";
  for (const char c : text_.substr(at, kMaxQuotedBytes)) {
    quoted += c >= ' ' && c <= '~' ? c : '?';
  }
  return quoted + "\"";
}

std::string Parser::Word() {
  SkipSpace();
  std::string word;
  while (at_ < text_.size() && IsLetter(text_[at_])) {
    word += Upper(text_[at_++]);
  }
  return word;
}

void Parser::SkipCrs() {
  SkipSpace();
  const std::size_t begin = at_;
  if (!TryToken('<')) return;
  const std::size_t end = text_.find('>', at_);
  if (end == std::string_view::npos) FailAt(begin, "a reference system <IRI>");
  const std::string_view iri = text_.substr(at_, end - at_);
  for (const std::string_view known : kCrs84) {
    if (iri == known) {
      at_ = end + 1;
      return;
    }
  }
  throw InputError("WKT, character " + std::to_string(begin + 1) +
                   ": reference system <" +
                   std::string(FirstCharacters(iri, 200)) +
                   "> is not understood, expected CRS84 <" +
                   std::string(kCrs84[0]) + ">, longitude before latitude");
}

// PostGIS writes the reference system as "SRID=4326;", longitude first.
bool Parser::SkipSrid() {
  SkipSpace();
  const std::size_t begin = at_;
  if (Word() != "SRID") {
    at_ = begin;
    return false;
  }
  Token('=');
  const double code = Number(1e9, "the number of a reference system");
  if (code != kWgs84Srid) {
    FailAt(begin, "SRID=4326, WGS84 with longitude before latitude");
  }
  Token(';');
  may_have_height_ = true;
  return true;
}

void Parser::ReadDimension(const std::string& keyword) {
  SkipSpace();
  const std::size_t begin = at_;
  std::string word = Word();
  if (word == "Z") {
    has_height_ = true;
    SkipSpace();
    word = Word();
  }
  if (word.empty()) return;
  if (word == "EMPTY") FailAt(begin, "a " + keyword + " that is not empty");
  FailAt(begin, "'(' and two coordinates for each position, or Z and three");
}

WktNode Parser::Geometry(int depth) {
  SkipSpace();
  const std::size_t begin = at_;
  if (depth > kMaxWktNesting) {
    Fail("at most " + std::to_string(kMaxWktNesting) + " nested collections");
  }
  const std::string word = Word();
  for (const TypeKeyword& keyword : kKeywords) {
    const bool is_z = word == std::string(keyword.word) + "Z";
    if (word != keyword.word && !is_z) continue;
    const bool had_height = has_height_;  // That of the enclosing collection.
    has_height_ = has_height_ || is_z;
    ReadDimension(word);
    WktNode node = Body(keyword.kind, depth);
    has_height_ = had_height;
    return node;
  }
  FailAt(begin,
         "a geometry (POINT, LINESTRING, POLYGON, MULTI..., "
         "GEOMETRYCOLLECTION)");
}

WktNode Parser::Body(WktKind kind, int depth) {
  WktNode node;
  // Single geometries set their own kind; lists are returned without one.
  switch (kind) {
    case WktKind::kPoint:
      return PointBody();
    case WktKind::kLineString:
      return LineBody();
    case WktKind::kPolygon:
      return PolygonBody();
    case WktKind::kMultiPoint:
      node = Members(WktKind::kPoint, depth);
      break;
    case WktKind::kMultiLineString:
      node = Members(WktKind::kLineString, depth);
      break;
    case WktKind::kMultiPolygon:
      node = Members(WktKind::kPolygon, depth);
      break;
    case WktKind::kCollection:
      node = Members(WktKind::kCollection, depth);
      break;
  }
  node.kind = kind;
  return node;
}

// A comma-separated list in parentheses of bodies of `member`, or, for
// kCollection, of whole geometries.
WktNode Parser::Members(WktKind member, int depth) {
  WktNode node;
  Token('(');
  do {
    SkipSpace();
    const bool bare = at_ < text_.size() && text_[at_] != '(';
    if (member == WktKind::kCollection) {
      node.members.push_back(Geometry(depth + 1));
    } else if (member == WktKind::kPoint && bare) {
      node.members.push_back({WktKind::kPoint, {{Vertex()}}, {}});
    } else {
      node.members.push_back(Body(member, depth));
    }
  } while (TryToken(','));
  Token(')');
  return node;
}

WktNode Parser::PointBody() {
  Token('(');
  const LonLat vertex = Vertex();
  Token(')');
  return {WktKind::kPoint, {{vertex}}, {}};
}

WktNode Parser::LineBody() {
  SkipSpace();
  const std::size_t begin = at_;
  const std::vector<LonLat> chain = Chain();
  for (const LonLat& vertex : chain) {
    if (vertex != chain.front()) return {WktKind::kLineString, {chain}, {}};
  }
  FailAt(begin, "a line of at least two different positions");
}

WktNode Parser::PolygonBody() {
  WktNode node;
  node.kind = WktKind::kPolygon;
  Token('(');
  do {
    node.chains.push_back(Ring());
  } while (TryToken(','));
  Token(')');
  return node;
}

std::vector<LonLat> Parser::Chain() {
  std::vector<LonLat> chain;
  Token('(');
  do {
    chain.push_back(Vertex());
  } while (TryToken(','));
  Token(')');
  return chain;
}

std::vector<LonLat> Parser::Ring() {
  SkipSpace();
  const std::size_t begin = at_;
  std::vector<LonLat> ring = Chain();
  if (ring.size() < 4) FailAt(begin, "a ring of at least four positions");
  if (ring.front() != ring.back()) {
    FailAt(begin, "a ring that ends at the position it begins with");
  }
  return ring;
}

LonLat Parser::Vertex() {
  if (++vertices_ > kMaxWktVertices) {
    Fail("at most " + std::to_string(kMaxWktVertices) + " positions");
  }
  LonLat vertex;
  vertex.lon_deg = Number(360.0, "a longitude in [-360, 360]");
  vertex.lat_deg = Number(90.0, "a latitude in [-90, 90]");
  const auto is_over = [&] {
    SkipSpace();
    return at_ < text_.size() && (text_[at_] == ',' || text_[at_] == ')');
  };
  if (has_height_ || (may_have_height_ && !is_over())) {
    Number(kMaxHeight, "a height");
  }
  if (!is_over()) {
    Fail("',' or ')' after longitude and latitude");
  }
  return vertex;
}

double Parser::Number(double limit, const char* what) {
  SkipSpace();
  const std::size_t begin = at_;
  if (at_ < text_.size() && text_[at_] == '+') ++at_;
  double value = 0.0;
  const char* first = text_.data() + at_;
  const auto [end, error] =
      std::from_chars(first, text_.data() + text_.size(), value);
  if (error != std::errc() || !(std::abs(value) <= limit)) FailAt(begin, what);
  at_ += static_cast<std::size_t>(end - first);
  return value + 0.0;  // -0 becomes 0.
}

}  // namespace

WktNode ParseWkt(std::string_view text) {
  if (text.size() > kMaxWktBytes) {
    throw InputError("WKT: expected at most " + std::to_string(kMaxWktBytes) +
                     " bytes, found " + std::to_string(text.size()));
  }
  return Parser(text).Document();
}

}  // namespace kg_base
