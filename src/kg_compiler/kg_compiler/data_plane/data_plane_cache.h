// Content-addressed cache of data shared by tensors of different windows and
// agents: the rasters of areas on a grid, and the tables of value layers.
//
// Holds weak references only: entries that no tensor uses expire. Thread-safe.

#ifndef KG_COMPILER_DATA_PLANE_DATA_PLANE_CACHE_H_
#define KG_COMPILER_DATA_PLANE_DATA_PLANE_CACHE_H_

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "kg_compiler/data_plane/layer_table.h"
#include "kg_compiler/data_plane/patches.h"

namespace kg_compiler {

class DataPlaneCache {
 public:
  // The patch for this grid, land and key; calls `make` if there is none.
  // `land` is the hash of grid and land.
  template <typename Make>
  std::shared_ptr<const MaskPatch> Mask(const std::string& land,
                                        const std::string& key,
                                        const Make& make) {
    return Find(land + " " + key, &masks_, make);
  }
  template <typename Make>
  std::shared_ptr<const ValuePatch> Values(const std::string& land,
                                           const std::string& key,
                                           const Make& make) {
    return Find(land + " " + key, &values_, make);
  }
  // `content` is the hash of grid, land and value.
  template <typename Make>
  std::shared_ptr<const LayerTable> Table(const std::string& content,
                                          const Make& make) {
    return Find(content, &tables_, make);
  }

  // Number of requests that had to be computed (cache misses).
  int made() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return made_;
  }

 private:
  template <typename T>
  using Known = std::map<std::string, std::weak_ptr<const T>>;

  // Two threads may compute the same entry concurrently; the first result wins.
  template <typename T, typename Make>
  std::shared_ptr<const T> Find(const std::string& key, Known<T>* known,
                                const Make& make) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = known->find(key);
      if (found != known->end()) {
        if (std::shared_ptr<const T> value = found->second.lock()) return value;
      }
    }
    std::shared_ptr<const T> value = make();
    const std::lock_guard<std::mutex> lock(mutex_);
    ++made_;
    std::weak_ptr<const T>& entry = (*known)[key];
    if (std::shared_ptr<const T> other = entry.lock()) return other;
    entry = value;
    if (known->size() > 2 * kept_after_sweep_ + kSweepFrom) Sweep(known);
    return value;
  }

  template <typename T>
  void Sweep(Known<T>* known) {
    for (auto at = known->begin(); at != known->end();) {
      at = at->second.expired() ? known->erase(at) : std::next(at);
    }
    kept_after_sweep_ = known->size();
  }

  static constexpr std::size_t kSweepFrom = 1000;

  mutable std::mutex mutex_;
  Known<MaskPatch> masks_;
  Known<ValuePatch> values_;
  Known<LayerTable> tables_;
  std::size_t kept_after_sweep_ = 0;
  int made_ = 0;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_DATA_PLANE_CACHE_H_
