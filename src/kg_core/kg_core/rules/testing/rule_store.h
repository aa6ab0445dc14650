// For tests: a store with a small vocabulary, rules and facts, but without
// shapes and missions.

#ifndef KG_CORE_RULES_TESTING_RULE_STORE_H_
#define KG_CORE_RULES_TESTING_RULE_STORE_H_

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "kg_core/facts/terms.h"
#include "kg_core/rdf/store.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/rules/inference.h"

namespace kg_core {

class RuleStore {
 public:
  RuleStore() {
    std::string words;
    for (const char* name : {"p0", "p1", "p2", "p3", "value", "count"}) {
      words += std::string("ex:") + name + " a owl:ObjectProperty .\n";
    }
    for (const char* name : {"C0", "C1", "C2"}) {
      words += std::string("ex:") + name + " a owl:Class .\n";
    }
    words += "rdf:type a owl:AnnotationProperty .\n";
    Transaction transaction = store.Begin();
    Put(words, kVocabGraph, transaction);
    transaction.Commit(WorldChange::kYes);
  }

  static std::string RuleTurtle(const std::string& name,
                                const std::string& construct) {
    return "ex:" + name + " a ex:Rule ; ex:construct '''" + construct + "''' .";
  }

  // Applies changes of the facts; returns the reasons for rejection, or commits
  // if there are none.
  std::vector<std::string> Change(const std::string& add,
                                  const std::string& remove = "") {
    Transaction transaction = store.Begin();
    for (const Statement& statement : ParseTurtle(remove, "test", Facts())) {
      transaction.Remove(statement);
    }
    Put(add, kFactsGraph, transaction);
    std::vector<std::string> reasons =
        StageInferences(transaction, FindForbidden, limits);
    if (reasons.empty()) transaction.Commit(WorldChange::kYes);
    return reasons;
  }
  std::vector<std::string> AddRule(const std::string& name,
                                   const std::string& construct) {
    return Change(RuleTurtle(name, construct));
  }

  bool Infers(const std::string& subject, const std::string& property,
              const std::string& object) const {
    return Has(*store.Read(), kInferredGraph, ParseTurtleTerm(subject),
               ParseTurtleTerm(property), ParseTurtleTerm(object));
  }

  // Stand-in for the conclusions forbidden by a mission.
  static std::optional<std::string> FindForbidden(const Term& term) {
    if (term != Ex("hasWindow")) return std::nullopt;
    return "files are read before rules are run";
  }

  Store store{""};
  InferenceLimits limits;

 private:
  static void Put(const std::string& turtle, const char* graph,
                  Transaction& transaction) {
    for (const Statement& s : ParseTurtle(turtle, "test", Iri(graph))) {
      transaction.Add(s);
    }
  }
};

}  // namespace kg_core

#endif  // KG_CORE_RULES_TESTING_RULE_STORE_H_
