// A reader of the subset of XML used for data: tags, attributes and text. No
// DTD, only the predefined entities. https://www.w3.org/TR/xml/

#ifndef KG_BASE_COMMON_XML_READER_H_
#define KG_BASE_COMMON_XML_READER_H_

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace kg_base {

struct XmlTag {
  std::string name;       // Without prefix; "/name" = closing tag; "" = end.
  std::string full_name;  // With prefix.
  bool empty = false;     // <name/>
  // Keys without prefix, except xml:...
  std::map<std::string, std::string> attributes;
  // Keys with prefix.
  std::map<std::string, std::string> full_attributes;
  std::string text;  // Text up to the next tag.
};

class XmlReader {
 public:
  // `source` is named in errors. All members throw InputError.
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
