// The shapes of a graph, read again only when the graph has changed.
//
// The cache keeps the statements that its shapes were read from and compares
// all of them, term by term, so it cannot answer for another graph; that takes
// a small part of the time that reading the shapes takes.

#ifndef KG_CORE_SHACL_SHAPE_CACHE_H_
#define KG_CORE_SHACL_SHAPE_CACHE_H_

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_core/shacl/shapes.h"

namespace kg_core::shacl {

// Safe from any thread.
class ShapeCache {
 public:
  // As LoadShapes; refused shapes are not kept.
  std::shared_ptr<const ShapeGraph> Get(const GraphView& view,
                                        const std::string& graph);

 private:
  bool HoldsFor(const GraphView& view, const Quad& all) const;

  std::mutex mutex_;
  std::vector<Statement> statements_;  // In the order of the view's index.
  std::shared_ptr<const ShapeGraph> shapes_;
};

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_SHAPE_CACHE_H_
