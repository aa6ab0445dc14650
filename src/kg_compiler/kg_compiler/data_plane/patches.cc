#include "kg_compiler/data_plane/patches.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>
#include <vector>

#include "kg_base/raster/wkt_raster.h"
#include "kg_compiler/data_plane/bump.h"
#include "kg_compiler/data_plane/distance_transform.h"
#include "kg_compiler/data_plane/masks.h"

namespace kg_compiler {
namespace {

using kg_base::Grid;
using kg_base::Mask;

std::string FileKey(const kg_mission::Mission& mission,
                    const kg_mission::RasterRef& ref) {
  const auto file = mission.files.find(ref.file_iri);
  const std::string name =
      file == mission.files.end() ? ref.file_iri : file->second.sha256;
  return "file " + name + " " + ref.variable + " " +
         std::to_string(ref.time_index) + "\n" +
         std::to_string(static_cast<int>(ref.resampling));
}

// Unique text of a number (hexadecimal, exact).
std::string Digits(double x) {
  char digits[40];
  std::snprintf(digits, sizeof(digits), "%a", x);
  return digits;
}

// Box two cells beyond the centres inside the area's bounds, so that the
// touched cells at its edges are the same as on the whole grid.
CellBox BoxAround(const Grid& grid, const kg_base::Geometry& area) {
  const auto range = [](const std::vector<double>& centres, double low,
                        double high) {
    const auto first = std::lower_bound(centres.begin(), centres.end(), low);
    const auto end = std::upper_bound(first, centres.end(), high);
    return std::pair<int, int>(static_cast<int>(first - centres.begin()),
                               static_cast<int>(end - centres.begin()));
  };
  const auto rows = range(grid.lat_deg(), area.south_deg(), area.north_deg());
  const auto cols = range(grid.lon_deg(), area.west_deg(), area.east_deg());
  CellBox box =
      Grown({rows.first, rows.second, cols.first, cols.second}, 2, grid);
  box.row = std::min(box.row, grid.rows() - 2);
  box.col = std::min(box.col, grid.cols() - 2);
  box.row_end = std::max(box.row_end, box.row + 2);
  box.col_end = std::max(box.col_end, box.col + 2);
  return box;
}

Grid Within(const Grid& grid, const CellBox& box) {
  const auto part = [](const std::vector<double>& all, int first, int end) {
    return std::vector<double>(all.begin() + first, all.begin() + end);
  };
  return {part(grid.lon_deg(), box.col, box.col_end),
          part(grid.lat_deg(), box.row, box.row_end)};
}

// Bounding box of the set cells; empty if there is none.
CellBox Tight(const CellBox& box, const Mask& inside) {
  CellBox tight{box.row_end, box.row, box.col_end, box.col};
  for (int r = box.row; r < box.row_end; ++r) {
    const unsigned char* row =
        inside.data() + static_cast<std::size_t>(r - box.row) * box.cols();
    const unsigned char* end = row + box.cols();
    const unsigned char* first =
        std::find_if(row, end, [](auto x) { return x; });
    if (first == end) continue;
    const unsigned char* last = end - 1;
    while (!*last) --last;
    tight.row = std::min(tight.row, r);
    tight.row_end = r + 1;
    tight.col = std::min(tight.col, box.col + static_cast<int>(first - row));
    tight.col_end =
        std::max(tight.col_end, box.col + static_cast<int>(last - row) + 1);
  }
  return tight.empty() ? CellBox{} : tight;
}

// The mask of box `from` resampled on box `to`; 0 outside `from`.
Mask Cut(const CellBox& from, const Mask& inside, const CellBox& to) {
  Mask part(to.size(), 0);
  const CellBox common = Common(from, to);
  if (common.empty()) return part;
  for (int r = common.row; r < common.row_end; ++r) {
    const auto source =
        inside.begin() +
        static_cast<std::ptrdiff_t>(r - from.row) * from.cols() +
        (common.col - from.col);
    std::copy(source, source + common.cols(),
              part.begin() +
                  static_cast<std::ptrdiff_t>(r - to.row) * to.cols() +
                  (common.col - to.col));
  }
  return part;
}

// Extent of a constraint before buffering, on the grid extended by its
// BufferMargin.
MaskPatch BarePatch(const WindowRasters& rasters,
                    const ActiveConstraint& constraint, const Grid& extended) {
  const kg_mission::Constraint& fact = *constraint.fact;
  const CellBox whole = WholeGrid(extended);
  if (fact.is_land) return {"", whole, rasters.land};
  if (fact.mask) return {"", whole, FindMask(rasters, constraint, extended)};
  if (!fact.area) return {};
  const CellBox box = BoxAround(extended, *fact.area);
  const Grid part = Within(extended, box);
  return {"", box,
          kg_base::Rasterise(*fact.area, part, constraint.effect->cover)};
}

}  // namespace

std::string ConstraintKey(const kg_mission::Mission& mission,
                          const ActiveConstraint& constraint) {
  const kg_mission::Constraint& fact = *constraint.fact;
  const bool chebyshev =
      fact.buffer_cells > 0.0 &&
      fact.buffer_metric == kg_mission::BufferMetric::kChebyshev;
  std::string key = chebyshev ? "square " : "round ";
  key += Digits(fact.buffer_cells) + " ";
  if (fact.is_land) return key + "land";
  key += kg_base::Name(constraint.effect->cover);
  if (fact.mask) return key + " " + FileKey(mission, *fact.mask);
  if (!fact.area) return key + " nothing";
  return key + " " + fact.area->Wkt();
}

MaskPatch ConstraintPatch(const WindowRasters& rasters,
                          const ActiveConstraint& constraint, std::string key) {
  const kg_mission::Constraint& fact = *constraint.fact;
  const int margin = BufferMargin(fact, rasters.grid);
  const Grid extended = rasters.grid.Extended(margin);
  MaskPatch bare = BarePatch(rasters, constraint, extended);
  const CellBox tight = Tight(bare.box, bare.inside);
  if (tight.empty()) return {std::move(key), {}, {}};
  if (!(fact.buffer_cells > 0.0)) {
    return {std::move(key), tight, Cut(bare.box, bare.inside, tight)};
  }
  const double reach =
      std::min<double>(fact.buffer_cells, extended.rows() + extended.cols());
  const CellBox grown =
      Grown(tight, static_cast<int>(std::ceil(reach)), extended);
  const Mask inside =
      GrowByCells(grown.rows(), grown.cols(), Cut(bare.box, bare.inside, grown),
                  reach, fact.buffer_metric);
  // Back to the cells of the mission's grid.
  const CellBox from = Moved(grown, -margin);
  const CellBox own = Common(from, WholeGrid(rasters.grid));
  if (own.empty()) return {std::move(key), {}, {}};
  return {std::move(key), own, Cut(from, inside, own)};
}

std::string PriorKey(const kg_mission::Mission& mission,
                     const kg_mission::PriorLayer& prior) {
  if (prior.raster) return FileKey(mission, *prior.raster);
  return "area " + Digits(prior.edge_m) + " " +
         (prior.area ? prior.area->Wkt() : "nothing");
}

ValuePatch PriorPatch(const WindowRasters& rasters,
                      const kg_mission::PriorLayer& prior, std::string key) {
  const Grid& grid = rasters.grid;
  if (prior.raster) {
    const auto raster = rasters.prior_rasters.find(prior.iri);
    if (raster == rasters.prior_rasters.end() ||
        raster->second->size() != grid.size()) {
      throw std::logic_error("no raster of the grid's size for " + prior.iri);
    }
    return {std::move(key), WholeGrid(grid), raster->second};
  }
  auto values = std::make_shared<kg_base::Raster>();
  if (!prior.area) return {std::move(key), {}, values};
  const CellBox box = BoxAround(grid, *prior.area);
  const Mask inside = kg_base::RasteriseCentres(*prior.area, Within(grid, box));
  const CellBox tight = Tight(box, inside);
  if (tight.empty()) return {std::move(key), {}, values};
  // A soft edge extends beyond the area up to 7 sigma, where it is negligible
  // in float32 (2e-11).
  const CellBox reached =
      prior.edge_m > 0.0
          ? BoxWithin(grid, tight, kBumpReach_sigmas * prior.edge_m)
          : tight;
  const Mask part = Cut(box, inside, reached);
  if (!(prior.edge_m > 0.0)) {
    values->assign(part.begin(), part.end());
    return {std::move(key), reached, values};
  }
  for (const double d_m : DistanceTo_m(Within(grid, reached), part)) {
    values->push_back(static_cast<float>(Gaussian(d_m, prior.edge_m)));
  }
  return {std::move(key), reached, values};
}

std::string BumpKey(const kg_mission::Event& event) {
  return "bump " + Digits(event.position.lon_deg) + " " +
         Digits(event.position.lat_deg) + " " + Digits(event.radius_m);
}

ValuePatch BumpPatch(const Grid& grid, const kg_mission::Event& event,
                     std::string key) {
  const CellBox box = BumpBox(grid, event);
  auto values = std::make_shared<kg_base::Raster>(box.size(), 0.0f);
  ForEachBumpCell(grid, event, [&](kg_base::Cell cell, double bump) {
    const std::size_t row = static_cast<std::size_t>(cell.row - box.row);
    (*values)[row * box.cols() + (cell.col - box.col)] =
        static_cast<float>(bump);
  });
  return {std::move(key), box, values};
}

}  // namespace kg_compiler
