#include "kg_base/raster/wkt_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kg_base {
namespace {

// A closed cell touches a closed area if an edge of the area touches the cell
// or the cell's centre lies inside. Edges are clipped to the band of each row,
// which gives a range of longitudes; every cell that intersects it is touched.
// Inside is tested by the even-odd rule along the parallel through the row's
// centres; centres within rounding of an edge are tested by the exact
// Geometry::Contains.

using Chain = GeometryParts::Chain;

// Tolerance above the rounding error of a crossing within 360 degrees, and far
// below a millimetre.
constexpr double kRounding_deg = 1e-11;

std::vector<double> Edges(const Axis& axis) {
  std::vector<double> edges;
  const int size = static_cast<int>(axis.centres().size());
  for (int i = 0; i <= size; ++i) edges.push_back(axis.Edge(i));
  return edges;
}

struct CellRange {
  int first;
  int last;  // Inclusive; last < first: empty.
};

// Cells whose closed extent intersects [low, high], widened for rounding.
CellRange CellsMeeting(const std::vector<double>& edges, double low,
                       double high) {
  const auto begin = edges.begin();
  const auto first =
      std::lower_bound(begin + 1, edges.end(), low - kRounding_deg);
  const auto last = std::upper_bound(begin, edges.end(), high + kRounding_deg);
  const int cells = static_cast<int>(edges.size()) - 1;
  return {static_cast<int>(first - begin) - 1,
          std::min(static_cast<int>(last - begin) - 1, cells - 1)};
}

// Longitude at which the line through a and b (of different latitudes) reaches
// a latitude, clamped to the segment's longitudes.
double LonAt(LonLat a, LonLat b, double lat_deg) {
  const double share = (lat_deg - a.lat_deg) / (b.lat_deg - a.lat_deg);
  const double lon_deg = a.lon_deg + share * (b.lon_deg - a.lon_deg);
  return std::clamp(lon_deg, std::min(a.lon_deg, b.lon_deg),
                    std::max(a.lon_deg, b.lon_deg));
}

class TouchedCells {
 public:
  explicit TouchedCells(const Grid& grid)
      : grid_(grid),
        lon_edges_(Edges(grid.lon_axis())),
        lat_edges_(Edges(grid.lat_axis())),
        mask_(grid.size(), 0) {}

  void Add(const Chain& chain) {
    if (chain.size() == 1) AddSegment(chain[0], chain[0]);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      AddSegment(chain[i - 1], chain[i]);
    }
  }
  Mask Take() { return std::move(mask_); }

 private:
  void AddSegment(LonLat a, LonLat b) {
    if (a.lat_deg > b.lat_deg) std::swap(a, b);
    const CellRange rows = CellsMeeting(lat_edges_, a.lat_deg, b.lat_deg);
    for (int row = rows.first; row <= rows.last; ++row) AddBand(a, b, row);
  }

  // The part of a segment (a the southern end) within a row's band.
  void AddBand(LonLat a, LonLat b, int row) {
    const double south_deg = lat_edges_[row] - kRounding_deg;
    const double north_deg = lat_edges_[row + 1] + kRounding_deg;
    const double from =
        a.lat_deg < south_deg ? LonAt(a, b, south_deg) : a.lon_deg;
    const double to =
        b.lat_deg > north_deg ? LonAt(a, b, north_deg) : b.lon_deg;
    const CellRange cols =
        CellsMeeting(lon_edges_, std::min(from, to), std::max(from, to));
    for (int col = cols.first; col <= cols.last; ++col) {
      mask_[grid_.Index({row, col})] = 1;
    }
  }

  const Grid& grid_;
  std::vector<double> lon_edges_;
  std::vector<double> lat_edges_;
  Mask mask_;
};

struct EdgeCrossing {
  double lon_deg;
  int row;
};

// Marks cells whose centre lies in one polygon.
class CentresInside {
 public:
  CentresInside(const Geometry& area, const Grid& grid, Mask* mask)
      : area_(area), grid_(grid), mask_(*mask) {}

