#include "kg_core/facts/keys.h"

#include <algorithm>
#include <optional>
#include <set>

#include "kg_base/common/join_strings.h"
#include "kg_core/facts/changed_subjects.h"
#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/rdf_list.h"

namespace kg_core {
namespace {

Term HasKey() { return Iri(std::string(kOwl) + "hasKey"); }

class KeyCheck {
 public:
  KeyCheck(const GraphView& view, const Term& type, std::vector<Term> key)
      : view_(view),
        type_(type),
        types_(ClassAndSubclasses(view, type)),
        key_(std::move(key)) {}

  bool IsInstance(const Term& node) const {
    const std::vector<Term> types =
        Objects(view_, kFactsGraph, node, RdfType());
    return std::any_of(types.begin(), types.end(), [&](const Term& type) {
      return types_.count(type) != 0;
    });
  }

  // Another instance with the same key values as `node`, if any.
  std::optional<Term> FindTwin(const Term& node) const {
    const std::vector<Term> values = CollectValues(node);
    if (values.empty()) return std::nullopt;
    for (const Term& other :
         Subjects(view_, kFactsGraph, key_.front(), values.front())) {
      if (other != node && CollectValues(other) == values &&
          IsInstance(other)) {
        return other;
      }
    }
    return std::nullopt;
  }

  std::string Line(const Term& node, const Term& twin) const {
    const std::string names = kg_base::JoinStrings(
        key_, " and ", [](const Term& property) { return ToTurtle(property); });
    return ToTurtle(node) + ": expected one " + ToTurtle(type_) + " for each " +
           names + ", but " + ToTurtle(twin) + " has the same";
  }

 private:
  // The key values of `node`; empty if one is missing.
  std::vector<Term> CollectValues(const Term& node) const {
    std::vector<Term> values;
    for (const Term& property : key_) {
      const auto value = FirstObject(view_, kFactsGraph, node, property);
      if (!value) return {};
      values.push_back(*value);
    }
    return values;
  }

  const GraphView& view_;
  const Term type_;
  const std::set<Term> types_;
  const std::vector<Term> key_;
};

std::vector<KeyCheck> ReadKeys(const GraphView& view) {
  std::vector<KeyCheck> checks;
  Quad pattern;
  pattern.predicate = view.Find(HasKey());
  pattern.graph = view.Find(Iri(kVocabGraph));
  if (pattern.predicate == kNoTerm || pattern.graph == kNoTerm) return {};
  view.Match(pattern, [&](const Quad& quad) {
    auto key = ReadList(view, kVocabGraph, view.Get(quad.object));
    if (key && !key->empty()) {
      checks.emplace_back(view, view.Get(quad.subject), *std::move(key));
    }
    return true;
  });
  return checks;
}

}  // namespace

std::vector<std::string> CheckKeys(const Transaction& transaction) {
  std::vector<std::string> lines;
  const std::set<Term> changed = ChangedSubjects(transaction);
  for (const KeyCheck& check : ReadKeys(transaction.view())) {
    for (const Term& node : changed) {
      if (!check.IsInstance(node)) continue;
      const std::optional<Term> twin = check.FindTwin(node);
      if (twin) lines.push_back(check.Line(node, *twin));
    }
  }
  return lines;
}

}  // namespace kg_core
