#include "kg_mission/mission/derived_facts.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_core/facts/changed_subjects.h"
#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/time_forms.h"

namespace kg_mission {
namespace {

using kg_base::InputError;
using kg_core::ChangedSubjects;
using kg_core::ChangeScope;
using kg_core::Ex;
using kg_core::Facts;
using kg_core::GeoTerm;
using kg_core::Objects;
using kg_core::RdfType;
using kg_core::Term;
using kg_core::Transaction;

// A property with a JSON value, and the typed nodes into which it is expanded.
struct JsonProperty {
  const char* property;      // Property of a policy; JSON {name: number}.
  const char* link;          // Link from policy to node.
  const char* node_class;    // Class of the node.
  const char* target;        // Its property for the named entity.
  const char* target_class;  // Class of the named entity.
  const char* value;         // Its property for the number.
  const char* folder;        // Component of the node's IRI.
};
constexpr JsonProperty kJsonProperties[] = {
    {"priors", "hasPriorWeight", "PriorWeight", "layer", "PriorLayer", "beta",
     "prior"},
    {"softOverrides", "hasSoftOverride", "SoftOverride", "constraint",
     "Constraint", "attenuation", "soft_override"},
};

using Json = nlohmann::json;

std::string LocalName(const Term& term) {
  return term.text.substr(term.text.find_last_of("/#") + 1);
}

// Parses strict JSON (RFC 8259); rejects duplicate keys in the outer object.
Json ParseObject(const std::string& text) {
  std::set<std::string> keys;
  // Needs a parser callback, because the parser itself silently keeps the last
  // of two equal names.
  const auto refuse_twins = [&](int depth, Json::parse_event_t event,
                                Json& value) {
    if (event == Json::parse_event_t::key && depth == 1 &&
        !keys.insert(value.get<std::string>()).second) {
      throw InputError("the name \"" + value.get<std::string>() +
                       "\" stands twice");
    }
    return true;
  };
  Json json;
  try {
    json = Json::parse(text, refuse_twins);
  } catch (const Json::parse_error& error) {
    throw InputError("not JSON at byte " + std::to_string(error.byte));
  } catch (const Json::exception&) {
    throw InputError("not JSON that can be represented");
  }
  if (!json.is_object()) throw InputError("expected a JSON object {...}");
  return json;
}

double GetNumber(const Json& value, const std::string& name) {
  if (value.is_number()) return value.get<double>();
  throw InputError("expected a number for \"" + name + "\", not " +
                   value.dump());
}

class JsonExpansion {
 public:
  JsonExpansion(const JsonProperty& kind, Transaction& transaction)
      : kind_(kind), transaction_(transaction) {}

  void Expand(const Term& policy) {
    DropNodes(policy);
    for (const Term& literal :
         Objects(transaction_.view(), kg_core::kFactsGraph, policy,
                 Ex(kind_.property))) {
      const Json json = ParseObject(literal.text);
      for (const auto& [name, value] : json.items()) {
        AddNode(policy, Find(name), GetNumber(value, name));
      }
    }
  }

 private:
  Term MakeNode(const Term& policy, const std::string& local) const {
    return kg_core::Iri(policy.text + "/" + kind_.folder + "/" + local);
  }

  // Removes the nodes of an earlier expansion; nodes made by an operator are
  // kept.
  void DropNodes(const Term& policy) {
    const std::string prefix = MakeNode(policy, "").text;
    for (const Term& node :
         kg_core::Linked(transaction_, policy, Ex(kind_.link))) {
      if (node.text.compare(0, prefix.size(), prefix) != 0) continue;
      transaction_.RemoveMatching(&node, nullptr, nullptr, Facts());
      transaction_.Remove({policy, Ex(kind_.link), node, Facts()});
    }
  }

  void AddNode(const Term& policy, const Term& target, double value) {
    const Term node = MakeNode(policy, LocalName(target));
    transaction_.Add({policy, Ex(kind_.link), node, Facts()});
    transaction_.Add({node, RdfType(), Ex(kind_.node_class), Facts()});
    transaction_.Add({node, Ex(kind_.target), target, Facts()});
    transaction_.Add(
        {node, Ex(kind_.value), kg_core::DoubleLiteral(value), Facts()});
  }

  // True if `name` is the target's ex:name, "ex:corridor" or "corridor".
  bool IsNamed(const Term& target, const std::string& name) const {
    return kg_core::ToTurtle(target) == name || LocalName(target) == name ||
           kg_core::Has(transaction_.view(), kg_core::kFactsGraph, target,
                        Ex("name"), kg_core::Literal(name));
  }

