// Building blocks of the tests' worlds: seeded random grids, masks and fields,
// and mission facts with simple values.

#ifndef KG_COMPILER_TESTING_TEST_WORLD_H_
#define KG_COMPILER_TESTING_TEST_WORLD_H_

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "kg_base/common/units.h"
#include "kg_base/raster/vector_field.h"
#include "kg_compiler/data_plane/data_plane.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

inline constexpr float kGap = std::numeric_limits<float>::quiet_NaN();

inline double Uniform(std::mt19937& rng, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(rng);
}

inline std::vector<double> EvenAxis(double first, double step, int size) {
  std::vector<double> axis;
  for (int i = 0; i < size; ++i) axis.push_back(first + i * step);
  return axis;
}

inline kg_base::Grid EvenGrid(double west, double south, double step, int rows,
                              int cols) {
  return {EvenAxis(west, step, cols), EvenAxis(south, step, rows)};
}

// Grid with random spacing within +- 1/3 of the mean.
inline kg_base::Grid UnevenGrid(std::mt19937& rng, int rows, int cols) {
  std::vector<double> lon(1, -92.0), lat(1, 23.0);
  for (int c = 1; c < cols; ++c) {
    lon.push_back(lon.back() + Uniform(rng, .03, .06));
  }
  for (int r = 1; r < rows; ++r) {
    lat.push_back(lat.back() + Uniform(rng, .03, .06));
  }
  return {lon, lat};
}

inline kg_base::Mask RandomMask(std::mt19937& rng, std::size_t size,
                                double share) {
  kg_base::Mask mask(size);
  for (auto& cell : mask) cell = Uniform(rng, 0, 1) < share;
  return mask;
}

inline kg_base::Raster RandomRaster(std::mt19937& rng, std::size_t size,
                                    double low, double high) {
  kg_base::Raster raster(size);
  for (float& x : raster) x = static_cast<float>(Uniform(rng, low, high));
  return raster;
}

// A few random vortices in a random mean flow that turns with time: smooth,
// with slices every `step_s` over [0, end_s].
inline kg_base::VectorField RandomFlow(std::mt19937& rng,
                                       const kg_base::Grid& grid,
                                       double speed_mps, double step_s,
                                       double end_s) {
  struct Vortex {
    double row, col, radius, strength;
  };
  std::vector<Vortex> vortices;
  for (int i = 0; i < 5; ++i) {
    vortices.push_back({Uniform(rng, 0, grid.rows()),
                        Uniform(rng, 0, grid.cols()), Uniform(rng, 4, 12),
                        Uniform(rng, -1, 1)});
  }
  const double phase = Uniform(rng, 0, 2 * kg_base::kPi);
  kg_base::VectorField field;
  field.grid = grid;
  for (double t = 0; t <= end_s; t += step_s) {
    kg_base::FieldSlice slice{t, kg_base::Raster(grid.size()),
                              kg_base::Raster(grid.size())};
    for (int r = 0; r < grid.rows(); ++r) {
      for (int c = 0; c < grid.cols(); ++c) {
        const double turn = phase + 2 * kg_base::kPi * t / 86400.0;
        double u = 0.3 * std::cos(turn), v = 0.3 * std::sin(turn);
        for (const Vortex& vortex : vortices) {
          const double dy = (r - vortex.row) / vortex.radius;
          const double dx = (c - vortex.col - t / 40000.0) / vortex.radius;
          const double swirl = vortex.strength * std::exp(-dx * dx - dy * dy);
          u += -2.0 * swirl * dy;
          v += 2.0 * swirl * dx;
        }
        slice.east_mps[grid.Index({r, c})] = static_cast<float>(speed_mps * u);
        slice.north_mps[grid.Index({r, c})] = static_cast<float>(speed_mps * v);
      }
    }
    field.slices.push_back(slice);
  }
  return field;
}

inline kg_base::VectorField UniformFlow(const kg_base::Grid& grid, double east,
                                        double north) {
  kg_base::VectorField field;
  field.grid = grid;
  field.slices.push_back(
      {0.0, kg_base::Raster(grid.size(), static_cast<float>(east)),
       kg_base::Raster(grid.size(), static_cast<float>(north))});
  return field;
}

