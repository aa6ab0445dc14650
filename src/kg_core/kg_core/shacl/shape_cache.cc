#include "kg_core/shacl/shape_cache.h"

#include <cstddef>

namespace kg_core::shacl {

bool ShapeCache::HoldsFor(const GraphView& view, const Quad& all) const {
  std::size_t count = 0;
  bool same = true;
  view.Match(all, [&](const Quad& quad) {
    same = count < statements_.size();
    if (!same) return false;
    const Statement& s = statements_[count++];
    same = s.subject == view.Get(quad.subject) &&
           s.predicate == view.Get(quad.predicate) &&
           s.object == view.Get(quad.object);
    return same;
  });
  return same && count == statements_.size();
}

std::shared_ptr<const ShapeGraph> ShapeCache::Get(const GraphView& view,
                                                  const std::string& graph) {
  Quad all;
  all.graph = view.Find(Iri(graph));
  if (all.graph == kNoTerm) return std::make_shared<const ShapeGraph>();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (shapes_ != nullptr && HoldsFor(view, all)) return shapes_;
  const auto loaded =
      std::make_shared<const ShapeGraph>(LoadShapes(view, graph));
  statements_.clear();
  view.Match(all, [&](const Quad& quad) {
    statements_.push_back({view.Get(quad.subject),
                           view.Get(quad.predicate),
                           view.Get(quad.object),
                           {}});
    return true;
  });
  shapes_ = loaded;
  return shapes_;
}

}  // namespace kg_core::shacl
