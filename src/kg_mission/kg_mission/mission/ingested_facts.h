// Ingested facts: detection of a due ingest and removal of old facts, without
// reading files.

#ifndef KG_MISSION_MISSION_INGESTED_FACTS_H_
#define KG_MISSION_MISSION_INGESTED_FACTS_H_

#include <set>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"

namespace kg_mission {

// True for properties that only data sources and windows have; changing one
// makes an ingest due.
bool IngestReads(const kg_core::Term& property);

// True if the transaction changes the input of an ingest (a data source, the
// times of a window, a raster in a file), so that an ingest (ingest.h) is due.
bool IngestIsDue(const kg_core::Transaction& transaction);

// The subjects with ex:ingestedFrom.
std::set<kg_core::Term> IngestedSubjects(const kg_core::GraphView& view);

// Removes all facts about subjects with ex:ingestedFrom.
void DropIngestedFacts(kg_core::Transaction& transaction);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_INGESTED_FACTS_H_
