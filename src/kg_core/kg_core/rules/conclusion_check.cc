#include "kg_core/rules/conclusion_check.h"

#include "kg_base/common/input_error.h"
#include "kg_core/facts/terms.h"

namespace kg_core {
namespace {

struct RuleTerm {
  const char* local;  // Local name in ex: of a property or class.
  const char* reason;
};
constexpr RuleTerm kRuleTerms[] = {
    {"construct", "a rule concludes no rules"},
    {"enabled", "a rule concludes no rules"},
    {"Rule", "a rule concludes no rules"},
    {"Inference", "reasons are not concluded"},
    {"byRule", "reasons are not concluded"},
    {"conclusion", "reasons are not concluded"},
};

// The reason why no rule may conclude `term` (a property or class), if any.
std::optional<std::string> FindRefusal(const Term& term,
                                       ForbiddenTerm forbidden) {
  for (const RuleTerm& row : kRuleTerms) {
    if (term == Ex(row.local)) return row.reason;
  }
  return forbidden(term);
}

std::string FormatRefusal(const Term& rule, const Term& term,
                          const std::string& why) {
  return ToTurtle(rule) + " may not conclude " + ToTurtle(term) + ": " + why;
}

}  // namespace

void CheckWritten(const std::vector<Rule>& rules, const Vocabulary& vocabulary,
                  ForbiddenTerm forbidden, std::vector<std::string>* reasons) {
  for (const Rule& rule : rules) {
    for (const TripleKind& kind : rule.writes) {
      if (kind.predicate &&
          vocabulary.FindProperty(*kind.predicate) == nullptr) {
        reasons->push_back(ToTurtle(rule.iri) + ": " +
                           vocabulary.UnknownProperty(*kind.predicate));
      }
      if (kind.type && !vocabulary.HasClass(*kind.type)) {
        reasons->push_back(ToTurtle(rule.iri) + ": " +
                           vocabulary.UnknownClass(*kind.type));
      }
      // A term may be both unknown and forbidden: report both.
      for (const auto& term : {kind.predicate, kind.type}) {
        const auto why = term ? FindRefusal(*term, forbidden) : std::nullopt;
        if (why) reasons->push_back(FormatRefusal(rule.iri, *term, *why));
      }
    }
  }
}

void CheckConclusion(const Inference& inference, ForbiddenTerm forbidden) {
  const Term rule = Iri(inference.rule_iri);
  const Triple& triple = inference.conclusion;
  if (IsReason(triple.subject)) {
    throw kg_base::InputError(
        FormatRefusal(rule, triple.subject, "reasons are not concluded"));
  }
  const bool is_type = triple.predicate == RdfType();
  const Term& term = is_type ? triple.object : triple.predicate;
  if (const auto why = FindRefusal(term, forbidden)) {
    throw kg_base::InputError(FormatRefusal(rule, term, *why));
  }
}

}  // namespace kg_core
