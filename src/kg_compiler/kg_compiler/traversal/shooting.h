// Shooting: finds the extremal through a place. When its front passes the
// place, the signed miss distance to the left is
//
//   m(theta) = n x (x(theta, T) - target) / |n|,  T: n . (x - target) = 0
//
// with the front's normal n. The root of m between two headings of the fan that
// bracket the place is found by regula falsi (Illinois variant). m is
// continuous, but not smooth where extremals cross the lines between cell
// centres, so Newton's method would not converge reliably. Solved leg by leg
// through the corners that the fan went round.
//
// M. Dowell and P. Jarratt, BIT 11(2), 1971, pp. 168-174.

#ifndef KG_COMPILER_TRAVERSAL_SHOOTING_H_
#define KG_COMPILER_TRAVERSAL_SHOOTING_H_

#include <optional>
#include <vector>

#include "kg_compiler/traversal/extremal.h"
#include "kg_compiler/traversal/reach.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

// A place on a course, in cell units and seconds after the departure.
struct CoursePoint {
  kg_base::GridPoint place;
  double time_s = 0.0;
};
using TimedCourse = std::vector<CoursePoint>;

// A subset of the points whose linear interpolation in time stays within
// `tolerance_cells` of all given points.
TimedCourse Simplify(const TimedCourse& course, double tolerance_cells);

// Result of one heading.
struct ShotAt {
  double heading_rad = 0.0;
  double duration_s = 0.0;
  double left = 0.0;  // m [cells].
};

class ExtremalShooter {
 public:
  // `voyage` and `reach` must outlive this object. Extremals have the speed
  // `speed_mps` through water.
  ExtremalShooter(const VoyageRequest& voyage, const ReachMap& reach,
                  double speed_mps);

  // Initial guess of an extremal: root, heading at the root (+- spread) and
  // arrival [s after the departure].
  struct Guess {
    int root = 0;
    double heading_rad = 0.0;
    double spread_rad = 0.0;
    double arrival_s = 0.0;
  };
  // A course from the departure to a place in steps of at most
  // `step_cells`; nothing if none is found close to the guess, or if it leaves
  // the grid by more than a few cells or has more than kMaxSteps steps.
  std::optional<TimedCourse> To(kg_base::GridPoint place, const Guess& guess,
                                double step_cells) const;

 private:
  struct ShotLeg {
    kg_base::GridPoint from, to;
    double begin_s;
    double heading_rad, spread_rad, duration_s;  // Guessed.
    double step_s;
  };
  // Advances an extremal and checks that it is still where the currents are
  // known: near the grid, and in the box that the reach has read.
  bool Advance(double time_s, double step_s, ExtremalState* at) const;
  std::optional<ShotAt> Fire(const ShotLeg& leg, double heading_rad) const;
  std::optional<ShotAt> Solve(const ShotLeg& leg) const;
  std::optional<ShotAt> Search(const ShotLeg& leg) const;
  std::optional<ShotAt> Between(const ShotLeg& leg, ShotAt a, ShotAt b) const;
  // Appends the extremal of `shot` to the course; false if it leaves that box.
  bool Trace(const ShotLeg& leg, const ShotAt& shot, TimedCourse* course) const;

  const ReachMap& reach_;
  FlowSampler flow_;
  ExtremalStepper helm_;
  double latest_s_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_SHOOTING_H_
