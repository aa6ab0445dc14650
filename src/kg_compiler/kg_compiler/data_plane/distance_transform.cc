#include "kg_compiler/data_plane/distance_transform.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "kg_base/common/units.h"
#include "kg_base/geo/geodesy.h"

namespace kg_compiler {
namespace {

using kg_base::kInfinity;

// Positions of the row centres along the meridian [m], relative to the first.
std::vector<double> Northings_m(const kg_base::Grid& grid) {
  std::vector<double> north_m(1, 0.0);
  const std::vector<double>& lat_deg = grid.lat_deg();
  for (std::size_t r = 1; r < lat_deg.size(); ++r) {
    const double middle_deg = 0.5 * (lat_deg[r] + lat_deg[r - 1]);
    north_m.push_back(north_m.back() +
                      (lat_deg[r] - lat_deg[r - 1]) /
                          kg_base::LocalScale(middle_deg).lat_deg);
  }
  return north_m;
}

// Squared distances along one row to the row's own cells of the set.
void AlongRow(const kg_base::Grid& grid, const kg_base::Mask& set, int row,
              double* squared) {
  const double m_per_deg =
      1.0 / kg_base::LocalScale(grid.lat_deg()[row]).lon_deg;
  const std::vector<double>& lon_deg = grid.lon_deg();
  const std::size_t first = grid.Index({row, 0});
  double last_deg = -kInfinity;
  for (int c = 0; c < grid.cols(); ++c) {
    if (set[first + c]) last_deg = lon_deg[c];
    squared[c] = lon_deg[c] - last_deg;
  }
  double next_deg = kInfinity;
  for (int c = grid.cols() - 1; c >= 0; --c) {
    if (set[first + c]) next_deg = lon_deg[c];
    const double d_m = std::min(squared[c], next_deg - lon_deg[c]) * m_per_deg;
    squared[c] = d_m * d_m;
  }
}

// The lower envelope of the parabolas (y - y_i)^2 + f_i, i with finite f_i.
class LowerEnvelope {
 public:
  explicit LowerEnvelope(const std::vector<double>& y) : y_(y) {}

  void Build(const std::vector<double>& f) {
    members_.clear();
    begins_.clear();
    for (int i = 0; i < static_cast<int>(f.size()); ++i) {
      if (f[i] < kInfinity) Add(f, i);
    }
  }
  void Evaluate(const std::vector<double>& f, std::vector<double>* out) const {
    std::size_t k = 0;
    for (std::size_t i = 0; i < y_.size(); ++i) {
      if (members_.empty()) {
        (*out)[i] = kInfinity;
        continue;
      }
      while (k + 1 < members_.size() && begins_[k + 1] <= y_[i]) ++k;
      const double d = y_[i] - y_[members_[k]];
      (*out)[i] = d * d + f[members_[k]];
    }
  }

 private:
  void Add(const std::vector<double>& f, int i) {
    // Pop members that the new parabola undercuts before their interval begins:
    // they are never the lowest.
    double begin = -kInfinity;
    while (!members_.empty()) {
      const int j = members_.back();
      begin = ((f[i] + y_[i] * y_[i]) - (f[j] + y_[j] * y_[j])) /
              (2.0 * (y_[i] - y_[j]));
      if (begin > begins_.back()) break;
      members_.pop_back();
      begins_.pop_back();
      begin = -kInfinity;
    }
    members_.push_back(i);
    begins_.push_back(begin);
  }

  const std::vector<double>& y_;
  std::vector<int> members_;
  std::vector<double> begins_;  // Begin of each member's interval.
};

kg_base::Mask GrowRound(int rows, int cols, const kg_base::Mask& set,
                        double cells) {
  kg_base::Mask outside(set.size());
  for (std::size_t i = 0; i < set.size(); ++i) outside[i] = set[i] ? 0 : 1;
  const cv::Mat from(rows, cols, CV_8U, outside.data());
  cv::Mat distance;
  cv::distanceTransform(from, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  kg_base::Mask grown(set.size());
  const float* d = distance.ptr<float>();
  for (std::size_t i = 0; i < grown.size(); ++i) grown[i] = d[i] <= cells;
  return grown;
}

// out[i] = 1 if one of in[i - reach .. i + reach] is set; every `step`-th
// entry.
void GrowLine(const unsigned char* in, int size, int step, int reach,
              unsigned char* out) {
  int last = -reach - 1;  // Index of the last set entry so far.
  for (int i = 0; i < size + reach; ++i) {
    if (i < size && in[static_cast<std::ptrdiff_t>(i) * step]) last = i;
    const int at = i - reach;
    if (at >= 0 && last >= at - reach) {
      out[static_cast<std::ptrdiff_t>(at) * step] = 1;
    }
  }
}

kg_base::Mask GrowSquare(int rows, int cols, const kg_base::Mask& set,
                         double cells) {
  const int reach =
      static_cast<int>(std::min<double>(std::floor(cells), rows + cols));
  kg_base::Mask along(set.size(), 0), grown(set.size(), 0);
  for (int r = 0; r < rows; ++r) {
    const std::size_t first = static_cast<std::size_t>(r) * cols;
    GrowLine(&set[first], cols, 1, reach, &along[first]);
  }
  for (int c = 0; c < cols; ++c) {
    GrowLine(&along[c], rows, cols, reach, &grown[c]);
  }
  return grown;
}

}  // namespace

kg_base::Mask GrowByCells(int rows, int cols, const kg_base::Mask& set,
                          double cells, kg_mission::BufferMetric metric) {
  const bool empty =
      std::none_of(set.begin(), set.end(), [](auto cell) { return cell != 0; });
  if (!(cells > 0.0) || empty) return set;
  return metric == kg_mission::BufferMetric::kChebyshev
             ? GrowSquare(rows, cols, set, cells)
             : GrowRound(rows, cols, set, cells);
}

std::vector<double> DistanceTo_m(const kg_base::Grid& grid,
                                 const kg_base::Mask& set) {
  // Step 1: squared distances along each row, by a row's own scale. Step 2:
  // along each column the lower envelope of the parabolas that stand on them.
  std::vector<double> distance(grid.size());
  for (int r = 0; r < grid.rows(); ++r) {
    AlongRow(grid, set, r, &distance[grid.Index({r, 0})]);
  }
  const std::vector<double> north_m = Northings_m(grid);
  std::vector<double> column(north_m.size());
  std::vector<double> result(north_m.size());
  LowerEnvelope envelope(north_m);
  for (int c = 0; c < grid.cols(); ++c) {
    for (int r = 0; r < grid.rows(); ++r) {
      column[r] = distance[grid.Index({r, c})];
    }
    envelope.Build(column);
    envelope.Evaluate(column, &result);
    for (int r = 0; r < grid.rows(); ++r) {
      distance[grid.Index({r, c})] = std::sqrt(result[r]);
    }
  }
  return distance;
}

}  // namespace kg_compiler
