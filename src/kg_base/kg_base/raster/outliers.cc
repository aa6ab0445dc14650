#include "kg_base/raster/outliers.h"

#include <algorithm>
#include <cmath>

namespace kg_base {
namespace {

constexpr std::size_t kMaxSample = 100000;
constexpr int kMinNeighbours = 2;
constexpr double kMaxDeviations = 8.0;
// Standard deviation over median absolute deviation, for normal distributions.
constexpr double kDeviationFactor = 1.4826;

std::vector<float> TakeSample(const std::vector<Raster>& rasters) {
  std::size_t size = 0;
  for (const Raster& raster : rasters) size += raster.size();
  // An odd stride does not stay in one column of an even grid.
  const std::size_t stride = (size / kMaxSample) | 1;
  std::vector<float> sample;
  std::size_t next = 0;
  for (const Raster& raster : rasters) {
    for (; next < raster.size(); next += stride) {
      if (!std::isnan(raster[next])) sample.push_back(raster[next]);
    }
    next -= raster.size();
  }
  return sample;
}

double TakeMedian(std::vector<float>* values) {
  const auto middle = values->begin() + values->size() / 2;
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

class OutlierFinder {
 public:
  OutlierFinder(const Grid& grid, const std::vector<Raster>& rasters)
      : grid_(grid), rasters_(rasters) {
    std::vector<float> sample = TakeSample(rasters);
    if (sample.empty()) return;
    median_ = TakeMedian(&sample);
    for (float& value : sample) {
      value = static_cast<float>(std::abs(value - median_));
    }
    allowed_ = kMaxDeviations * kDeviationFactor * TakeMedian(&sample);
  }

  OutlierValues Find() const {
    OutlierValues found;
    if (!(allowed_ > 0.0)) return found;
    for (std::size_t i = 0; i < rasters_.size(); ++i) {
      for (std::size_t at = 0; at < rasters_[i].size(); ++at) {
        const float value = rasters_[i][at];
        // Negated comparison, to skip NaN as well.
        if (!(std::abs(value - median_) > allowed_)) continue;
        const int cols = grid_.cols();
        const Cell cell{static_cast<int>(at) / cols,
                        static_cast<int>(at) % cols};
        if (!IsAlone(rasters_[i], cell, value)) continue;
        if (found.count++ == 0) {
          found.raster = i;
          found.cell = cell;
          found.value = value;
        }
      }
    }
    return found;
  }

 private:
  // Is it far above or below all its neighbours? Steep currents are not.
  bool IsAlone(const Raster& raster, Cell cell, float value) const {
    int above = 0;
    int below = 0;
    int neighbours = 0;
    for (const Cell& beside :
         {Cell{cell.row - 1, cell.col}, Cell{cell.row + 1, cell.col},
          Cell{cell.row, cell.col - 1}, Cell{cell.row, cell.col + 1}}) {
      if (!grid_.Contains(beside)) continue;
      const float other = raster[grid_.Index(beside)];
      if (std::isnan(other)) continue;
      ++neighbours;
      above += value - other > allowed_;
      below += other - value > allowed_;
    }
    return neighbours >= kMinNeighbours && std::max(above, below) == neighbours;
  }

  const Grid& grid_;
  const std::vector<Raster>& rasters_;
  double median_ = 0.0;
  double allowed_ = 0.0;
};

}  // namespace

OutlierValues FindOutliers(const Grid& grid,
                           const std::vector<Raster>& rasters) {
  return OutlierFinder(grid, rasters).Find();
}

bool HasSpikes(const std::string& standard_name) {
  return standard_name == "surface_temperature";
}

}  // namespace kg_base
