// SHACL validation of any one graph, such as a plan graph: checks that what the
// programs write conforms to the shapes.

#ifndef KG_MISSION_MISSION_TESTING_VALIDATE_GRAPH_H_
#define KG_MISSION_MISSION_TESTING_VALIDATE_GRAPH_H_

#include <memory>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/shacl/shapes.h"
#include "kg_core/shacl/validation.h"

namespace kg_mission {

// Validates the focus nodes of `graph` against the shapes of the vocabulary
// graph. Classes are read from facts, vocabulary, provenance and `graph`.
inline std::vector<kg_core::Violation> ValidateGraph(
    const kg_core::GraphView& view, const std::string& graph) {
  const auto shapes = kg_core::shacl::LoadShapes(view, kg_core::kVocabGraph);
  const kg_core::shacl::DataGraph data = {
      view,
      graph,
      {kg_core::kFactsGraph, kg_core::kVocabGraph, kg_core::kProvGraph, graph},
      nullptr};
  return kg_core::shacl::ShapeValidation(data, shapes).Run();
}

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_TESTING_VALIDATE_GRAPH_H_
