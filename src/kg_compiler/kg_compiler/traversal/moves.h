// Moves from cell centre to cell centre, as a search tries them by the
// thousand: what LegFlyer would do, with everything that does not change worked
// out beforehand (the cells touched, the bilinear weights of the samples).

#ifndef KG_COMPILER_TRAVERSAL_MOVES_H_
#define KG_COMPILER_TRAVERSAL_MOVES_H_

#include <optional>
#include <vector>

#include "kg_compiler/traversal/leg.h"
#include "kg_compiler/traversal/traversal.h"
#include "kg_core/geo/geodesy.h"

namespace kg_compiler {

// A step to a neighbour, in cells.
struct Move {
  int rows = 0;
  int cols = 0;
  // Offsets of all cells that the segment touches, both beside a corner, but
  // for the one it starts in.
  std::vector<kg_core::Cell> touched;
  // Where the current is sampled: in the middle of equal parts, each no longer
  // than a cell. The south-west centre of four and the shares of the others.
  struct Sample {
    kg_core::Cell corner;
    double north = 0.0;
    double east = 0.0;
  };
  std::vector<Sample> samples;
};

// Coprime steps up to (2, 1) for 16 neighbours, up to (3, 2) for 32.
std::vector<Move> NeighbourMoves(int neighbours);

class Mover {
 public:
  explicit Mover(const Voyage& voyage);

  // Arrival of a move from `from` [s after the departure's time], as
  // `depart_s`; nothing if it cannot be made (kSearch's slack) in time.
  std::optional<double> Arrival(const Move& move, kg_core::Cell from,
                                double depart_s) const;
  bool MayEnter(kg_core::Cell cell) const;  // On the grid, open, known.

 private:
  struct Course {
    double length_m, east, north;  // East and north: of the unit vector.
  };
  Course CourseOf(const Move& move, kg_core::Cell from) const;
  // boost_gain current; no data counts as no flow.
  kg_core::Velocity Current(const Move::Sample& sample, kg_core::Cell from,
                            double time_s) const;

  const kg_core::VectorField& field_;
  const kg_core::Mask& open_;
  double speed_mps_;
  double boost_gain_;
  double latest_s_;
  std::vector<double> slice_s_;                  // After the departure's time.
  std::vector<kg_core::DegreesPerMetre> scale_;  // By row.
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_MOVES_H_
