// Cache of the shapes of a graph, which are read again only when it changes.
//
// The cache keeps the statements from which its shapes were read and compares
// all of them, term by term, so it never returns shapes of another graph; the
// comparison takes a small fraction of the time to read the shapes.

#ifndef KG_CORE_SHACL_SHAPE_CACHE_H_
#define KG_CORE_SHACL_SHAPE_CACHE_H_

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_core/shacl/shapes.h"

namespace kg_core::shacl {

// Thread-safe.
class ShapeCache {
 public:
  // Like LoadShapes; rejected shapes are not cached.
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
