// Scores on a grid of 2^-50 of the largest total, so that sums are exact in any
// order: equal paths compare equal, and ties are decided by node numbers, not
// by rounding.
//
// Adding 1.5 * 2^52 steps to a double removes all bits below one step;
// subtracting it again leaves x rounded to a multiple of the step.

#ifndef KG_PLANNER_TRELLIS_SCORE_GRID_H_
#define KG_PLANNER_TRELLIS_SCORE_GRID_H_

#include <algorithm>
#include <cmath>
#include <limits>

namespace kg_planner {

class ScoreGrid {
 public:
  // Grid for numbers and sums up to `largest_total` in absolute value.
  explicit ScoreGrid(double largest_total)
      : step_(std::ldexp(1.0, Exponent(largest_total) - 50)),
        shift_(std::ldexp(1.5, Exponent(largest_total) + 2)) {}

  double Round(double x) const { return (x + shift_) - shift_; }
  double step() const { return step_; }
  double shift() const { return shift_; }

 private:
  // Exponent of the smallest power of two >= x.
  static int Exponent(double x) {
    int exponent = 0;
    std::frexp(std::max(x, 1e-280), &exponent);
    return std::min(exponent, std::numeric_limits<double>::max_exponent - 4);
  }

  double step_;
  double shift_;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_TRELLIS_SCORE_GRID_H_
