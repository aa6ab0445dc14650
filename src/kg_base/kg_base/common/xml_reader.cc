#include "kg_base/common/xml_reader.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"

namespace kg_base {
namespace {

// xml:lang keeps its prefix.
std::string XmlLocalName(const std::string& name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos || name.substr(0, colon) == "xml") return name;
  return name.substr(colon + 1);
}

}  // namespace

XmlReader::XmlReader(std::string_view text, std::string source)
    : text_(text), source_(std::move(source)) {
  if (FirstBadUtf8(text)) Expected("UTF-8");
}

void XmlReader::Expected(const std::string& what) const {
  const TextPosition place = PositionAt(text_, std::min(at_, text_.size()));
  throw InputError(source_ + ", " + std::to_string(place.line) + ":" +
                   std::to_string(place.column) + ": expected " + what);
}

// Skips a comment or a processing instruction.
bool XmlReader::SkipAside(std::string_view open, std::string_view close) {
  if (text_.substr(at_, open.size()) != open) return false;
  const std::size_t end = text_.find(close, at_ + open.size());
  if (end == std::string_view::npos) Expected(std::string(close));
  at_ = end + close.size();
  return true;
}

std::string XmlReader::ReadEntity() {
  constexpr std::pair<const char*, const char*> kEntities[] = {
      {"lt", "<"}, {"gt", ">"}, {"amp", "&"}, {"quot", "\""}, {"apos", "'"}};
  const std::size_t end = text_.find(';', at_);
  // The longest entity is &#x10FFFF; a ';' farther away does not belong to it.
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

// Reads character data up to `end`, which is not consumed; skips comments.
std::string XmlReader::TextUntil(char end) {
  constexpr std::string_view kCdata = "<![CDATA[";
  std::string out;
  while (at_ < text_.size()) {
    const std::size_t start = at_;
    if (SkipAside(kCdata, "]]>")) {
      // Without the section's own brackets; 3 is the length of "]]>".
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

std::string XmlReader::ReadName() {
  const std::size_t end = text_.find_first_of(" \t\r\n=/>", at_);
  if (end == std::string_view::npos || end == at_) Expected("a name");
  std::string name(text_.substr(at_, end - at_));
  at_ = end;
  return name;
}

void XmlReader::ReadAttributes(XmlTag* tag) {
  for (SkipBlanks(); Peek() != '>' && Peek() != '/'; SkipBlanks()) {
    const std::string name = ReadName();
    SkipBlanks();
    if (Peek() != '=') Expected("'='");
    ++at_;
    SkipBlanks();
    const char quote = Peek();
    if (quote != '"' && quote != '\'') Expected("a quote");
    ++at_;
    const std::string value = TextUntil(quote);
    tag->attributes[XmlLocalName(name)] = value;
    tag->full_attributes[name] = value;
    if (Peek() != quote) Expected("the end of the attribute");
    ++at_;
  }
}

XmlTag XmlReader::Next() {
  XmlTag tag;
  TextUntil('<');
  if (at_ >= text_.size()) return tag;
  ++at_;
  // A DTD could define entities that expand without bound.
  if (Peek() == '!') Expected("no DTD");
  if (Peek() == '/') {
    ++at_;
    tag.full_name = "/" + ReadName();
    tag.name = "/" + XmlLocalName(tag.full_name.substr(1));
  } else {
    tag.full_name = ReadName();
    tag.name = XmlLocalName(tag.full_name);
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

}  // namespace kg_base
