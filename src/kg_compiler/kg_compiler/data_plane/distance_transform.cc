#include "kg_compiler/data_plane/distance_transform.h"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Centres' positions along the meridian [m from the first].
std::vector<double> Northings_m(const kg_core::Grid& grid) {
  std::vector<double> north_m(1, 0.0);
  const std::vector<double>& lat_deg = grid.lat_deg();
  for (std::size_t r = 1; r < lat_deg.size(); ++r) {
    const double middle_deg = 0.5 * (lat_deg[r] + lat_deg[r - 1]);
    north_m.push_back(north_m.back() +
                      (lat_deg[r] - lat_deg[r - 1]) /
                          kg_core::LocalScale(middle_deg).lat_deg);
  }
  return north_m;
}

// Squared distances along one row to the row's own cells of the set.
void AlongRow(const kg_core::Grid& grid, const kg_core::Mask& set, int row,
              double* squared) {
  const double m_per_deg =
      1.0 / kg_core::LocalScale(grid.lat_deg()[row]).lon_deg;
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
class Envelope {
 public:
  explicit Envelope(const std::vector<double>& y) : y_(y) {}

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
  std::vector<double> begins_;  // Where each member becomes the lowest.
};

}  // namespace

kg_core::Mask GrowByCells(const kg_core::Grid& grid, const kg_core::Mask& set,
                          double cells) {
  if (!(cells > 0.0)) return set;
  kg_core::Mask outside(set.size());
  bool empty = true;
  for (std::size_t i = 0; i < set.size(); ++i) {
    outside[i] = set[i] ? 0 : 1;
    empty = empty && !set[i];
  }
  if (empty) return set;
  const cv::Mat from(grid.rows(), grid.cols(), CV_8U, outside.data());
  cv::Mat distance;
  cv::distanceTransform(from, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  kg_core::Mask grown(set.size());
  const float* d = distance.ptr<float>();
  for (std::size_t i = 0; i < grown.size(); ++i) grown[i] = d[i] <= cells;
  return grown;
}

std::vector<double> DistanceTo_m(const kg_core::Grid& grid,
                                 const kg_core::Mask& set) {
  std::vector<double> distance(grid.size());
  for (int r = 0; r < grid.rows(); ++r) {
    AlongRow(grid, set, r, &distance[grid.Index({r, 0})]);
  }
  const std::vector<double> north_m = Northings_m(grid);
  std::vector<double> column(north_m.size());
  std::vector<double> result(north_m.size());
  Envelope envelope(north_m);
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
