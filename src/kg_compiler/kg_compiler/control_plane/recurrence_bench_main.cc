// Target 4: Proximal Recurrence against a direct OpenCV implementation, 20
// picks (filter2D, minMaxLoc, zero the disc), in one process and on one thread.
// The picks of both are compared, and with sums of doubles cell by cell.

#include <cstring>
#include <random>

#include "kg_base/common/testing/bench_report.h"
#include "kg_compiler/control_plane/disc.h"
#include "kg_compiler/control_plane/proximal_recurrence.h"
#include "kg_compiler/testing/test_world.h"
#include "opencv2/imgproc.hpp"

namespace kg_compiler {
namespace {

using kg_base::Median;
using kg_base::Report;
using kg_base::Seconds;

constexpr int kPicks = 20;
constexpr double kCell_m = 100.0;

// Square cells at the equator, so that a disc of r cells is one kernel.
kg_base::Grid SquareCells(int rows, int cols) {
  const double lat_step = kCell_m / MeridianArc_m(1.0);
  const double lon_step = kCell_m / kg_base::DegToRad(1.0) / 6378137.0;
  return {EvenAxis(-0.5 * cols * lon_step, lon_step, cols),
          EvenAxis(-0.5 * rows * lat_step, lat_step, rows)};
}

// Random hills and noise; the western fifth of the columns is 0.
kg_base::Raster Utility(const kg_base::Grid& grid) {
  std::mt19937 rng(4);
  kg_base::Raster utility = RandomRaster(rng, grid.size(), 0.0, 0.3);
  for (int hill = 0; hill < 40; ++hill) {
    const double row = Uniform(rng, 0, grid.rows());
    const double col = Uniform(rng, 0, grid.cols());
    const double size = Uniform(rng, 10, 40), height = Uniform(rng, 0.1, 0.7);
    for (int r = 0; r < grid.rows(); ++r) {
      for (int c = 0; c < grid.cols(); ++c) {
        const double d = std::hypot(r - row, c - col) / size;
        if (d > 4.0) continue;
        utility[grid.Index({r, c})] +=
            static_cast<float>(height * std::exp(-d * d));
      }
    }
  }
  // Cells without value, as on land.
  for (std::size_t i = 0; i < utility.size(); ++i) {
    if (static_cast<int>(i) % grid.cols() < grid.cols() / 5) utility[i] = 0.0f;
  }
  return utility;
}

// Calls `of` with the cells of a grid within a radius [cells] of a cell.
template <typename Of>
void ForDisc(const kg_base::Grid& grid, kg_base::Cell at, int radius,
             const Of& of) {
  for (int r = -radius; r <= radius; ++r) {
    for (int c = -radius; c <= radius; ++c) {
      const kg_base::Cell cell{at.row + r, at.col + c};
      if (r * r + c * c <= radius * radius && grid.Contains(cell)) {
        of(grid.Index(cell));
      }
    }
  }
}

cv::Mat Kernel(int radius) {
  cv::Mat kernel = cv::Mat::zeros(2 * radius + 1, 2 * radius + 1, CV_32F);
  for (int r = -radius; r <= radius; ++r) {
    for (int c = -radius; c <= radius; ++c) {
      const bool inside = r * r + c * c <= radius * radius;
      kernel.at<float>(r + radius, c + radius) = inside ? 1.0f : 0.0f;
    }
  }
  return kernel;
}

using Cells = std::vector<kg_base::Cell>;

Cells OpenCvPicks(const kg_base::Grid& grid, kg_base::Raster utility,
                  int radius) {
  const cv::Mat left(grid.rows(), grid.cols(), CV_32F, utility.data());
  kg_base::Mask allowed(grid.size(), 1);
  const cv::Mat mask(grid.rows(), grid.cols(), CV_8U, allowed.data());
  const cv::Mat kernel = Kernel(radius);
  Cells picks;
  cv::Mat response;
  while (static_cast<int>(picks.size()) < kPicks) {
    cv::filter2D(left, response, -1, kernel, cv::Point(-1, -1), 0,
                 cv::BORDER_CONSTANT);
    cv::Point best;
    cv::minMaxLoc(response, nullptr, nullptr, nullptr, &best, mask);
    picks.push_back({best.y, best.x});
    ForDisc(grid, picks.back(), radius,
            [&](std::size_t i) { utility[i] = 0.0f, allowed[i] = 0; });
  }
  return picks;
}

// Reference: every disc summed from scratch for every pick, in doubles.
Cells PlainPicks(const kg_base::Grid& grid, kg_base::Raster utility,
                 int radius) {
  kg_base::Mask allowed(grid.size(), 1);
  Cells picks;
  while (static_cast<int>(picks.size()) < kPicks) {
    // Exhaustive search; strict comparison, so ties go to the first cell.
    double most = 0.0;
    kg_base::Cell best;
    for (int r = 0; r < grid.rows(); ++r) {
      for (int c = 0; c < grid.cols(); ++c) {
        if (!allowed[grid.Index({r, c})]) continue;
        double sum = 0.0;
        ForDisc(grid, {r, c}, radius,
                [&](std::size_t i) { sum += utility[i]; });
        if (sum > most) most = sum, best = {r, c};
      }
    }
    picks.push_back(best);
    ForDisc(grid, best, radius,
            [&](std::size_t i) { utility[i] = 0.0f, allowed[i] = 0; });
  }
  return picks;
}

int Same(const std::vector<RecurrencePick>& picks, const Cells& others) {
  int same = 0;
  for (std::size_t i = 0; i < std::min(picks.size(), others.size()); ++i) {
    same += picks[i].cell == others[i];
  }
  return same;
}

class Case {
 public:
  Case(int rows, int cols)
      : grid_(SquareCells(rows, cols)), utility_(Utility(grid_)) {}

