#include "kg_compiler/explain/explanation.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "kg_base/common/join_strings.h"

namespace kg_compiler {
namespace {

std::string Format(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

}  // namespace

double Explanation::Sum() const {
  double sum = 0.0;
  for (const Contribution& part : parts) sum += part.value;
  return sum;
}

void Explanation::AddIfAny(Contribution part) {
  if (part.value != 0.0) parts.push_back(std::move(part));
}

std::string Short(double value) { return Format("%.4g", value); }
std::string Signed(double value) { return Format("%+.4g", value); }

std::string JoinFacts(const std::vector<std::string>& facts) {
  return kg_base::JoinStrings(facts, " . ");
}

std::string ToText(const Explanation& explanation) {
  std::string text = explanation.text;
  for (const Contribution& part : explanation.parts) {
    text += "\n" + Format("%+12.6f", part.value) + "  " + part.text;
    for (const std::string& fact : part.facts) {
      text += "\n                " + fact;
    }
  }
  return text;
}

std::string ToJson(const Explanation& explanation) {
  nlohmann::ordered_json json;
  json["value"] = explanation.value;
  json["unit"] = explanation.unit;
  json["verdict"] = explanation.verdict;
  json["text"] = explanation.text;
  json["contributions"] = nlohmann::ordered_json::array();
  for (const Contribution& part : explanation.parts) {
    json["contributions"].push_back({{"value", part.value},
                                     {"term", part.term},
                                     {"text", part.text},
                                     {"facts", part.facts}});
  }
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace kg_compiler
