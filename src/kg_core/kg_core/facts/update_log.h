// The log entry of an accepted update: one ex:UpdateFacts activity
// <graph/log/v12> in the provenance graph, and in the log graph an
// ex:FactChange for every fact that was added or removed. Source files of facts
// or vocabulary are separate nodes, one per path and content. For reading the
// log see facts/history.h.

#ifndef KG_CORE_FACTS_UPDATE_LOG_H_
#define KG_CORE_FACTS_UPDATE_LOG_H_

#include <vector>

#include "kg_core/facts/fact_update.h"
#include "kg_core/facts/source_file.h"
#include "kg_core/rdf/store.h"

namespace kg_core {

// Adds the log entry of an accepted update (graph ex:graph/log): who, when,
// each old and new value, and the provenance activity (ex:graph/prov), which
// prov:used the update's files. Adds nothing if no fact changed. `time_s` is
// Unix time in seconds.
void LogUpdate(const FactUpdate& update, double time_s,
               Transaction& transaction);

// Adds the activity (ex:LoadVocabulary in ex:graph/prov) of a vocabulary read
// from `files`; its triples are not logged individually. Adds nothing if
// `files` is empty.
void LogVocabulary(const std::vector<SourceFile>& files, double time_s,
                   Transaction& transaction);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_UPDATE_LOG_H_
