// For tests and benchmarks: flows with known earliest arrivals, on a plane
// (540 x 384 steps of 0.001 degree around 0 N 0 E, where WGS84 is one to 1e-5).
// V = 1 m/s; places in metres from the middle, x east, y north.

#ifndef KG_COMPILER_TRAVERSAL_TESTING_CLOSED_FORMS_H_
#define KG_COMPILER_TRAVERSAL_TESTING_CLOSED_FORMS_H_

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/geo/geodesy.h"
#include "kg_base/raster/vector_field.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {

struct Metres {
  double x = 0.0, y = 0.0;
};

inline kg_base::LonLat OnPlane(Metres at) {
  const kg_base::DegreesPerMetre scale = kg_base::LocalScale(0.0);
  return {at.x * scale.lon_deg, at.y * scale.lat_deg};
}

struct ClosedForm {
  std::string name;
  kg_base::VectorField field;
  // Earliest arrival [s]; infinite where not reachable within a day.
  std::function<double(Metres from, Metres to)> optimum_s;
};

namespace closed_forms {

inline constexpr double kDay_s = 86400.0;

// First time T with `late_m(T) <= 0` (distance still missing [m]): bracketed in
// steps of 40 s, then bisected.
inline double First(const std::function<double(double)>& late_m) {
  constexpr double kStep_s = 40.0;
  for (double t = 0.0; t < kDay_s; t += kStep_s) {
    if (late_m(t + kStep_s) > 0.0) continue;
    double low = t, high = t + kStep_s;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (late_m(middle) > 0.0 ? low : high) = middle;
    }
    return high;
  }
  return std::numeric_limits<double>::infinity();
}

inline kg_base::VectorField Field(
    const std::vector<double>& times_s,
    const std::function<Metres(Metres, double)>& flow) {
  kg_base::VectorField field;
  field.grid = EvenGrid(-0.27, -0.192, 0.001, 385, 541);
  const kg_base::DegreesPerMetre scale = kg_base::LocalScale(0.0);
  for (const double time_s : times_s) {
    kg_base::Raster east_mps, north_mps;
    for (int r = 0; r < 385; ++r) {
      for (int c = 0; c < 541; ++c) {
        const kg_base::LonLat at = field.grid.Centre({r, c});
        const Metres v = flow(
            {at.lon_deg / scale.lon_deg, at.lat_deg / scale.lat_deg}, time_s);
        east_mps.push_back(static_cast<float>(v.x));
        north_mps.push_back(static_cast<float>(v.y));
      }
    }
    field.slices.push_back({time_s, std::move(east_mps), std::move(north_mps)});
  }
  return field;
}

inline ClosedForm Uniform(const std::string& name, double east, double north) {
  return {name,
          Field({0.0},
                [=](Metres, double) {
                  return Metres{east, north};
                }),
          [=](Metres a, Metres b) {
            return First([=](double t) {
              return std::hypot(b.x - a.x - east * t, b.y - a.y - north * t) -
                     t;
            });
          }};
}

// c = (s y, 0): tan(theta) = p - s t along an extremal, which integrates to
// the expression below; the places reached at T on a given latitude lie between
// the westernmost and the easternmost one.
inline double ShearX(double s, Metres from, double y, double t, double sign) {
  const double k = sign * s * (y - from.y);
  double low = -1e6, high = 1e6;  // p
  for (int i = 0; i < 80; ++i) {
    const double p = 0.5 * (low + high);
    const double q = p - s * t;
    (std::sqrt(1 + p * p) - std::sqrt(1 + q * q) < k ? low : high) = p;
  }
  const double p = 0.5 * (low + high), q = p - s * t;
  const auto area = [](double z) {
    return 0.5 * (z * std::sqrt(1 + z * z) + std::asinh(z));
  };
  return from.x + sign * (std::asinh(p) - std::asinh(q)) / s + s * from.y * t +
         sign * (t * std::sqrt(1 + p * p) - (area(p) - area(q)) / s);
}

inline ClosedForm Shear() {
  const double s = 0.8 / 21300.0;
  return {"linear shear, |c| to 0.8 V",
          Field({0.0},
                [=](Metres at, double) {
                  return Metres{s * at.y, 0.0};
                }),
          [=](Metres a, Metres b) {
            return First([=](double t) {
              if (t <= std::abs(b.y - a.y)) return 1.0;
              const double east = ShearX(s, a, b.y, t, 1.0);
              const double west = ShearX(s, a, b.y, t, -1.0);
              return std::max(b.x - east, west - b.x);
            });
          }};
}

// There is no flow in the rotating frame.
inline ClosedForm Vortex() {
  const double spin = 0.8 / 36800.0;
  return {"solid-body vortex, |c| to 0.8 V",
          Field({0.0},
                [=](Metres at, double) {
                  return Metres{-spin * at.y, spin * at.x};
                }),
          [=](Metres a, Metres b) {
            return First([=](double t) {
              const double c = std::cos(spin * t), s = std::sin(spin * t);
              return std::hypot(c * b.x + s * b.y - a.x,
                                -s * b.x + c * b.y - a.y) -
                     t;
            });
          }};
}

// |x_f - x_0 - int c| = V T; c linear between slices, its integral too.
inline ClosedForm Tide() {
  const double turn = 2.0 * kg_base::kPi / 43200.0, step_s = 3600.0;
  const auto flow = [=](double t) {
    return Metres{0.6 * std::cos(turn * t), 0.6 * std::sin(turn * t)};
  };
  std::vector<double> times_s;
  for (double t = 0.0; t <= kDay_s; t += step_s) times_s.push_back(t);
  const auto drift = [=](double t) {
    Metres sum;
    for (double b = 0.0; b < t; b += step_s) {
      const Metres u = flow(b), v = flow(b + step_s);
      const double used = std::min(step_s, t - b), f = used / step_s;
      sum.x += used * (u.x + 0.5 * f * (v.x - u.x));
      sum.y += used * (u.y + 0.5 * f * (v.y - u.y));
    }
    return sum;
  };
  return {"rotating tide, |c| = 0.6 V",
          Field(times_s, [=](Metres, double t) { return flow(t); }),
          [=](Metres a, Metres b) {
            return First([=](double t) {
              const Metres d = drift(t);
              return std::hypot(b.x - a.x - d.x, b.y - a.y - d.y) - t;
            });
          }};
}

}  // namespace closed_forms

inline std::vector<ClosedForm> ClosedForms() {
  return {closed_forms::Uniform("uniform, |c| = 0.54 V", 0.45, 0.3),
          closed_forms::Uniform("uniform, |c| = 1.53 V", 1.3, 0.8),
          closed_forms::Shear(), closed_forms::Vortex(), closed_forms::Tide()};
}

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_TESTING_CLOSED_FORMS_H_
