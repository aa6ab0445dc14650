#include "kg_base/raster/axis.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace kg_base {
namespace {

// With even spacing a bucket is an interval, and its guess is right except for
// float noise at the edges; with uneven spacing finer buckets make wrong
// guesses, which cost one step, rare.
constexpr double kEvenSpacing = 1.01;
constexpr double kBucketsPerInterval = 4.0;

void CheckAscending(const std::vector<double>& centres) {
  if (centres.size() < 2) {
    throw std::logic_error("an axis needs at least two centres");
  }
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const bool ascends = i == 0 || centres[i] > centres[i - 1];
    if (!ascends || !std::isfinite(centres[i])) {
      throw std::logic_error("an axis must ascend strictly, entry " +
                             std::to_string(i) + " does not");
    }
  }
}

}  // namespace

Axis::Axis(std::vector<double> centres) : centres_(std::move(centres)) {
  CheckAscending(centres_);
  inverse_width_.reserve(centres_.size() - 1);
  for (std::size_t i = 0; i + 1 < centres_.size(); ++i) {
    inverse_width_.push_back(1.0 / (centres_[i + 1] - centres_[i]));
  }
  BuildBuckets();
  low_ = Edge(0);
  high_ = Edge(static_cast<int>(centres_.size()));
}

void Axis::BuildBuckets() {
  const int last = static_cast<int>(inverse_width_.size()) - 1;
  const double range = centres_.back() - centres_.front();
  const double finest =
      *std::max_element(inverse_width_.begin(), inverse_width_.end());
  const bool even = range * finest <= (last + 1) * kEvenSpacing;
  const double buckets = (last + 1) * (even ? 1.0 : kBucketsPerInterval);
  buckets_per_unit_ = buckets / range;
  interval_guess_.resize(static_cast<std::size_t>(buckets));
  int interval = 0;
  for (std::size_t b = 0; b < interval_guess_.size(); ++b) {
    const double middle =
        centres_.front() + (static_cast<double>(b) + 0.5) / buckets_per_unit_;
    while (interval < last && middle >= centres_[interval + 1]) ++interval;
    interval_guess_[b] = interval;
  }
}

double Axis::At(double cell) const {
  const double last = static_cast<double>(inverse_width_.size() - 1);
  const double floor = std::floor(cell);
  // Comparison ordered such that NaN gives interval 0 and a NaN result.
  const double interval = floor > 0.0 ? std::min(floor, last) : 0.0;
  const std::size_t i = static_cast<std::size_t>(interval);
  return centres_[i] + (cell - interval) * (centres_[i + 1] - centres_[i]);
}

}  // namespace kg_base
