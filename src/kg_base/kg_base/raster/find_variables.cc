#include "kg_base/raster/find_variables.h"

#include <algorithm>

#include "kg_base/common/join_strings.h"
#include "kg_base/common/text.h"

namespace kg_base {
namespace {

constexpr std::size_t kMaxNamed = 8;  // Variables listed in a message.

bool HasName(const NetcdfVariable& variable, const std::string& lower_case) {
  return ToLowerAscii(variable.base_name) == lower_case;
}

// Coordinates and bounds are no fields.
bool IsField(const NetcdfVariable& variable) {
  return variable.dimensions.size() >= 2;
}

class VariableFinder {
 public:
  VariableFinder(const NetcdfFile& file, FieldQuantity quantity)
      : file_(file), quantity_(quantity), words_(WordsFor(quantity)) {}

  // Null if there is none.
  const NetcdfVariable* Find() const {
    for (const std::string& standard_name : words_.standard_names) {
      const NetcdfVariable* found = ByStandardName(standard_name);
      if (found != nullptr) return found;
    }
    return ByName();
  }
  std::vector<std::string> OtherCandidates(const NetcdfVariable& chosen) const;
  std::string WhatIsMissing() const;

 private:
  const NetcdfVariable* ByStandardName(const std::string& standard_name) const;
  const NetcdfVariable* ByName() const;
  bool IsSilent(const NetcdfVariable& variable) const {
    return variable.Text("standard_name").empty() &&
           ContradictingWord(quantity_, variable.Text("long_name")).empty();
  }

  const NetcdfFile& file_;
  const FieldQuantity quantity_;
  const QuantityWords& words_;
};

// The variable with a standard name; of several the one with a usual name.
const NetcdfVariable* VariableFinder::ByStandardName(
    const std::string& standard_name) const {
  std::vector<const NetcdfVariable*> found;
  for (const NetcdfVariable& variable : file_.variables()) {
    if (variable.Text("standard_name") == standard_name) {
      found.push_back(&variable);
    }
  }
  if (found.size() < 2) return found.empty() ? nullptr : found.front();
  for (const std::string& name : words_.variable_names) {
    std::vector<const NetcdfVariable*> named;
    for (const NetcdfVariable* variable : found) {
      if (HasName(*variable, name)) named.push_back(variable);
    }
    // Two of one name lie in different groups.
    if (named.size() == 1) return named.front();
  }
  file_.Refuse("variables " + found[0]->name + " and " + found[1]->name +
               " both have standard_name " + standard_name +
               ", expected one, or one named " +
               JoinStrings(words_.variable_names));
}

const NetcdfVariable* VariableFinder::ByName() const {
  for (const std::string& name : words_.variable_names) {
    const NetcdfVariable* found = nullptr;
    for (const NetcdfVariable& variable : file_.variables()) {
      if (!HasName(variable, name) || !IsSilent(variable)) continue;
      if (found == nullptr) {
        found = &variable;
      } else if (found->group_path != variable.group_path) {
        file_.Refuse("variables " + found->name + " and " + variable.name +
                     " could both be the " + words_.name +
                     ", expected a standard_name");
      }
    }
    if (found != nullptr) return found;
  }
  return nullptr;
}

std::string Described(const NetcdfVariable& variable) {
  for (const char* attribute : {"standard_name", "long_name"}) {
    const std::string text = variable.Text(attribute);
    if (!text.empty()) {
      return variable.name + " (" + attribute + " " + text.substr(0, 100) + ")";
    }
  }
  return variable.name;
}

// Variables that the choice leaves out though users may have meant them.
std::vector<std::string> VariableFinder::OtherCandidates(
    const NetcdfVariable& chosen) const {
  std::vector<std::string> others;
  for (const NetcdfVariable& other : file_.variables()) {
    if (&other == &chosen || !IsField(other)) continue;
    const std::string standard = other.Text("standard_name");
    const std::vector<std::string>& known = words_.standard_names;
    const bool is_candidate =
        std::find(known.begin(), known.end(), standard) != known.end() ||
        IsRelatedName(quantity_, standard);
    if (is_candidate) others.push_back(Described(other));
  }
  if (others.empty()) return {};
  if (others.size() > kMaxNamed) others.resize(kMaxNamed);
  return {"chosen among several variables: " + Described(chosen) + ", not " +
          JoinStrings(others) + "; preferred are the standard_names " +
          JoinStrings(words_.standard_names) + " in this order"};
}

std::string VariableFinder::WhatIsMissing() const {
  return "no variable for " + std::string(words_.name) +
         ", tried standard_name " + JoinStrings(words_.standard_names) +
         " and name " + JoinStrings(words_.variable_names);
}

std::string WhatIsThere(const NetcdfFile& file) {
  std::vector<std::string> fields;
  for (const NetcdfVariable& variable : file.variables()) {
    if (IsField(variable) && fields.size() < kMaxNamed) {
      fields.push_back(Described(variable));
    }
  }
  return fields.empty() ? "the file has no fields"
                        : "the file has " + JoinStrings(fields);
}

// Rejects one component of water velocity combined with one of wind velocity.
void RefuseTwoMedia(const NetcdfFile& file,
                    const std::vector<const NetcdfVariable*>& variables) {
  if (variables.size() < 2) return;
  const std::string first = variables[0]->Text("standard_name");
  const std::string second = variables[1]->Text("standard_name");
  if (IsWindName(first) == IsWindName(second)) return;
  file.Refuse("variables " + variables[0]->name + " (" + first + ") and " +
              variables[1]->name + " (" + second +
              "): expected both of sea water or both of wind");
}

}  // namespace

std::vector<FoundVariable> FindVariables(
    const NetcdfFile& file, const std::vector<FieldQuantity>& quantities) {
  std::vector<FoundVariable> found;
  std::vector<const NetcdfVariable*> variables;
  std::vector<std::string> missing;
  for (const FieldQuantity quantity : quantities) {
    const VariableFinder finder(file, quantity);
    const NetcdfVariable* variable = finder.Find();
    if (variable == nullptr) {
      missing.push_back(finder.WhatIsMissing());
      continue;
    }
    variables.push_back(variable);
    found.push_back({variable, finder.OtherCandidates(*variable)});
  }
  if (!missing.empty()) {
    file.Refuse(JoinStrings(missing, "; ") + "; " + WhatIsThere(file));
  }
  RefuseTwoMedia(file, variables);
  return found;
}

}  // namespace kg_base
