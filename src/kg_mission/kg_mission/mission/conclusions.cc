#include "kg_mission/mission/conclusions.h"

#include <set>
#include <utility>

#include "kg_base/common/join_strings.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rules/facts_and_conclusions.h"
#include "kg_core/rules/reasons.h"
#include "kg_mission/mission/statement_check.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

using kg_core::Statement;
using kg_core::Term;

// " (concluded by ex:r1, ex:r2)": the rules with a conclusion about `subject`,
// else all rules with conclusions.
std::string FormatBlamedRules(const kg_core::GraphView& view,
                              const std::vector<Statement>& conclusions,
                              const Term& subject) {
  std::set<std::string> about;
  std::set<std::string> all;
  for (const Statement& s : conclusions) {
    for (const kg_core::Inference& inference :
         kg_core::WhyInferred(view, {s.subject, s.predicate, s.object})) {
      const std::string rule =
          kg_core::ToTurtle(kg_core::Iri(inference.rule_iri));
      all.insert(rule);
      if (s.subject == subject || s.object == subject) about.insert(rule);
    }
  }
  const std::set<std::string>& names = about.empty() ? all : about;
  return " (concluded by " +
         kg_base::JoinStrings({names.begin(), names.end()}) + ")";
}

}  // namespace

std::vector<std::string> CheckConclusions(const kg_core::Vocabulary& vocabulary,
                                          const kg_core::GraphView& view) {
  const std::vector<Statement> conclusions = kg_core::Conclusions(view);
  std::set<Term> subjects;
  for (const Statement& s : conclusions) subjects.insert(s.subject);
  const kg_core::FactsAndConclusions world(view);
  std::vector<std::string> reasons;
  for (const Term& subject : subjects) {
    for (const std::string& reason :
         CheckSubjects(vocabulary, world, {subject})) {
      reasons.push_back(reason + FormatBlamedRules(view, conclusions, subject));
    }
  }
  if (!reasons.empty()) return reasons;
  // The shapes assume that the statements have passed the checks above.
  for (const kg_core::Violation& violation : ValidateConclusions(view)) {
    reasons.push_back(
        violation.Line() +
        FormatBlamedRules(view, conclusions, violation.focus_node));
  }
  return reasons;
}

}  // namespace kg_mission
