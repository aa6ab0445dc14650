// A reader of the part of XML that data is made of: tags, attributes and text.
// No DTD, no entities but XML's own. https://www.w3.org/TR/xml/

#ifndef KG_BASE_COMMON_XML_READER_H_
#define KG_BASE_COMMON_XML_READER_H_

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace kg_base {

struct XmlTag {
  std::string name;  // Without prefix; "/name" of a closing tag; "" at the end.
  std::string full_name;                          // With it.
  bool empty = false;                             // <name/>
  std::map<std::string, std::string> attributes;  // Without, but for xml:...,
  std::map<std::string, std::string> full_attributes;  // and with prefix.
  std::string text;  // What stands between it and the next tag.
};

class XmlReader {
 public:
  // `source` is named in errors. Throws InputError, as all here does.
  XmlReader(std::string_view text, std::string source);

  XmlTag Next();
  // "source, line:column: expected ..."
  [[noreturn]] void Expected(const std::string& what) const;

 private:
  bool SkipAside(std::string_view open, std::string_view close);
  std::string TextUntil(char end);
  std::string ReadEntity();
  void ReadAttributes(XmlTag* tag);
  std::string ReadName();
  void SkipBlanks() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
  }
  char Peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string_view text_;
  std::string source_;
  std::size_t at_ = 0;
};

}  // namespace kg_base

#endif  // KG_BASE_COMMON_XML_READER_H_
