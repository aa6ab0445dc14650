// A copy-on-write raster. The time steps of a file are used by the fields of
// many windows and by the file cache; they are stored once.

#ifndef KG_BASE_RASTER_SHARED_RASTER_H_
#define KG_BASE_RASTER_SHARED_RASTER_H_

#include <cstddef>
#include <memory>
#include <utility>

#include "kg_base/raster/grid.h"

namespace kg_base {

// Can be read like a Raster, from any thread while there is no writer.
class SharedRaster {
 public:
  SharedRaster() : SharedRaster(Raster()) {}
  SharedRaster(Raster values)  // Implicit; initially unshared.
      : SharedRaster(std::make_shared<Raster>(std::move(values))) {}
  // Shares a raster owned elsewhere, which is never written to here.
  explicit SharedRaster(std::shared_ptr<const Raster> values)
      : values_(std::move(values)), data_(values_->data()) {}

  const Raster& values() const { return *values_; }
  operator const Raster&() const { return *values_; }

  std::size_t size() const { return values_->size(); }
  const float* data() const { return data_; }
  float operator[](std::size_t i) const { return data_[i]; }
  const float* begin() const { return data_; }
  const float* end() const { return data_ + size(); }

  // Write access: copies the data first if they are shared.
  float& operator[](std::size_t i) { return Own()[i]; }
  float* begin() { return Own(); }
  float* end() { return Own() + size(); }

 private:
  explicit SharedRaster(const std::shared_ptr<Raster>& own)
      : values_(own), own_(own.get()), data_(own->data()) {}

  float* Own() {
    if (own_ == nullptr || values_.use_count() > 1) {
      *this = SharedRaster(Raster(*values_));
    }
    return own_->data();
  }

  std::shared_ptr<const Raster> values_;
  Raster* own_ = nullptr;  // *values_ if created here, else null.
  const float* data_ = nullptr;
};

inline bool operator==(const SharedRaster& a, const SharedRaster& b) {
  return a.data() == b.data() || a.values() == b.values();
}

}  // namespace kg_base

#endif  // KG_BASE_RASTER_SHARED_RASTER_H_
