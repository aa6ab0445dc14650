#include "kg_core/rules/conclusion_check.h"

#include <optional>

#include "kg_core/base/input_error.h"
#include "kg_core/facts/terms.h"
#include "kg_core/mission/ingest.h"
#include "kg_core/mission/ingested_facts.h"

namespace kg_core {
namespace {

struct Forbidden {
  const char* local;  // In ex:, a property or a class.
  const char* reason;
};
constexpr Forbidden kForbidden[] = {
    {"construct", "a rule concludes no rules"},
    {"enabled", "a rule concludes no rules"},
    {"Rule", "a rule concludes no rules"},
    {"Inference", "reasons are not concluded"},
    {"byRule", "reasons are not concluded"},
    {"conclusion", "reasons are not concluded"},
    {"ingestedFrom", "only an ingest of files states it"},
    {"DataSource", "files are read before rules are run"},
    {"gridRef", "files are read before rules are run"},
    {"resampling", "files are read before rules are run"},
    {"priors",
     "it is expanded before rules are run: conclude "
     "ex:hasPriorWeight"},
    {"softOverrides",
     "it is expanded before rules are run: conclude "
     "ex:hasSoftOverride"},
};

// Why no rule may conclude `word`, a property or a class.
std::optional<std::string> Refusal(const Term& word) {
  for (const Forbidden& forbidden : kForbidden) {
    if (word == Ex(forbidden.local)) return forbidden.reason;
  }
  if (IngestReads(word)) return "files are read before rules are run";
  return std::nullopt;
}

std::string Line(const Term& rule, const Term& word, const std::string& why) {
  return ToTurtle(rule) + " may not conclude " + ToTurtle(word) + ": " + why;
}

}  // namespace

void CheckWritten(const std::vector<Rule>& rules, const Vocabulary& vocabulary,
                  std::vector<std::string>* reasons) {
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
      for (const auto& word : {kind.predicate, kind.type}) {
        const auto why = word ? Refusal(*word) : std::nullopt;
        if (why) reasons->push_back(Line(rule.iri, *word, *why));
      }
    }
  }
}

void CheckConclusion(const Inference& inference) {
  const Term rule = Iri(inference.rule_iri);
  const Triple& triple = inference.conclusion;
  if (IsReason(triple.subject)) {
    throw InputError(Line(rule, triple.subject, "reasons are not concluded"));
  }
  const bool is_type = triple.predicate == RdfType();
  const Term& word = is_type ? triple.object : triple.predicate;
  if (const auto why = Refusal(word)) throw InputError(Line(rule, word, *why));
}

}  // namespace kg_core
