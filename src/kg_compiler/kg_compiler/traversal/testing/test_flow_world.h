// Worlds for tests and benchmarks of traversal: a generated field, the real
// files if present, and an integrator that shares no code with the library, to
// verify its flights.

#ifndef KG_COMPILER_TRAVERSAL_TESTING_TEST_FLOW_WORLD_H_
#define KG_COMPILER_TRAVERSAL_TESTING_TEST_FLOW_WORLD_H_

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "kg_base/geo/geodesy.h"
#include "kg_base/raster/read_field_file.h"
#include "kg_compiler/traversal/traversal.h"

namespace kg_compiler {

inline constexpr double kDay_s = 86400.0;

inline MotionModel Glider(double cruise_mps) {
  MotionModel motion;
  motion.cruise_mps = cruise_mps;
  motion.max_mps = 10.0;
  motion.energy_per_m_j = 2.0;
  motion.hotel_load_w = 3.0;
  return motion;
}

// A field with everything open and no hazard, unless changed.
struct TestFlowWorld {
  explicit TestFlowWorld(kg_base::VectorField flow)
      : field(std::move(flow)), open(field.grid.size(), 1) {}
  VoyageRequest From(const MotionModel& motion,
                     const VoyageDeparture& departure) const {
    return {{&field, &open, hazard.get()}, motion, departure, {}};
  }
  std::optional<FlownPath> Go(const MotionModel& motion, kg_base::LonLat from,
                              kg_base::LonLat to,
                              double deadline_s = kDay_s) const {
    const VoyageRequest voyage = From(motion, {from, 0.0, deadline_s});
    return Traverse(voyage, ComputeReach(voyage), to);
  }
  kg_base::VectorField field;
  kg_base::Mask open;
  std::unique_ptr<HazardMap> hazard;  // None unless set.
};

// Reference integrator: c bilinear by its definition, RK4 in time with 30 s
// steps along each leg. Returns the travel time [s]; nullopt if the track
// leaves the open cells or cannot be held.
class Refly {
 public:
  Refly(const TestFlowWorld& sea, const MotionModel& motion)
      : sea_(sea), m_(motion) {}

  std::optional<double> Fly(const FlownPath& flight) const {
    double t = flight.track.front().time_s;
    for (std::size_t i = 0; i + 1 < flight.track.size(); ++i) {
      const kg_base::LonLat a = flight.track[i].position;
      const kg_base::LonLat b = flight.track[i + 1].position;
      if (a == b) continue;  // At rest.
      const std::optional<double> end = TrackLeg(a, b, t);
      if (!end) return std::nullopt;
      t = *end;
    }
    return t - flight.track.front().time_s;
  }

