// What an ingest has stated of a data source, as seen by those who need no
// files.

#ifndef KG_MISSION_MISSION_INGESTED_FACTS_H_
#define KG_MISSION_MISSION_INGESTED_FACTS_H_

#include <set>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"

namespace kg_mission {

// Properties that only data sources and windows have: to change one is to make
// an ingest due.
bool IngestReads(const kg_core::Term& property);

// Does the transaction change what an ingest would read (a data source, a
// window's times, a raster that is in a file), so that an ingest (ingest.h) is
// due?
bool IngestIsDue(const kg_core::Transaction& transaction);

// Those with ex:ingestedFrom.
std::set<kg_core::Term> IngestedSubjects(const kg_core::GraphView& view);

// Removes all facts about subjects with ex:ingestedFrom.
void DropIngestedFacts(kg_core::Transaction& transaction);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_INGESTED_FACTS_H_
