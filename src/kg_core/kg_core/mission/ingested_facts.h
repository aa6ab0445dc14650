// What an ingest has stated of a data source, as seen by those who need no
// files.

#ifndef KG_CORE_MISSION_INGESTED_FACTS_H_
#define KG_CORE_MISSION_INGESTED_FACTS_H_

#include <set>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"

namespace kg_core {

// Properties that only data sources and windows have: to change one is to make
// an ingest due.
bool IngestReads(const Term& property);

// Does the transaction change what an ingest would read (a data source, a
// window's times, a raster that is in a file), so that an ingest (ingest.h) is
// due?
bool IngestIsDue(const Transaction& transaction);

// Those with ex:ingestedFrom.
std::set<Term> IngestedSubjects(const GraphView& view);

// Removes all facts about subjects with ex:ingestedFrom.
void DropIngestedFacts(Transaction& transaction);

}  // namespace kg_core

#endif  // KG_CORE_MISSION_INGESTED_FACTS_H_