  void Add(const std::vector<Chain>& polygon) {
    std::vector<EdgeCrossing> crossings;
    for (const Chain& ring : polygon) {
      for (std::size_t i = 1; i < ring.size(); ++i) {
        AddEdge(ring[i - 1], ring[i], &crossings);
      }
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const EdgeCrossing& a, const EdgeCrossing& b) {
                return a.row != b.row ? a.row < b.row : a.lon_deg < b.lon_deg;
              });
    for (std::size_t i = 1; i < crossings.size(); i += 2) {
      Fill(crossings[i - 1], crossings[i]);
    }
    for (const Cell& cell : doubtful_) Decide(cell);
    doubtful_.clear();
  }

 private:
  // Crossings by the half-open rule (south end included, north end excluded),
  // which gives an even number per row. Cells on or next to the edge are marked
  // for the exact test.
  void AddEdge(LonLat a, LonLat b, std::vector<EdgeCrossing>* crossings) {
    if (a.lat_deg > b.lat_deg) std::swap(a, b);
    const std::vector<double>& lat = grid_.lat_deg();
    auto row = std::lower_bound(lat.begin(), lat.end(), a.lat_deg);
    for (; row != lat.end() && *row <= b.lat_deg; ++row) {
      const int index = static_cast<int>(row - lat.begin());
      if (a.lat_deg == b.lat_deg) {
        Doubt(index, std::min(a.lon_deg, b.lon_deg),
              std::max(a.lon_deg, b.lon_deg));
        continue;
      }
      const double lon_deg = LonAt(a, b, *row);
      Doubt(index, lon_deg, lon_deg);
      if (*row < b.lat_deg) crossings->push_back({lon_deg, index});
    }
  }

  CellRange CentresBetween(double west_deg, double east_deg) const {
    const std::vector<double>& lon = grid_.lon_deg();
    const auto first = std::lower_bound(lon.begin(), lon.end(), west_deg);
    const auto end = std::upper_bound(lon.begin(), lon.end(), east_deg);
    return {static_cast<int>(first - lon.begin()),
            static_cast<int>(end - lon.begin()) - 1};
  }

  void Doubt(int row, double west_deg, double east_deg) {
    const CellRange cols =
        CentresBetween(west_deg - kRounding_deg, east_deg + kRounding_deg);
    for (int col = cols.first; col <= cols.last; ++col) {
      doubtful_.push_back({row, col});
    }
  }

  void Fill(const EdgeCrossing& west, const EdgeCrossing& east) {
    const CellRange cols = CentresBetween(west.lon_deg, east.lon_deg);
    for (int col = cols.first; col <= cols.last; ++col) {
      mask_[grid_.Index({west.row, col})] = 1;
    }
  }

  void Decide(Cell cell) {
    mask_[grid_.Index(cell)] = area_.Contains(grid_.Centre(cell)) ? 1 : 0;
  }

  const Geometry& area_;
  const Grid& grid_;
  Mask& mask_;
  std::vector<Cell> doubtful_;
};

}  // namespace

const char* Name(const CellCover cover) {
  return cover == CellCover::kTouched ? "touched" : "centres";
}

Mask Rasterise(const Geometry& area, const Grid& grid, const CellCover cover) {
  return cover == CellCover::kTouched ? RasteriseTouched(area, grid)
                                      : RasteriseCentres(area, grid);
}

Mask RasteriseCentres(const Geometry& area, const Grid& grid) {
  Mask mask(grid.size(), 0);
  CentresInside inside(area, grid, &mask);
  for (const std::vector<Chain>& polygon : area.Parts().polygons) {
    inside.Add(polygon);
  }
  return mask;
}

Mask RasteriseTouched(const Geometry& area, const Grid& grid) {
  const GeometryParts parts = area.Parts();
  TouchedCells touched(grid);
  for (const Chain& line : parts.lines) touched.Add(line);
  for (const std::vector<Chain>& polygon : parts.polygons) {
    for (const Chain& ring : polygon) touched.Add(ring);
  }
  Mask mask = touched.Take();
  const Mask inside = RasteriseCentres(area, grid);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] |= inside[i];
  return mask;
}

}  // namespace kg_base
