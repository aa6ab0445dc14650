#include "kg_mission/mission/mission_rules.h"

#include "kg_core/facts/terms.h"
#include "kg_core/rules/inference.h"
#include "kg_mission/mission/ingested_facts.h"

namespace kg_mission {
namespace {

struct ForbiddenRow {
  const char* local;  // Local name in ex: of a property or class.
  const char* reason;
};
constexpr ForbiddenRow kForbiddenTerms[] = {
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

}  // namespace

std::optional<std::string> FindForbiddenConclusion(const kg_core::Term& term) {
  for (const ForbiddenRow& row : kForbiddenTerms) {
    if (term == kg_core::Ex(row.local)) return row.reason;
  }
  if (IngestReads(term)) return "files are read before rules are run";
  return std::nullopt;
}

std::vector<std::string> StageMissionRules(kg_core::Transaction& transaction) {
  return kg_core::StageInferences(transaction, FindForbiddenConclusion);
}

}  // namespace kg_mission
