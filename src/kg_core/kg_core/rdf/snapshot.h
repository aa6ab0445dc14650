// One committed state of a store, and the reader's view of it.

#ifndef KG_CORE_RDF_SNAPSHOT_H_
#define KG_CORE_RDF_SNAPSHOT_H_

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "kg_core/rdf/dictionary.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/quad_index.h"

namespace kg_core {

// Immutable once published.
struct StoreVersion {
  QuadIndex index;
  std::shared_ptr<const Dictionary> dictionary;
  TermId terms_end = 1;  // dictionary->next_id() at publication.
  std::uint64_t world_version = 0;
};

class Snapshot : public GraphView {
 public:
  explicit Snapshot(std::shared_ptr<const StoreVersion> version)
      : version_(std::move(version)) {}

  const StoreVersion& version() const { return *version_; }

  TermId Find(const Term& term) const override {
    return version_->dictionary->Find(term, version_->terms_end);
  }
  const Term& Get(TermId id) const override {
    return version_->dictionary->Get(id);
  }
  void Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const override {
    version_->index.Match(pattern, visit);
  }
  std::size_t Estimate(const Quad& pattern) const override {
    return version_->index.Estimate(pattern);
  }
  std::vector<TermId> Graphs() const override {
    return version_->index.Graphs();
  }
  std::uint64_t world_version() const override {
    return version_->world_version;
  }

 private:
  const std::shared_ptr<const StoreVersion> version_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_SNAPSHOT_H_