  // Returns the ratio of the times; prints the times and the number of equal
  // picks.
  double Run(int radius, int rounds) const {
    std::vector<RecurrencePick> ours;
    Cells theirs;
    std::vector<double> our_s, their_s, ratios;
    for (int i = 0; i < rounds; ++i) {
      our_s.push_back(Seconds([&] { ours = Picks(radius); }));
      their_s.push_back(
          Seconds([&] { theirs = OpenCvPicks(grid_, utility_, radius); }));
      ratios.push_back(their_s.back() / our_s.back());
    }
    std::printf(
        "PR %dx%d r=%-2d  %9.3f ms, OpenCV %9.2f ms, ratio %6.1f, "
        "same picks %d of %d\n",
        grid_.cols(), grid_.rows(), radius, 1e3 * Median(our_s),
        1e3 * Median(their_s), Median(ratios), Same(ours, theirs), kPicks);
    std::fflush(stdout);
    return Median(ratios);
  }
  bool PicksArePlain(int radius) const {
    const int same = Same(Picks(radius), PlainPicks(grid_, utility_, radius));
    std::printf(
        "PR %dx%d r=%-2d  same picks as plain sums of doubles: %d of "
        "%d\n",
        grid_.cols(), grid_.rows(), radius, same, kPicks);
    return same == kPicks;
  }
  // Only a box of cells allowed, as within an agent's reach.
  void RunBox(int radius, int side) const {
    kg_base::Mask allowed(grid_.size(), 0);
    for (int r = 0; r < side; ++r) {
      const kg_base::Cell west{grid_.rows() / 2 + r, grid_.cols() / 2};
      std::fill_n(&allowed[grid_.Index(west)], side, 1);
    }
    std::vector<double> our_s;
    for (int i = 0; i < 15; ++i) {
      our_s.push_back(Seconds([&] {
        ProximalRecurrence(grid_, utility_, allowed, Options(radius));
      }));
    }
    std::printf("PR %dx%d r=%-2d  %9.3f ms where %dx%d cells are allowed\n",
                grid_.cols(), grid_.rows(), radius, 1e3 * Median(our_s), side,
                side);
  }

 private:
  // Radius slightly above r cells, so that rounding excludes no cell.
  static RecurrenceOptions Options(int radius) {
    const double radius_m = radius * kCell_m * 1.0002;
    return {radius_m, radius_m, kPicks};
  }
  std::vector<RecurrencePick> Picks(int radius) const {
    return ProximalRecurrence(grid_, utility_, kg_base::Mask(grid_.size(), 1),
                              Options(radius));
  }

  kg_base::Grid grid_;
  kg_base::Raster utility_;
};

void ReportTarget(const char* size, double ratio) {
  Report({4, std::string("PR against 20 x filter2D, r=10, ") + size, 25.0, true,
          "x"},
         ratio);
}

void Quick() {
  const Case small(97, 135);
  small.PicksArePlain(5);
  const Case gulf(385, 541);
  ReportTarget("541x385", gulf.Run(10, 3));
}

void Full() {
  const Case gulf(385, 541);
  gulf.PicksArePlain(10);
  gulf.PicksArePlain(3);
  for (const int radius : {3, 5, 25}) gulf.Run(radius, 11);
  gulf.RunBox(10, 13);
  ReportTarget("541x385", gulf.Run(10, 11));
  const Case atlantic(3298, 4500);
  for (const int radius : {3, 5, 25}) atlantic.Run(radius, 1);
  atlantic.RunBox(10, 13);
  ReportTarget("4500x3298", atlantic.Run(10, 3));
}

}  // namespace
}  // namespace kg_compiler

int main(int argc, char** argv) {
  cv::setNumThreads(1);  // Same number of threads as ours.
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  quick ? kg_compiler::Quick() : kg_compiler::Full();
}
