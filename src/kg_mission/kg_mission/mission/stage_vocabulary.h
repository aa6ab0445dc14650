// Loads the ontology files into the vocabulary graph.

#ifndef KG_MISSION_MISSION_STAGE_VOCABULARY_H_
#define KG_MISSION_MISSION_STAGE_VOCABULARY_H_

#include <string>
#include <vector>

#include "kg_core/facts/source_file.h"
#include "kg_core/rdf/store.h"

namespace kg_mission {

// Stages ontology, shapes and rules of `folder` (mission.ttl, shapes.ttl,
// rules.ttl) in the vocabulary graph, replacing its content, and updates the
// conclusions of the rules; does nothing if the graph is up to date. Returns
// the staged files, for the log (LogVocabulary). Throws InputError.
std::vector<kg_core::SourceFile> StageVocabulary(
    const std::string& folder, kg_core::Transaction& transaction);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_STAGE_VOCABULARY_H_