 private:
  static kg_base::LonLat On(kg_base::LonLat a, kg_base::LonLat b, double s) {
    return {a.lon_deg + s * (b.lon_deg - a.lon_deg),
            a.lat_deg + s * (b.lat_deg - a.lat_deg)};
  }
  std::optional<double> TrackLeg(kg_base::LonLat a, kg_base::LonLat b,
                                 double t) const {
    double s = 0.0;
    while (s < 1.0) {
      const double dt = 30.0;
      const double k1 = Rate(a, b, s, t);
      const double k2 = Rate(a, b, s + dt / 2 * k1, t + dt / 2);
      const double k3 = Rate(a, b, s + dt / 2 * k2, t + dt / 2);
      const double k4 = Rate(a, b, s + dt * k3, t + dt);
      const double ds = dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      if (!(ds > 0.0)) return std::nullopt;
      const double used = s + ds > 1.0 ? (1.0 - s) / ds * dt : dt;
      s = std::min(1.0, s + ds);
      t += used;
      const auto cell = sea_.field.grid.CellAt(On(a, b, s));
      if (!cell || !sea_.open[sea_.field.grid.Index(*cell)]) {
        return std::nullopt;
      }
    }
    return t;
  }
  double Rate(kg_base::LonLat a, kg_base::LonLat b, double s, double t) const {
    const kg_base::LonLat p = On(a, b, std::min(s, 1.0));
    const kg_base::DegreesPerMetre scale = kg_base::LocalScale(p.lat_deg);
    const double x = (b.lon_deg - a.lon_deg) / scale.lon_deg;
    const double y = (b.lat_deg - a.lat_deg) / scale.lat_deg;
    const double length = std::hypot(x, y);
    double u = 0, v = 0;
    Current(p, t, &u, &v);
    const double along = (u * x + v * y) / length;
    const double across = (u * y - v * x) / length;
    const double own = m_.cruise_mps * m_.cruise_mps - across * across;
    if (!(own > 0)) return -1.0;
    return (along + std::sqrt(own)) / length;
  }
  void Current(kg_base::LonLat p, double t, double* u, double* v) const {
    const auto& slices = sea_.field.slices;
    std::size_t k = 0;
    while (k + 2 < slices.size() && slices[k + 1].time_s <= t) ++k;
    const std::size_t l = std::min(k + 1, slices.size() - 1);
    const double span = slices[l].time_s - slices[k].time_s;
    const double f =
        span > 0 ? std::clamp((t - slices[k].time_s) / span, 0.0, 1.0) : 0.0;
    *u = m_.boost_gain *
         ((1 - f) * At(slices[k].east_mps, p) + f * At(slices[l].east_mps, p));
    *v = m_.boost_gain * ((1 - f) * At(slices[k].north_mps, p) +
                          f * At(slices[l].north_mps, p));
  }
  double At(const kg_base::Raster& raster, kg_base::LonLat p) const {
    const kg_base::Grid& grid = sea_.field.grid;
    const auto locate = [](const std::vector<double>& axis, double x, int* i) {
      *i = 0;
      while (*i + 2 < static_cast<int>(axis.size()) && axis[*i + 1] <= x) ++*i;
      return std::clamp((x - axis[*i]) / (axis[*i + 1] - axis[*i]), 0.0, 1.0);
    };
    int r = 0, c = 0;
    const double fr = locate(grid.lat_deg(), p.lat_deg, &r);
    const double fc = locate(grid.lon_deg(), p.lon_deg, &c);
    const auto value = [&](int i, int j) {
      const float x = raster[grid.Index({i, j})];
      return std::isnan(x) ? 0.0 : double(x);
    };
    return (1 - fr) * ((1 - fc) * value(r, c) + fc * value(r, c + 1)) +
           fr * ((1 - fc) * value(r + 1, c) + fc * value(r + 1, c + 1));
  }

  const TestFlowWorld& sea_;
  const MotionModel& m_;
};

// The currents of a real file from its first time step on; nullopt if the file
// is not present.
inline std::optional<TestFlowWorld> RealSea(const std::string& file) {
  const char* folder = std::getenv("KG_SHARED_DATA");
  const std::string path =
      std::string(folder ? folder : "../../../shared/data") + "/" + file;
  if (!std::ifstream(path)) return std::nullopt;
  kg_base::FieldFile ocean = kg_base::ReadFieldFile(
      path, {kg_base::FieldQuantity::kEastwardVelocity,
             kg_base::FieldQuantity::kNorthwardVelocity});
  kg_base::VectorField field;
  field.grid = ocean.grid;
  for (std::size_t i = 0; i < ocean.time_s.size(); ++i) {
    field.slices.push_back({ocean.time_s[i] - ocean.time_s[0],
                            std::move(ocean.series[0].at_time[i]),
                            std::move(ocean.series[1].at_time[i])});
  }
  TestFlowWorld sea(std::move(field));
  const kg_base::Mask land = sea.field.NoData();
  for (std::size_t i = 0; i < land.size(); ++i) sea.open[i] = !land[i];
  return sea;
}
inline constexpr const char* kRealFiles[] = {
    "gom_2014/hycom_goml_tuv_2014-08-30.nc",
    "gom_2020/currents_hycom_gomu_2020-11-01-15_5h.nc4"};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_TESTING_TEST_FLOW_WORLD_H_
