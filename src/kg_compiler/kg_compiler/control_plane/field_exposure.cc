#include "kg_compiler/control_plane/field_exposure.h"

#include <algorithm>
#include <cmath>

#include "kg_mission/mission/source_quantities.h"

namespace kg_compiler {
namespace {

constexpr double kStep_cells = 0.25;
constexpr double kStep_s = 1800.0;

double LegExposure(const kg_base::Grid& grid, const kg_base::ScalarField& field,
                   const TimedPoint& from, const TimedPoint& to) {
  const auto a = grid.Locate(from.position), b = grid.Locate(to.position);
  const double whole_s = to.time_s - from.time_s;
  if (!a || !b || !(whole_s > 0.0)) return 0.0;
  const double cells = std::hypot(b->row - a->row, b->col - a->col);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::max(
                                    cells / kStep_cells, whole_s / kStep_s))));
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double share = (i + 0.5) / steps;
    const kg_base::GridPoint at{a->row + share * (b->row - a->row),
                                a->col + share * (b->col - a->col)};
    sum += field.Sample(grid, at, from.time_s + share * whole_s);
  }
  return sum * whole_s / steps;
}

// Integral until the arrival; the rest of the track is station keeping.
double Exposure(const kg_base::Grid& grid, const kg_base::ScalarField& field,
                const FlownPath& flight) {
  const std::vector<TimedPoint>& track = flight.track;
  double sum = 0.0;
  for (std::size_t i = 1; i < track.size(); ++i) {
    const bool rests =
        i + 1 == track.size() && track[i].position == track[i - 1].position;
    if (!rests) sum += LegExposure(grid, field, track[i - 1], track[i]);
  }
  return sum;
}

}  // namespace

std::vector<double> FieldExposures(const kg_base::VectorField& field,
                                   const FlownPath& flight) {
  std::vector<double> exposures;
  if (field.scalars.empty()) return exposures;
  for (const kg_mission::SourceQuantity& quantity :
       kg_mission::CostQuantities()) {
    exposures.push_back(0.0);
    for (const kg_base::ScalarField& scalar : field.scalars) {
      if (scalar.quantity != quantity.name) continue;
      exposures.back() += Exposure(field.grid, scalar, flight);
    }
  }
  return exposures;
}

}  // namespace kg_compiler