// The Gulf of Mexico in outline on HYCOM's grid (541 x 385 at 0.04 degree): a
// Loop Current of up to 1.8 m/s through the east, rings drifting west of it,
// weak flow elsewhere, land north of 30 N and in the south-west.
inline kg_base::VectorField GulfLikeFlow(unsigned seed, double begin_s,
                                         double end_s, double step_s) {
  std::mt19937 rng(seed);
  struct Ring {
    double lon, lat, radius_deg, peak_mps, drift_deg_per_day;
  };
  std::vector<Ring> rings = {{-86.5, 25.5, 1.2, -1.8, 0.0},
                             {-90.5, 25.0, 1.1, -1.2, -0.05},
                             {-94.0, 24.5, 0.8, -0.7, -0.04}};
  for (int i = 0; i < 12; ++i) {
    rings.push_back({Uniform(rng, -97, -80), Uniform(rng, 20, 29),
                     Uniform(rng, 0.3, 0.7), Uniform(rng, -0.5, 0.5),
                     Uniform(rng, -0.05, 0.05)});
  }
  kg_base::VectorField field;
  field.grid = EvenGrid(-98.0, 18.1, 0.04, 385, 541);
  const kg_base::Grid& grid = field.grid;
  for (double t = begin_s; t <= end_s; t += step_s) {
    kg_base::FieldSlice slice{t, kg_base::Raster(grid.size()),
                              kg_base::Raster(grid.size())};
    for (int r = 0; r < grid.rows(); ++r) {
      for (int c = 0; c < grid.cols(); ++c) {
        const kg_base::LonLat at = grid.Centre({r, c});
        double u = 0.05, v = 0.0;
        for (const Ring& ring : rings) {
          const double drift = ring.drift_deg_per_day * t / 86400.0;
          const double x = (at.lon_deg - ring.lon - drift) / ring.radius_deg;
          const double y = (at.lat_deg - ring.lat) / ring.radius_deg;
          const double swirl =
              ring.peak_mps * std::exp(0.5 * (1.0 - x * x - y * y));
          u -= swirl * y;
          v += swirl * x;
        }
        const bool land =
            at.lat_deg > 30.0 || at.lat_deg < 21.0 - 0.8 * (at.lon_deg + 97.0);
        const std::size_t i = grid.Index({r, c});
        slice.east_mps[i] = land ? kGap : static_cast<float>(u);
        slice.north_mps[i] = land ? kGap : static_cast<float>(v);
      }
    }
    field.slices.push_back(std::move(slice));
  }
  return field;
}

inline std::string BoxWkt(double west, double south, double east,
                          double north) {
  const auto at = [](double x, double y) {
    return std::to_string(x) + " " + std::to_string(y);
  };
  return "POLYGON((" + at(west, south) + "," + at(east, south) + "," +
         at(east, north) + "," + at(west, north) + "," + at(west, south) + "))";
}

inline kg_base::Geometry Box(double west, double south, double east,
                             double north) {
  return kg_base::Geometry::FromWkt(BoxWkt(west, south, east, north));
}

inline kg_mission::Constraint AreaConstraint(const std::string& iri,
                                             kg_mission::ConstraintKind kind,
                                             const kg_base::Geometry& area) {
  kg_mission::Constraint constraint;
  constraint.iri = iri;
  constraint.kind = kind;
  constraint.area = area;
  return constraint;
}

inline kg_mission::Agent TestAgent(const std::string& id) {
  kg_mission::Agent agent;
  agent.iri = "ex:" + id;
  agent.id = id;
  agent.policy.iri = "ex:policy";
  agent.capabilities.cruise_mps = 0.5;
  agent.capabilities.max_mps = 3.0;
  agent.capabilities.energy_per_m_j = 2.0;
  agent.capabilities.hotel_load_w = 1.0;
  agent.capabilities.energy_budget_j = 1e7;
  agent.capabilities.sensor_radius_m = 12000.0;
  return agent;
}

inline kg_mission::TimeWindow TestWindow(int index, double confidence) {
  return {"ex:w" + std::to_string(index), index, index * 86400.0,
          (index + 1) * 86400.0, confidence};
}

inline WindowRasters TestRasters(const kg_base::Grid& grid,
                                 const kg_base::Raster& value,
                                 const kg_base::Mask& land) {
  WindowRasters rasters;
  rasters.grid = grid;
  rasters.land = land;
  rasters.value = value;
  rasters.value_iri = "ex:value";
  rasters.value_file_iri = "ex:value_file";
  rasters.field_iri = "ex:field";
  rasters.content_hash = "content";
  rasters.land_hash = "land";
  return rasters;
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_TESTING_TEST_WORLD_H_
