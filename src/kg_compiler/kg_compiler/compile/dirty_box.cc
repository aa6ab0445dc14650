#include "kg_compiler/compile/dirty_box.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/data_plane.h"

namespace kg_compiler {
namespace {

// Hash of all inputs except the constraints.
std::string HashOfTheRest(const TensorInputs& origin) {
  kg_mission::Mission bare;
  bare.windows = origin.mission->windows;
  bare.priors = origin.mission->priors;
  bare.events = origin.mission->events;
  bare.files = origin.mission->files;
  return TensorHash(bare, *origin.agent, *origin.window, *origin.rasters,
                    origin.horizon);
}

bool Same(const ActiveConstraint& a, const ActiveConstraint& b) {
  const kg_mission::Constraint& x = *a.fact;
  const kg_mission::Constraint& y = *b.fact;
  if (a.forbids() != b.forbids() || a.effect->cover != b.effect->cover ||
      (!a.forbids() && a.attenuation != b.attenuation) ||
      x.is_land != y.is_land || x.buffer_cells != y.buffer_cells ||
      x.buffer_metric != y.buffer_metric) {
    return false;
  }
  if (x.mask || y.mask) return false;
  if (x.area.has_value() != y.area.has_value()) return false;
  return !x.area || x.area->Wkt() == y.area->Wkt();
}

// Constraints of `list` that are not in `other`.
std::vector<const ActiveConstraint*> Without(
    const std::vector<ActiveConstraint>& list,
    const std::vector<ActiveConstraint>& other) {
  std::vector<const ActiveConstraint*> left;
  for (const ActiveConstraint& one : list) {
    if (std::none_of(
            other.begin(), other.end(),
            [&](const ActiveConstraint& two) { return Same(one, two); })) {
      left.push_back(&one);
    }
  }
  return left;
}

// Constraints of `list` that are not in `changed`, in order of multiplication.
std::vector<const ActiveConstraint*> Kept(
    const std::vector<ActiveConstraint>& list,
    const std::vector<const ActiveConstraint*>& changed) {
  std::vector<const ActiveConstraint*> kept;
  for (const ActiveConstraint& one : list) {
    if (std::find(changed.begin(), changed.end(), &one) == changed.end()) {
      kept.push_back(&one);
    }
  }
  return kept;
}

// Cells [first, last) of an axis that an interval touches, plus one on either
// side.
std::pair<int, int> CellsOf(const std::vector<double>& centres, double low,
                            double high) {
  const auto first = std::lower_bound(centres.begin(), centres.end(), low);
  const auto last = std::upper_bound(first, centres.end(), high);
  return {static_cast<int>(first - centres.begin()) - 1,
          static_cast<int>(last - centres.begin()) + 1};
}

std::optional<CellBox> BoxOf(const kg_mission::Constraint& constraint,
                             const kg_base::Grid& grid) {
  if (!constraint.area) return std::nullopt;
  const kg_base::Geometry& area = *constraint.area;
  const auto [row, row_end] =
      CellsOf(grid.lat_deg(), area.south_deg(), area.north_deg());
  const auto [col, col_end] =
      CellsOf(grid.lon_deg(), area.west_deg(), area.east_deg());
  const int buffer = static_cast<int>(std::ceil(constraint.buffer_cells));
  return Grown({row, row_end, col, col_end}, buffer, buffer, grid);
}

}  // namespace

std::optional<CellBox> DirtyBox(const TensorInputs& before,
                                const TensorInputs& after) {
  if (HashOfTheRest(before) != HashOfTheRest(after)) return std::nullopt;
  const ActiveFacts was =
      FindActiveFacts(*before.mission, *before.agent, *before.window);
  const ActiveFacts is =
      FindActiveFacts(*after.mission, *after.agent, *after.window);
  // No box if the unchanged constraints differ in order: products may then
  // round differently in any cell.
  const auto gone = Without(was.constraints, is.constraints);
  const auto come = Without(is.constraints, was.constraints);
  const auto stayed = Kept(was.constraints, gone);
  const auto stay = Kept(is.constraints, come);
  if (gone.empty() && come.empty()) return std::nullopt;
  if (!std::equal(stayed.begin(), stayed.end(), stay.begin(), stay.end(),
                  [](const auto* a, const auto* b) { return Same(*a, *b); })) {
    return std::nullopt;
  }
  CellBox all;
  for (const auto* list : {&gone, &come}) {
    for (const ActiveConstraint* constraint : *list) {
      const auto box = BoxOf(*constraint->fact, after.rasters->grid);
      if (!box) return std::nullopt;
      all = Join(all, *box);
    }
  }
  return all;
}

}  // namespace kg_compiler
