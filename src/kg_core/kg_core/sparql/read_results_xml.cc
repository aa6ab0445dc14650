// Results in XML: a reader of the part of XML that they are made of.
// https://www.w3.org/TR/rdf-sparql-XMLres/

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_core/base/text.h"
#include "kg_core/sparql/read_results.h"

namespace kg_core {
namespace {

// A tag; `text` is what stands between it and the next tag.
struct Tag {
  std::string name;  // Without prefix; "/name" of a closing tag; "" at the end.
  bool empty = false;  // <name/>
  std::map<std::string, std::string> attributes;
  std::string text;
};

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {
    if (FirstBadUtf8(text)) Expected("UTF-8");
  }

  Tag Next();
  [[noreturn]] void Expected(const std::string& what) const {
    const TextPosition place = PositionAt(text_, std::min(at_, text_.size()));
    throw InputError("XML result, " + std::to_string(place.line) + ":" +
                     std::to_string(place.column) + ": expected " + what);
  }

 private:
  bool SkipAside(std::string_view open, std::string_view close);
  std::string TextUntil(char end);
  std::string ReadEntity();
  void ReadAttributes(Tag* tag);
  std::string ReadName();
  void SkipBlanks() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
  }
  char Peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string_view text_;
  std::size_t at_ = 0;
};

// Skips a comment or a processing instruction.
bool Reader::SkipAside(std::string_view open, std::string_view close) {
  if (text_.substr(at_, open.size()) != open) return false;
  const std::size_t end = text_.find(close, at_ + open.size());
  if (end == std::string_view::npos) Expected(std::string(close));
  at_ = end + close.size();
  return true;
}

std::string Reader::ReadEntity() {
  constexpr std::pair<const char*, const char*> kEntities[] = {
      {"lt", "<"}, {"gt", ">"}, {"amp", "&"}, {"quot", "\""}, {"apos", "'"}};
  const std::size_t end = text_.find(';', at_);
  if (end == std::string_view::npos || end - at_ > 10) Expected("an entity");
  const std::string name(text_.substr(at_ + 1, end - at_ - 1));
  std::string out;
  for (const auto& [entity, character] : kEntities) {
    if (name == entity) out = character;
  }
  if (name.size() > 1 && name[0] == '#') {
    const bool hex = name[1] == 'x';
    char* last = nullptr;
    const unsigned long code =
        std::strtoul(name.c_str() + (hex ? 2 : 1), &last, hex ? 16 : 10);
    if (*last != '\0' || code > 0x10FFFF ||
        !IsUnicodeScalar(static_cast<std::uint32_t>(code))) {
      Expected("the code of a character");
    }
    AppendUtf8(static_cast<std::uint32_t>(code), &out);
  }
  if (out.empty()) Expected("an entity of XML's own");
  at_ = end + 1;
  return out;
}

// Character data up to `end`, which is left; comments drop out.
std::string Reader::TextUntil(char end) {
  constexpr std::string_view kCdata = "<![CDATA[";
  std::string out;
  while (at_ < text_.size()) {
    const std::size_t start = at_;
    if (SkipAside(kCdata, "]]>")) {
      out +=
          text_.substr(start + kCdata.size(), at_ - start - kCdata.size() - 3);
    } else if (SkipAside("<!--", "-->") || SkipAside("<?", "?>")) {
      continue;
    } else if (Peek() == end) {
      return out;
    } else if (Peek() == '&') {
      out += ReadEntity();
    } else {
      out.push_back(text_[at_++]);
    }
  }
  return out;
}

// A name without its prefix; xml:lang keeps it.
std::string Reader::ReadName() {
  const std::size_t end = text_.find_first_of(" \t\r\n=/>", at_);
  if (end == std::string_view::npos || end == at_) Expected("a name");
  std::string name(text_.substr(at_, end - at_));
  at_ = end;
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos || name.substr(0, colon) == "xml") return name;
  return name.substr(colon + 1);
}

void Reader::ReadAttributes(Tag* tag) {
  for (SkipBlanks(); Peek() != '>' && Peek() != '/'; SkipBlanks()) {
    const std::string name = ReadName();
    SkipBlanks();
    if (Peek() != '=') Expected("'='");
    ++at_;
    SkipBlanks();
    const char quote = Peek();
    if (quote != '"' && quote != '\'') Expected("a quote");
    ++at_;
    tag->attributes[name] = TextUntil(quote);
    if (Peek() != quote) Expected("the end of the attribute");
    ++at_;
  }
}

Tag Reader::Next() {
  Tag tag;
  TextUntil('<');
  if (at_ >= text_.size()) return tag;
  ++at_;
  if (Peek() == '!') Expected("no DTD");
  if (Peek() == '/') {
    ++at_;
    tag.name = "/" + ReadName();
  } else {
    tag.name = ReadName();
    ReadAttributes(&tag);
  }
  SkipBlanks();
  tag.empty = Peek() == '/';
  if (tag.empty) ++at_;
  if (Peek() != '>') Expected("'>'");
  ++at_;
  if (!tag.empty) tag.text = TextUntil('<');
  return tag;
}

Term TermOf(const Tag& tag, const Reader& reader) {
  if (tag.name == "uri") return Iri(tag.text);
  if (tag.name == "bnode") return Blank(tag.text);
  if (tag.name != "literal") reader.Expected("<uri>, <bnode> or <literal>");
  const auto language = tag.attributes.find("xml:lang");
  if (language != tag.attributes.end()) {
    return LanguageLiteral(tag.text, language->second);
  }
  const auto datatype = tag.attributes.find("datatype");
  if (datatype == tag.attributes.end()) return Literal(tag.text);
  return Literal(tag.text, datatype->second);
}

void ReadBinding(const Tag& tag, Reader* reader, QueryResult* result) {
  const auto name = tag.attributes.find("name");
  const auto& variables = result->variables;
  const auto found =
      name == tag.attributes.end()
          ? variables.end()
          : std::find(variables.begin(), variables.end(), name->second);
  if (found == variables.end() || result->rows.empty()) {
    reader->Expected("the binding of a variable of <head>");
  }
  result->rows.back()[static_cast<std::size_t>(found - variables.begin())] =
      TermOf(reader->Next(), *reader);
}

}  // namespace

QueryResult ReadXmlResult(std::string_view text) {
  Reader reader(text);
  QueryResult result;
  if (reader.Next().name != "sparql") reader.Expected("<sparql>");
  for (Tag tag = reader.Next(); !tag.name.empty(); tag = reader.Next()) {
    if (tag.name == "variable") {
      result.variables.push_back(tag.attributes["name"]);
    } else if (tag.name == "boolean") {
      result.form = QueryResult::Form::kAsk;
      result.answer = StripAsciiSpace(tag.text) == "true";
    } else if (tag.name == "result") {
      result.rows.emplace_back(result.variables.size());
    } else if (tag.name == "binding") {
      ReadBinding(tag, &reader, &result);
    }
  }
  return result;
}

}  // namespace kg_core
