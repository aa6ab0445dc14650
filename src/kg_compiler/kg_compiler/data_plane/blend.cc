#include "kg_compiler/data_plane/blend.h"

#include <algorithm>
#include <cmath>

#include "kg_compiler/data_plane/distance_transform.h"
#include "kg_compiler/data_plane/frontness.h"
#include "kg_compiler/data_plane/masks.h"
#include "kg_core/geo/geodesy.h"

namespace kg_compiler {
namespace {

constexpr double kPercentile = 0.98;
constexpr double kBumpReach_sigmas = 7.0;  // exp(-24.5) = 2e-11 beyond.

double Gaussian(double distance_m, double sigma_m) {
  const double z = distance_m / sigma_m;
  return std::exp(-0.5 * z * z);
}

void AddPrior(const kg_core::Grid& grid, const ActivePrior& prior,
              std::vector<double>* sum) {
  const kg_core::Mask inside =
      kg_core::RasteriseCentres(*prior.fact->area, grid);
  const double edge_m = prior.fact->edge_m;
  if (!(edge_m > 0.0)) {
    for (std::size_t i = 0; i < sum->size(); ++i) {
      if (inside[i]) (*sum)[i] += prior.beta;
    }
    return;
  }
  const std::vector<double> distance_m = DistanceTo_m(grid, inside);
  for (std::size_t i = 0; i < sum->size(); ++i) {
    (*sum)[i] += prior.beta * Gaussian(distance_m[i], edge_m);
  }
}

// Cells [first, last) of an axis whose centres lie within `half` of `middle`.
struct Span {
  int first, last;
};

Span SpanAround(const std::vector<double>& centres, double middle,
                double half) {
  const auto low =
      std::lower_bound(centres.begin(), centres.end(), middle - half);
  const auto high = std::upper_bound(low, centres.end(), middle + half);
  return {static_cast<int>(low - centres.begin()),
          static_cast<int>(high - centres.begin())};
}

// Distances by the scale at the middle latitude: within 1e-6 of the geodesic at
// a bump's width.
void AddBump(const kg_core::Grid& grid, const kg_core::Event& event,
             double beta_poi, std::vector<double>* sum) {
  const kg_core::LonLat at = event.position;
  const double reach_m = kBumpReach_sigmas * event.radius_m;
  const double reach_deg = reach_m * kg_core::LocalScale(at.lat_deg).lat_deg;
  const Span rows = SpanAround(grid.lat_deg(), at.lat_deg, reach_deg);
  for (int r = rows.first; r < rows.last; ++r) {
    const double lat_deg = grid.lat_deg()[r];
    const kg_core::DegreesPerMetre scale =
        kg_core::LocalScale(0.5 * (lat_deg + at.lat_deg));
    const double north_m = (lat_deg - at.lat_deg) / scale.lat_deg;
    const Span cols =
        SpanAround(grid.lon_deg(), at.lon_deg, reach_m * scale.lon_deg);
    for (int c = cols.first; c < cols.last; ++c) {
      const double east_m = (grid.lon_deg()[c] - at.lon_deg) / scale.lon_deg;
      const double d_m = std::sqrt(east_m * east_m + north_m * north_m);
      (*sum)[grid.Index({r, c})] +=
          beta_poi * event.value * Gaussian(d_m, event.radius_m);
    }
  }
}

// Adds weight * max(0, x) / (the largest x of an open cell).
void AddInUnits(const kg_core::Raster& values, const kg_core::Mask& open,
                double weight, std::vector<double>* sum) {
  double most = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (open[i] && std::isfinite(values[i])) {
      most = std::max<double>(most, values[i]);
    }
  }
  if (!(most > 0.0)) return;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && values[i] > 0.0f) {
      (*sum)[i] += weight * (values[i] / most);
    }
  }
}

