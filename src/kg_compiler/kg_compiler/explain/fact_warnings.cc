#include "kg_compiler/explain/fact_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "kg_base/common/join_strings.h"
#include "kg_base/geo/geodesy.h"
#include "kg_base/geo/wkt.h"
#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/bump.h"
#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/data_plane/patches.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_mission/mission/scope.h"

namespace kg_compiler {
namespace {

using kg_base::Grid;
using kg_base::LonLat;
using kg_core::AbbreviateIri;

// Bounds of a place or an area [deg].
struct Bounds {
  double west;
  double east;
  double south;
  double north;
};

Bounds BoundsOf(const kg_base::Geometry& area) {
  return {area.west_deg(), area.east_deg(), area.south_deg(), area.north_deg()};
}
Bounds BoundsOf(LonLat position) {
  return {position.lon_deg, position.lon_deg, position.lat_deg,
          position.lat_deg};
}

std::optional<LonLat> MiddleOf(const std::optional<kg_base::Geometry>& area) {
  if (!area) return std::nullopt;
  return LonLat{0.5 * (area->west_deg() + area->east_deg()),
                0.5 * (area->south_deg() + area->north_deg())};
}

bool Overlaps(const Grid& grid, const Bounds& bounds) {
  return bounds.west <= grid.east_deg() && bounds.east >= grid.west_deg() &&
         bounds.south <= grid.north_deg() && bounds.north >= grid.south_deg();
}

std::string OffTheGrid(const Grid& grid, const Bounds& bounds) {
  const Bounds swapped{bounds.south, bounds.north, bounds.west, bounds.east};
  return "off the grid (" + grid.Text() + ")" +
         (Overlaps(grid, swapped)
              ? "; did you mean its coordinates the other way round? "
                "Longitude comes before latitude"
              : "; check its coordinates, longitude before latitude");
}

// Cells that a fact covers, in the windows looked at so far.
struct Coverage {
  bool is_in_scope = false;  // Does it apply in any of these windows?
  bool meets_land = false;
  bool meets_open = false;

  // `row(r)[c - box.col]` is the fact's value in cell (r, c).
  template <typename Row>
  void Add(const WindowRasters& rasters, const CellBox& box, const Row& row) {
    for (int r = box.row; r < box.row_end && !meets_open; ++r) {
      for (int c = box.col; c < box.col_end; ++c) {
        const auto value = row(r)[c - box.col];
        if (std::isnan(static_cast<double>(value)) || value == 0) continue;
        (rasters.land[rasters.grid.Index({r, c})] ? meets_land : meets_open) =
            true;
      }
    }
  }
};

// Effect of a constraint on the agents that it restricts most.
ActiveConstraint Strictest(const kg_mission::Mission& mission,
                           const kg_mission::Constraint& constraint) {
  ActiveConstraint active;
  active.fact = &constraint;
  active.effect = &kg_mission::EffectOf(constraint.kind);
  for (const kg_mission::Agent& agent : mission.agents) {
    if (agent.must_avoid.count(constraint.iri) == 0) continue;
    active.effect = &kg_mission::EffectOf(active.effect->when_avoided);
    break;
  }
  return active;
}

class WarningFinder {
 public:
  explicit WarningFinder(const Compilation& compilation)
      : in_(compilation), windows_(compilation.fields.size()) {}

  std::vector<FactWarning> All() {
    if (in_.rasters.empty()) return {};
    for (const auto& constraint : in_.mission.constraints) Check(constraint);
    for (const auto& prior : in_.mission.priors) Check(prior);
    for (const auto& event : in_.mission.events) Check(event);
    CheckStarts();
    return std::move(found_);
  }

  std::vector<FactWarning> Starts() {
    if (!in_.rasters.empty()) CheckStarts();
    return std::move(found_);
  }

 private:
  const Grid& grid() const { return in_.rasters.front()->grid; }
  int WindowOf(std::size_t i) const { return in_.fields[i]->window; }
  // Inputs of one agent in the i-th compiled window.
  std::size_t Place(std::size_t agent, std::size_t i) const {
    return agent * windows_ + i;
  }

  void Warn(const std::string& iri, const std::optional<LonLat>& place,
            const std::string& cause) {
    const std::string label = AbbreviateIri(iri) + " has no effect";
    found_.push_back({label, label + ": " + cause, place});
  }

