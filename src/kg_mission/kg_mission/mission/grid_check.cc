#include "kg_mission/mission/grid_check.h"

#include <cmath>
#include <string>

#include "kg_base/common/units.h"

namespace kg_mission {
namespace {

using kg_base::Geometry;
using kg_core::Ex;

// Mean length of a degree along the WGS84 meridian: 110.57 km at the equator,
// 111.69 km at the poles.
constexpr double kKmPerDegreeOfLatitude = 111.13;
constexpr double kTolerance = 0.05;
constexpr double kMaxAspect = 4.0;

void CheckRows(const FactEntity& grid, const Geometry& box) {
  const double height_km =
      (box.north_deg() - box.south_deg()) * kKmPerDegreeOfLatitude;
  const double rows_km =
      grid.Number(Ex("pixelSizeKm")) * grid.Integer(Ex("rows"));
  if (std::abs(rows_km - height_km) <= kTolerance * height_km) return;
  grid.Refuse(Ex("pixelSizeKm"),
              "ex:rows times ex:pixelSizeKm to span the height of geo:asWKT, " +
                  std::to_string(height_km) + " km, not " +
                  std::to_string(rows_km));
}

void CheckColumns(const FactEntity& grid, const Geometry& box) {
  const double middle_rad =
      kg_base::DegToRad((box.north_deg() + box.south_deg()) / 2);
  const double width_km = (box.east_deg() - box.west_deg()) *
                          kKmPerDegreeOfLatitude * std::cos(middle_rad);
  const double cell_km = width_km / grid.Integer(Ex("cols"));
  const double pixel_km = grid.Number(Ex("pixelSizeKm"));
  // Towards the poles, cells of equal degrees get narrow.
  const double row_deg =
      (box.north_deg() - box.south_deg()) / grid.Integer(Ex("rows"));
  const double col_deg =
      (box.east_deg() - box.west_deg()) / grid.Integer(Ex("cols"));
  const bool is_wide_enough =
      cell_km >= pixel_km / kMaxAspect || col_deg >= row_deg / kMaxAspect;
  if (is_wide_enough && cell_km <= pixel_km * kMaxAspect) return;
  grid.Refuse(Ex("cols"),
              "cells of 1/4 to 4 times ex:pixelSizeKm across the width of "
              "geo:asWKT, or steps of 1/4 of those of rows in degrees and "
              "more, not cells of " +
                  std::to_string(cell_km) +
                  " km; interpolate the file to another grid");
}

}  // namespace

void CheckGrid(const FactEntity& grid) {
  const Geometry box = grid.Wkt();
  CheckRows(grid, box);
  CheckColumns(grid, box);
}

}  // namespace kg_mission