double NearestRank(std::vector<double> values) {
  const std::size_t rank = static_cast<std::size_t>(
      std::ceil(kPercentile * static_cast<double>(values.size())));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

std::vector<BlendTerm> BlendTerms(const ActiveFacts& active,
                                  const kg_core::Policy& policy) {
  using Kind = BlendTerm::Kind;
  std::vector<BlendTerm> terms;
  if (policy.alpha_base != 0.0) {
    terms.push_back({Kind::kBase, policy.alpha_base, nullptr, nullptr});
  }
  if (policy.gamma_front != 0.0) {
    terms.push_back({Kind::kFront, policy.gamma_front, nullptr, nullptr});
  }
  for (const ActivePrior& prior : active.priors) {
    terms.push_back({Kind::kPrior, prior.beta, prior.fact, nullptr});
  }
  for (const kg_core::Event* event : active.events) {
    if (!(event->radius_m > 0.0)) continue;
    terms.push_back({Kind::kEvent, policy.beta_poi, nullptr, event});
  }
  return terms;
}

void AddTerm(const BlendInputs& inputs, const kg_core::Mask& open,
             const BlendTerm& term, std::vector<double>* sum) {
  switch (term.kind) {
    case BlendTerm::Kind::kBase:
      AddInUnits(inputs.value, open, term.weight, sum);
      return;
    case BlendTerm::Kind::kFront:
      AddInUnits(GradientPerKm(inputs.grid, inputs.value), open, term.weight,
                 sum);
      return;
    case BlendTerm::Kind::kPrior:
      AddPrior(inputs.grid, {term.prior, term.weight}, sum);
      return;
    case BlendTerm::Kind::kEvent:
      AddBump(inputs.grid, *term.event, term.weight, sum);
      return;
  }
}

Blend BlendLayers(const ActiveFacts& active, const kg_core::Policy& policy,
                  const BlendInputs& inputs) {
  Blend blend;
  blend.open = OpenCells(inputs.grid, inputs.land, active.constraints);
  blend.attenuation =
      Attenuations(inputs.grid, inputs.land, active.constraints);
  blend.priors.assign(inputs.grid.size(), 0.0);
  blend.masked.assign(inputs.grid.size(), 0.0);
  for (const BlendTerm& term : BlendTerms(active, policy)) {
    const bool is_layer = term.kind == BlendTerm::Kind::kBase ||
                          term.kind == BlendTerm::Kind::kFront;
    AddTerm(inputs, blend.open, term, is_layer ? &blend.masked : &blend.priors);
  }
  for (std::size_t i = 0; i < blend.masked.size(); ++i) {
    blend.masked[i] =
        std::max(0.0, blend.masked[i] + blend.priors[i]) * blend.attenuation[i];
  }
  return blend;
}

double Normaliser::Apply(double x) const {
  if (!(range > 0.0)) return 0.0;
  return std::clamp((x - low) / range, 0.0, 1.0);
}

Normaliser FitNormaliser(const std::vector<double>& values,
                         const kg_core::Mask& open,
                         kg_core::Normalisation kind) {
  std::vector<double> inside;
  inside.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (open[i]) inside.push_back(values[i]);
  }
  if (inside.empty()) return {};
  const auto [least, most] = std::minmax_element(inside.begin(), inside.end());
  const Normaliser by_max{0.0, *most};
  switch (kind) {
    case kg_core::Normalisation::kMax:
      return by_max;
    case kg_core::Normalisation::kMinMax:
      return *most > *least ? Normaliser{*least, *most - *least} : by_max;
    case kg_core::Normalisation::kPercentile: {
      const double range = NearestRank(inside);
      return range > 0.0 ? Normaliser{0.0, range} : by_max;
    }
  }
  return by_max;
}

Normaliser Merge(const Normaliser& a, const Normaliser& b) {
  const double low = std::min(a.low, b.low);
  const double top = std::max(a.low + a.range, b.low + b.range);
  return {low, top - low};
}

}  // namespace kg_compiler