  // Constraints and priors ---------------------------------------------------

  void Check(const kg_mission::Constraint& constraint) {
    const ActiveConstraint active = Strictest(in_.mission, constraint);
    Coverage found;
    for (std::size_t i = 0; i < windows_ && !found.meets_open; ++i) {
      if (!kg_mission::InScope(constraint.windows, WindowOf(i))) continue;
      found.is_in_scope = true;
      const WindowRasters& rasters = *in_.rasters[i];
      if (constraint.is_land) {  // Without its buffer, which takes long.
        const kg_base::Mask& land = rasters.land;
        if (std::find(land.begin(), land.end(), 1) != land.end()) return;
        continue;
      }
      const MaskPatch patch = ConstraintPatch(rasters, active, "");
      found.Add(rasters, patch.box, [&](int row) { return patch.Row(row); });
    }
    if (!found.is_in_scope || found.meets_open) return;
    if (constraint.is_land) {
      return Warn(constraint.iri, std::nullopt, NoLand());
    }
    const bool by_centres =
        active.effect->cover == kg_base::CellCover::kCentres;
    Warn(constraint.iri, MiddleOf(constraint.area),
         Cause(constraint.area, found.meets_land, by_centres));
  }

  void Check(const kg_mission::PriorLayer& prior) {
    Coverage found;
    for (std::size_t i = 0; i < windows_ && !found.meets_open; ++i) {
      if (!kg_mission::InScope(prior.windows, WindowOf(i))) continue;
      const WindowRasters* rasters = RastersWith(prior, i);
      if (rasters == nullptr) continue;
      found.is_in_scope = true;
      const ValuePatch patch = PriorPatch(*rasters, prior, "");
      found.Add(*rasters, patch.box, [&](int row) { return patch.Row(row); });
    }
    if (!found.is_in_scope || found.meets_open) return;
    Warn(prior.iri, MiddleOf(prior.area),
         Cause(prior.area, found.meets_land, true));
  }

  // A prior's raster is read only for agents whose policy weighs it.
  const WindowRasters* RastersWith(const kg_mission::PriorLayer& prior,
                                   std::size_t i) const {
    for (std::size_t a = 0; a < in_.mission.agents.size(); ++a) {
      const WindowRasters& rasters = *in_.rasters[Place(a, i)];
      if (!prior.raster || rasters.prior_rasters.count(prior.iri) > 0) {
        return &rasters;
      }
    }
    return nullptr;
  }

  // `area`: nullopt for a raster from a file.
  std::string Cause(const std::optional<kg_base::Geometry>& area,
                    bool meets_land, bool by_centres) const {
    if (meets_land) {
      return "it covers land only, where the work field has no data; move or "
             "remove it";
    }
    if (!area) return "its raster is 0 or has no data in every cell";
    const Bounds bounds = BoundsOf(*area);
    if (!by_centres || !Overlaps(grid(), bounds)) {
      return "it lies " + OffTheGrid(grid(), bounds);
    }
    return "it contains no cell's centre, because it is smaller or thinner "
           "than a cell; widen it, or use a work field of finer cells";
  }

  std::string NoLand() const {
    return "every cell of the work field has data, so no cell is land; if the "
           "file has 0 on land, write no data there (NaN or _FillValue)";
  }

  // Events --------------------------------------------------------------------

  void Check(const kg_mission::Event& event) {
    std::optional<std::size_t> first;  // Place in scope.
    for (std::size_t place = 0; place < in_.rasters.size(); ++place) {
      const std::vector<int>& windows = event.windows;
      if (std::find(windows.begin(), windows.end(),
                    WindowOf(place % windows_)) == windows.end()) {
        continue;
      }
      if (!first) first = place;
      if (HasOpenCell(*in_.tensors[place], event)) return;
    }
    if (!first) return;
    const std::string why = WhyClosed(*first, event.position);
    Warn(event.iri, event.position,
         "no agent can come within its ex:radiusKm, because it is " +
             (why.empty() ? "too far from open cells" : why));
  }