  Term Find(const std::string& name) const {
    std::vector<std::string> known;
    for (const Term& target :
         kg_core::FindInstances(transaction_.view(), kg_core::kFactsGraph,
                                Ex(kind_.target_class))) {
      if (IsNamed(target, name)) return target;
      known.push_back(LocalName(target));
    }
    throw InputError(
        std::string("no ex:") + kind_.target_class + " is named \"" + name +
        "\"; known: " + (known.empty() ? "none" : kg_base::JoinStrings(known)));
  }

  const JsonProperty& kind_;
  Transaction& transaction_;
};

void ExpandJson(Transaction& transaction, ChangeScope scope,
                std::vector<std::string>& reasons) {
  for (const JsonProperty& kind : kJsonProperties) {
    for (const Term& policy :
         ChangedSubjects(transaction, Ex(kind.property), scope)) {
      try {
        JsonExpansion(kind, transaction).Expand(policy);
      } catch (const InputError& error) {
        reasons.push_back(kg_core::ToTurtle(policy) + " ex:" + kind.property +
                          ": " + error.what());
      }
    }
  }
}

// True for a geometry node or a node without facts; links to other nodes are
// left to the shapes to reject.
bool IsGeometry(const kg_core::GraphView& view, const Term& node) {
  const std::vector<Term> types =
      Objects(view, kg_core::kFactsGraph, node, RdfType());
  return types.empty() || types == std::vector<Term>{GeoTerm("Geometry")};
}

// Copies the WKT of `original` to `copy`.
void CopyWkt(Transaction& transaction, const Term& original, const Term& copy) {
  const Term as_wkt = GeoTerm("asWKT");
  transaction.RemoveMatching(&copy, &as_wkt, nullptr, Facts());
  for (const Term& wkt :
       Objects(transaction.view(), kg_core::kFactsGraph, original, as_wkt)) {
    transaction.Add({copy, as_wkt, wkt, Facts()});
  }
}

// Updates the long form of a feature whose short form changed.
void RenewGeometryNode(Transaction& transaction, const Term& feature) {
  const Term has_geometry = GeoTerm("hasGeometry");
  for (const Term& node : kg_core::Linked(transaction, feature, has_geometry)) {
    if (!IsGeometry(transaction.view(), node)) continue;
    transaction.RemoveMatching(&node, nullptr, nullptr, Facts());
    transaction.Remove({feature, has_geometry, node, Facts()});
  }
  if (!kg_core::FirstObject(transaction.view(), kg_core::kFactsGraph, feature,
                            GeoTerm("asWKT"))) {
    return;
  }
  const Term node = kg_core::Iri(feature.text + "/geometry");
  transaction.Add({feature, has_geometry, node, Facts()});
  transaction.Add({node, RdfType(), GeoTerm("Geometry"), Facts()});
  CopyWkt(transaction, feature, node);
}

// True for geometry nodes, including those just made by RenewGeometryNode.
bool IsGeometryNode(const kg_core::GraphView& view, const Term& subject) {
  return kg_core::Has(view, kg_core::kFactsGraph, subject, RdfType(),
                      GeoTerm("Geometry"));
}

void KeepGeometries(Transaction& transaction, ChangeScope scope) {
  const std::set<Term> changed =
      ChangedSubjects(transaction, GeoTerm("asWKT"), scope);
  const std::set<Term> linked =
      ChangedSubjects(transaction, GeoTerm("hasGeometry"), scope);
  std::set<Term> features;
  std::set<Term> owners = linked;
  for (const Term& subject : changed) {
    const std::vector<Term> of =
        kg_core::Subjects(transaction.view(), kg_core::kFactsGraph,
                          GeoTerm("hasGeometry"), subject);
    const bool is_node =
        !of.empty() || IsGeometryNode(transaction.view(), subject);
    if (!is_node) features.insert(subject);
    owners.insert(of.begin(), of.end());
  }
  for (const Term& feature : features) {
    if (feature.is_iri() && !IsGeometryNode(transaction.view(), feature)) {
      RenewGeometryNode(transaction, feature);
    }
  }
  // The WKT of a changed geometry node is copied to its feature, unless the
  // feature's own WKT changed as well, which takes precedence.
  for (const Term& owner : owners) {
    if (features.count(owner) != 0) continue;
    const auto node =
        kg_core::FirstObject(transaction.view(), kg_core::kFactsGraph, owner,
                             GeoTerm("hasGeometry"));
    if (node && IsGeometry(transaction.view(), *node)) {
      CopyWkt(transaction, *node, owner);
    }
  }
}

}  // namespace

std::vector<std::string> StageDerivedFacts(Transaction& transaction,
                                           ChangeScope scope) {
  std::vector<std::string> reasons;
  ExpandJson(transaction, scope, reasons);
  KeepGeometries(transaction, scope);
  StageTimeForms(transaction, scope);
  return reasons;
}

}  // namespace kg_mission
