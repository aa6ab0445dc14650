// Parser of JSON texts from external sources into values.
// https://www.rfc-editor.org/rfc/rfc8259

#ifndef KG_BASE_TEXT_JSON_H_
#define KG_BASE_TEXT_JSON_H_

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kg_base {

struct JsonValue {
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  bool boolean = false;
  std::string text;              // kString; kNumber: as written.
  std::vector<JsonValue> items;  // kArray.
  std::vector<std::pair<std::string, JsonValue>> members;  // kObject, in order.

  // The first member of that name; nullptr if there is none.
  const JsonValue* Find(std::string_view name) const;
};

// Throws InputError "JSON, line:column: ..." with the expected token; nesting
// is limited to 100.
JsonValue ParseJson(std::string_view text);

}  // namespace kg_base

#endif  // KG_BASE_TEXT_JSON_H_
