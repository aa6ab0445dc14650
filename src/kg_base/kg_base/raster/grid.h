// A longitude/latitude grid as in its file: cells given by their centres, with
// arbitrary spacing along each axis (e.g. HYCOM's Mercator rows).
//
// Canonical form, independent of the file: longitudes in [-180, 180) ascending,
// latitudes ascending. Row 0 is the south, column 0 the west; a raster is
// row-major, index = row * cols + col.
//
// The antimeridian is not supported: a grid never wraps, positions are used
// with their longitude in [-180, 180) unchanged, and the file reader rejects a
// grid that crosses 180 degrees.

#ifndef KG_BASE_RASTER_GRID_H_
#define KG_BASE_RASTER_GRID_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_base/raster/axis.h"

namespace kg_base {

struct Cell {
  int row = 0;
  int col = 0;
};
inline bool operator==(const Cell& a, const Cell& b) {
  return a.row == b.row && a.col == b.col;
}

// A position in cell units: (0, 0) is the centre of cell (0, 0); whole numbers
// are cell centres.
struct GridPoint {
  double row = 0.0;
  double col = 0.0;
};

class Grid {
 public:
  Grid();  // Empty grid.
  // Both axes strictly ascending with at least two entries; throws
  // std::logic_error otherwise (files are checked by their reader).
  Grid(std::vector<double> lon_deg, std::vector<double> lat_deg);

  int rows() const { return static_cast<int>(lat_deg().size()); }
  int cols() const { return static_cast<int>(lon_deg().size()); }
  std::size_t size() const { return lon_deg().size() * lat_deg().size(); }
  const std::vector<double>& lon_deg() const { return lon_->centres(); }
  const std::vector<double>& lat_deg() const { return lat_->centres(); }
  const Axis& lon_axis() const { return *lon_; }
  const Axis& lat_axis() const { return *lat_; }

  std::size_t Index(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * lon_deg().size() +
           static_cast<std::size_t>(cell.col);
  }
  bool Contains(Cell cell) const {
    return cell.row >= 0 && cell.row < rows() && cell.col >= 0 &&
           cell.col < cols();
  }
  LonLat Centre(Cell cell) const {
    return {lon_deg()[cell.col], lat_deg()[cell.row]};
  }

  // Piecewise linear between centres; extends half a cell beyond the outer
  // centres; nullopt outside of that or for NaN.
  std::optional<GridPoint> Locate(LonLat position) const {
    const std::optional<double> col = lon_->Locate(position.lon_deg);
    const std::optional<double> row = lat_->Locate(position.lat_deg);
    if (!col || !row) return std::nullopt;
    return GridPoint{*row, *col};
  }
  LonLat Position(GridPoint point) const;  // The inverse.
  std::optional<Cell> CellAt(LonLat position) const;

  // Outer edges: half a cell beyond the outermost centres.
  double west_deg() const;
  double east_deg() const;
  double south_deg() const;
  double north_deg() const;
  LonLat Middle() const;  // Centre of the box; origin of the map projection.

  // Metres per cell step at a row, on WGS84 (radii of curvature at that
  // latitude), from the mean spacing around (row, col).
  double MetresPerRow(double row) const;
  double MetresPerCol(double row, double col) const;

  // The grid with `cells` more rows and columns on every side, at the outer
  // spacing; they may lie beyond the poles and 180 degrees.
  Grid Extended(int cells) const;

  std::string Hash() const;  // Hash of both axes, hex.
  // Readable text: "51 x 51 cells, -98 to -96 E, 21 to 23 N" (rows first).
  std::string Text() const;
  // Same size and every centre within `tolerance` of the local spacing (file
  // coordinates carry float32 noise).
  bool AlmostEquals(const Grid& other, double tolerance = 0.01) const;

 private:
  std::shared_ptr<const Axis> lon_;  // Copies of a grid share its axes.
  std::shared_ptr<const Axis> lat_;
};

bool operator==(const Grid& a, const Grid& b);
inline bool operator!=(const Grid& a, const Grid& b) { return !(a == b); }

// One value per cell. Float rasters: NaN = no data, never infinite.
using Raster = std::vector<float>;
// Byte rasters: 0 or 1 per cell.
using Mask = std::vector<unsigned char>;

}  // namespace kg_base

#endif  // KG_BASE_RASTER_GRID_H_
