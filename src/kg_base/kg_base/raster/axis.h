// One axis of a grid: ascending cell centres with arbitrary spacing, and the
// conversion between coordinates and cell units (piecewise linear between
// centres, extrapolated with the outer spacing beyond the outer centres).
//
// Locate is in the inner loop of path search: a table of equal buckets across
// the axis gives the first guess of the interval, so that even spacing (the
// usual case, including float32 noise) and Mercator rows cost the same few
// nanoseconds; the result equals that of a search in the centres.

#ifndef KG_BASE_RASTER_AXIS_H_
#define KG_BASE_RASTER_AXIS_H_

#include <optional>
#include <vector>

namespace kg_base {

// The whole number at or below a position in cell units, held within [0, last];
// 0 for NaN. Defined for every double, as the conversion to int alone is not.
inline int HeldFloor(double cell, int last) {
  if (!(cell > 0.0)) return 0;
  return cell < last ? static_cast<int>(cell) : last;
}

class Axis {
 public:
  Axis() = default;
  // Strictly ascending, finite, at least two; throws std::logic_error if not.
  explicit Axis(std::vector<double> centres);

  const std::vector<double>& centres() const { return centres_; }
  // Outer edges, half a cell beyond the outermost centres.
  double low() const { return low_; }
  double high() const { return high_; }

  // Cell units of a coordinate in [low, high]; nullopt elsewhere or for NaN.
  std::optional<double> Locate(double coordinate) const {
    if (!(coordinate >= low_ && coordinate <= high_)) return std::nullopt;
    const int i = Interval(coordinate);
    return i + (coordinate - centres_[i]) * inverse_width_[i];
  }

  double At(double cell) const;  // The inverse of Locate, for any finite cell.
  // Coordinate units per cell step: mean over half a cell on either side.
  double Spacing(double cell) const { return At(cell + 0.5) - At(cell - 0.5); }
  // The edge between cells i - 1 and i, for i in [0, size]: half way between
  // their centres.
  double Edge(int i) const { return At(i - 0.5); }

 private:
  // The interval [centre i, centre i + 1) that contains the coordinate; the
  // first or the last one beyond the outer centres.
  int Interval(double coordinate) const {
    const int last = static_cast<int>(inverse_width_.size()) - 1;
    const double bucket = (coordinate - centres_[0]) * buckets_per_unit_;
    int i = bucket > 0.0 ? interval_guess_[BucketIndex(bucket)] : 0;
    while (i > 0 && coordinate < centres_[i]) --i;
    while (i < last && coordinate >= centres_[i + 1]) ++i;
    return i;
  }
  int BucketIndex(double bucket) const {
    const int last = static_cast<int>(interval_guess_.size()) - 1;
    const int index = static_cast<int>(bucket);
    return index < last ? index : last;
  }
  void BuildBuckets();

  std::vector<double> centres_;
  std::vector<double> inverse_width_;  // 1 / width of each interval.
  std::vector<int> interval_guess_;    // Interval at each bucket's middle.
  double buckets_per_unit_ = 0.0;
  double low_ = 0.0;
  double high_ = -1.0;  // An empty axis holds no coordinate.
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_AXIS_H_
