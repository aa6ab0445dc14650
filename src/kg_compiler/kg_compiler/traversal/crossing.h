// The fastest flight of one voyage to one place: candidate courses found by
// shooting, then integrated (flown).

#ifndef KG_COMPILER_TRAVERSAL_CROSSING_H_
#define KG_COMPILER_TRAVERSAL_CROSSING_H_

#include <optional>
#include <vector>

#include "kg_compiler/traversal/shooting.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

class FastestCrossing {
 public:
  // `reach` belongs to the voyage or to one at about its speed. All references
  // must outlive this object. `at` is `to` in cell units.
  FastestCrossing(const VoyageRequest& voyage, const ReachMap& reach,
                  kg_base::LonLat to, kg_base::GridPoint at);

  // Fastest flight found; never slower than the straight leg.
  std::optional<FlownPath> Fastest() const { return Best(true); }
  // First flight found; for a reach at another speed, whose arrival times
  // cannot be used to judge the result.
  std::optional<FlownPath> First() const { return Best(false); }

 private:
  std::optional<FlownPath> Best(bool as_expected) const;
  std::optional<FlownPath> Fly(const std::vector<kg_base::LonLat>& via) const;
  std::optional<FlownPath> Fly(const TimedCourse& course) const;
  std::vector<ExtremalShooter::Guess> Guesses() const;
  bool IsExpected(double travel_s, const ExtremalShooter::Guess& guess) const;
  std::vector<kg_base::LonLat> Corners(int root) const;
  std::optional<FlownPath> Shoot(const ExtremalShooter& shooter,
                                 const ExtremalShooter::Guess& guess,
                                 std::vector<double>* refused_s) const;

  const VoyageRequest& voyage_;
  const ReachMap& reach_;
  const kg_base::Grid& grid_;
  CellBox inside_;  // Flights inside read only cells the reach has read.
  kg_base::LonLat to_;
  kg_base::GridPoint at_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_CROSSING_H_