  // Does the event's radius meet an open cell?
  static bool HasOpenCell(const MissionTensor& tensor,
                          const kg_mission::Event& event) {
    const Grid& grid = tensor.grid;
    const LonLat held{
        std::clamp(event.position.lon_deg, grid.west_deg(), grid.east_deg()),
        std::clamp(event.position.lat_deg, grid.south_deg(), grid.north_deg())};
    const std::optional<kg_base::Cell> at = grid.CellAt(held);
    if (!at) return false;
    const auto meets = [&](kg_base::Cell cell) {
      return IsWithin(grid, cell, event) &&
             tensor.At(Layer::kFeasibility, grid.Index(cell)) == 1.0f;
    };
    if (meets(*at)) return true;
    // One cell more, since the radius may end in a cell before its centre.
    const CellBox box =
        Grown(BoxWithin(grid, {at->row, at->row + 1, at->col, at->col + 1},
                        event.radius_m),
              1, grid);
    for (int row = box.row; row < box.row_end; ++row) {
      for (int col = box.col; col < box.col_end; ++col) {
        if (meets({row, col})) return true;
      }
    }
    return false;
  }

  // Is the cell's point nearest to the event within its radius?
  static bool IsWithin(const Grid& grid, kg_base::Cell cell,
                       const kg_mission::Event& event) {
    const LonLat nearest{
        std::clamp(event.position.lon_deg, grid.lon_axis().Edge(cell.col),
                   grid.lon_axis().Edge(cell.col + 1)),
        std::clamp(event.position.lat_deg, grid.lat_axis().Edge(cell.row),
                   grid.lat_axis().Edge(cell.row + 1))};
    return kg_base::Distance_m(event.position, nearest) <= event.radius_m;
  }

  // Positions -----------------------------------------------------------------

  void CheckStarts() {
    if (windows_ == 0) return;
    for (std::size_t a = 0; a < in_.rules.size(); ++a) {
      const SeamRules& rules = in_.rules[a];
      const std::string why = WhyClosed(Place(a, 0), rules.start);
      if (why.empty()) continue;
      found_.push_back({rules.agent_id + " cannot start here",
                        "agent " + rules.agent_id + " (" +
                            AbbreviateIri(rules.agent_iri) + ") starts at " +
                            kg_base::PointWkt(rules.start) + ", which is " +
                            why,
                        rules.start});
    }
  }

  // Empty if the position is open.
  std::string WhyClosed(std::size_t place, LonLat position) const {
    const std::optional<kg_base::Cell> cell = grid().CellAt(position);
    if (!cell) return OffTheGrid(grid(), BoundsOf(position));
    if (in_.rasters[place]->land[grid().Index(*cell)]) {
      return "on land: the work field has no data there";
    }
    const std::vector<std::string> names = ForbiddenBy(place, *cell);
    if (names.empty()) return "";
    return "in " + kg_base::JoinStrings(names) +
           ", a no_go area, or within its buffer";
  }

  std::vector<std::string> ForbiddenBy(std::size_t place,
                                       kg_base::Cell cell) const {
    const kg_mission::Agent& agent = in_.mission.agents[place / windows_];
    const ActiveFacts active = FindActiveFacts(
        in_.mission, agent, in_.mission.windows[WindowOf(place % windows_)]);
    std::vector<std::string> names;
    for (const ActiveConstraint& constraint : active.constraints) {
      if (!constraint.forbids()) continue;
      const MaskPatch patch =
          ConstraintPatch(*in_.rasters[place], constraint, "");
      const bool is_in_box = patch.box.HasRow(cell.row) &&
                             cell.col >= patch.box.col &&
                             cell.col < patch.box.col_end;
      if (is_in_box && patch.Row(cell.row)[cell.col - patch.box.col] != 0) {
        names.push_back(AbbreviateIri(constraint.fact->iri));
      }
    }
    return names;
  }

  const Compilation& in_;
  const std::size_t windows_;  // Number of compiled windows.
  std::vector<FactWarning> found_;
};

}  // namespace

std::vector<FactWarning> FindWarnings(const Compilation& compilation) {
  return WarningFinder(compilation).All();
}

std::vector<std::string> Lines(const std::vector<FactWarning>& warnings) {
  std::vector<std::string> lines;
  for (const FactWarning& warning : warnings) lines.push_back(warning.line);
  return lines;
}

std::vector<std::string> FindClosedStarts(const Compilation& compilation) {
  return Lines(WarningFinder(compilation).Starts());
}

}  // namespace kg_compiler
