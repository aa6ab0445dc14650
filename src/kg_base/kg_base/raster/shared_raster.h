// A raster that copies share until one of them is written to. The time steps of
// a file stand in many windows' fields, and in the file's own cache; they are
// held once.

#ifndef KG_BASE_RASTER_SHARED_RASTER_H_
#define KG_BASE_RASTER_SHARED_RASTER_H_

#include <cstddef>
#include <memory>
#include <utility>

#include "kg_base/raster/grid.h"

namespace kg_base {

// Reads like a Raster and, while nothing else writes to it, from any thread.
class SharedRaster {
 public:
  SharedRaster() : SharedRaster(Raster()) {}
  SharedRaster(Raster values)  // Implicit: a raster is one, unshared as yet.
      : SharedRaster(std::make_shared<Raster>(std::move(values))) {}
  // One that somebody else holds, too, and that is never written to here.
  explicit SharedRaster(std::shared_ptr<const Raster> values)
      : values_(std::move(values)), data_(values_->data()) {}

  const Raster& values() const { return *values_; }
  operator const Raster&() const { return *values_; }

  std::size_t size() const { return values_->size(); }
  const float* data() const { return data_; }
  float operator[](std::size_t i) const { return data_[i]; }
  const float* begin() const { return data_; }
  const float* end() const { return data_ + size(); }

  // For writing: takes a copy first if there are others that share it.
  float& operator[](std::size_t i) { return Own()[i]; }
  float* begin() { return Own(); }
  float* end() { return Own() + size(); }

 private:
  explicit SharedRaster(std::shared_ptr<Raster> own)
      : values_(own), own_(own.get()), data_(own->data()) {}

  float* Own() {
    if (own_ == nullptr || values_.use_count() > 1) {
      *this = SharedRaster(Raster(*values_));
    }
    return own_->data();
  }

  std::shared_ptr<const Raster> values_;
  Raster* own_ = nullptr;  // *values_ where it was made here.
  const float* data_ = nullptr;
};

inline bool operator==(const SharedRaster& a, const SharedRaster& b) {
  return a.data() == b.data() || a.values() == b.values();
}

}  // namespace kg_base

#endif  // KG_BASE_RASTER_SHARED_RASTER_H_
