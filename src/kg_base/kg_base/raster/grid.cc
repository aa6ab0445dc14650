#include "kg_base/raster/grid.h"

#include <cmath>
#include <sstream>
#include <utility>

#include "kg_base/common/sha256.h"
#include "kg_base/geo/geodesy.h"

namespace kg_base {
namespace {

// The cell whose centre is nearest in cell units, on an axis of `size` cells.
int NearestCell(double at, int size) { return HeldFloor(at + 0.5, size - 1); }

std::vector<double> ExtendedCentres(const Axis& axis, int cells) {
  const int size = static_cast<int>(axis.centres().size());
  std::vector<double> centres;
  for (int i = -cells; i < 0; ++i) centres.push_back(axis.At(i));
  centres.insert(centres.end(), axis.centres().begin(), axis.centres().end());
  for (int i = size; i < size + cells; ++i) centres.push_back(axis.At(i));
  return centres;
}

bool AlmostEqualAxes(const Axis& a, const Axis& b, double tolerance) {
  if (a.centres().size() != b.centres().size()) return false;
  for (std::size_t i = 0; i < a.centres().size(); ++i) {
    const double allowed = tolerance * a.Spacing(static_cast<double>(i));
    if (!(std::abs(a.centres()[i] - b.centres()[i]) <= allowed)) return false;
  }
  return true;
}

}  // namespace

Grid::Grid() {
  static const auto empty = std::make_shared<const Axis>();
  lon_ = empty;
  lat_ = empty;
}

Grid::Grid(std::vector<double> lon_deg, std::vector<double> lat_deg)
    : lon_(std::make_shared<const Axis>(std::move(lon_deg))),
      lat_(std::make_shared<const Axis>(std::move(lat_deg))) {}

LonLat Grid::Position(GridPoint point) const {
  return {lon_->At(point.col), lat_->At(point.row)};
}

std::optional<Cell> Grid::CellAt(LonLat position) const {
  const std::optional<GridPoint> at = Locate(position);
  if (!at) return std::nullopt;
  return Cell{NearestCell(at->row, rows()), NearestCell(at->col, cols())};
}

double Grid::west_deg() const { return lon_->low(); }
double Grid::east_deg() const { return lon_->high(); }
double Grid::south_deg() const { return lat_->low(); }
double Grid::north_deg() const { return lat_->high(); }

LonLat Grid::Middle() const {
  return {0.5 * (west_deg() + east_deg()), 0.5 * (south_deg() + north_deg())};
}

double Grid::MetresPerRow(double row) const {
  return lat_->Spacing(row) / LocalScale(lat_->At(row)).lat_deg;
}

double Grid::MetresPerCol(double row, double col) const {
  return lon_->Spacing(col) / LocalScale(lat_->At(row)).lon_deg;
}

Grid Grid::Extended(int cells) const {
  if (cells == 0) return *this;
  return {ExtendedCentres(*lon_, cells), ExtendedCentres(*lat_, cells)};
}

std::string Grid::Hash() const {
  Hasher hasher;
  hasher.Add("lon_deg");
  for (const double lon : lon_deg()) hasher.Add(lon);
  hasher.Add("lat_deg");
  for (const double lat : lat_deg()) hasher.Add(lat);
  return hasher.Hex();
}

std::string Grid::Text() const {
  std::ostringstream text;
  text << rows() << " x " << cols() << " cells, " << west_deg() << " to "
       << east_deg() << " E, " << south_deg() << " to " << north_deg() << " N";
  return text.str();
}

bool Grid::AlmostEquals(const Grid& other, double tolerance) const {
  return AlmostEqualAxes(*lon_, *other.lon_, tolerance) &&
         AlmostEqualAxes(*lat_, *other.lat_, tolerance);
}

bool operator==(const Grid& a, const Grid& b) {
  return a.lon_deg() == b.lon_deg() && a.lat_deg() == b.lat_deg();
}

}  // namespace kg_base
