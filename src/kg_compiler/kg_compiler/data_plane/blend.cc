#include "kg_compiler/data_plane/blend.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kg_base/common/input_error.h"
#include "kg_base/raster/wkt_raster.h"
#include "kg_compiler/data_plane/bump.h"
#include "kg_compiler/data_plane/distance_transform.h"
#include "kg_compiler/data_plane/frontness.h"
#include "kg_compiler/data_plane/masks.h"

namespace kg_compiler {
namespace {

constexpr double kPercentile = 0.98;

void AddRaster(const kg_base::Raster& values, double weight,
               std::vector<double>* sum) {
  for (std::size_t i = 0; i < sum->size(); ++i) {
    if (std::isfinite(values[i])) (*sum)[i] += weight * values[i];
  }
}

void AddPrior(const WindowRasters& rasters, const ActivePrior& prior,
              std::vector<double>* sum) {
  const kg_base::Grid& grid = rasters.grid;
  if (prior.fact->raster) {
    AddRaster(*rasters.prior_rasters.at(prior.fact->iri), prior.beta, sum);
    return;
  }
  if (!prior.fact->area) return;
  const kg_base::Mask inside =
      kg_base::RasteriseCentres(*prior.fact->area, grid);
  // Without a soft edge the prior is 1 inside and 0 outside; with one it is a
  // Gaussian of the distance to the area (0 inside, hence 1 there).
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

void AddBump(const kg_base::Grid& grid, const kg_mission::Event& event,
             double beta_poi, std::vector<double>* sum) {
  ForEachBumpCell(grid, event, [&](kg_base::Cell cell, double bump) {
    (*sum)[grid.Index(cell)] += beta_poi * event.value * bump;
  });
}

double MaxPositiveOpen(const kg_base::Raster& values,
                       const kg_base::Mask& open) {
  double max_value = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (open[i] && std::isfinite(values[i])) {
      max_value = std::max<double>(max_value, values[i]);
    }
  }
  return max_value;
}

// Adds weight * max(0, x) / divisor.
void AddLayer(const kg_base::Raster& values, double weight, double divisor,
              std::vector<double>* sum) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && values[i] > 0.0f) {
      (*sum)[i] += weight * (values[i] / divisor);
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
                                  const kg_mission::Policy& policy) {
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
  for (const kg_mission::Event* event : active.events) {
    if (!(event->radius_m > 0.0)) continue;
    terms.push_back({Kind::kEvent, policy.beta_poi, nullptr, event});
  }
  return terms;
}

double LayerDivisor(const kg_mission::Policy& policy,
                    const std::optional<double>& stated, double max_value) {
  switch (policy.layer_scale) {
    case kg_mission::LayerScale::kWindow:
      return max_value > 0.0 ? max_value
                             : std::numeric_limits<double>::infinity();
    case kg_mission::LayerScale::kFixed:
      if (stated && *stated > 0.0) return *stated;
      throw kg_base::InputError(
          policy.iri + " ex:layerScale \"fixed\": the value layer of kind \"" +
          policy.value_kind +
          "\" has no ex:fullScale (of itself) or ex:frontFullScale (of its "
          "gradient)");
    case kg_mission::LayerScale::kNone:
      return 1.0;
  }
  return 1.0;
}

void AddTerm(const WindowRasters& rasters, const kg_mission::Policy& policy,
             const kg_base::Mask& open, const BlendTerm& term,
             std::vector<double>* sum) {
  // B and F: unscaled in paper_literal mode, otherwise divided by their scale.
  const auto add_layer = [&](const kg_base::Raster& values,
                             const std::optional<double>& stated) {
    if (policy.paper_literal) {
      AddRaster(values, term.weight, sum);
      return;
    }
    AddLayer(values, term.weight,
             LayerDivisor(policy, stated, MaxPositiveOpen(values, open)), sum);
  };
  switch (term.kind) {
    case BlendTerm::Kind::kBase:
      add_layer(rasters.value, rasters.full_scale);
      return;
    case BlendTerm::Kind::kFront:
      add_layer(
          GradientPerKm(rasters.grid, rasters.value, policy.front_operator),
          rasters.front_full_scale);
      return;
    case BlendTerm::Kind::kPrior:
      AddPrior(rasters, {term.prior, term.weight, ""}, sum);
      return;
    case BlendTerm::Kind::kEvent:
      AddBump(rasters.grid, *term.event, term.weight, sum);
      return;
  }
}

LayerBlend BlendLayers(const ActiveFacts& active,
                       const kg_mission::Policy& policy,
                       const WindowRasters& rasters) {
  LayerBlend blend;
  blend.open = OpenCells(rasters, active.constraints);
  blend.attenuation =
      Attenuations(rasters, active.constraints, policy.soft_overlap);
  blend.priors.assign(rasters.grid.size(), 0.0);
  blend.masked.assign(rasters.grid.size(), 0.0);
  for (const BlendTerm& term : BlendTerms(active, policy)) {
    // Priors and events have a separate sum, which is a layer by itself.
    const bool is_layer = term.kind == BlendTerm::Kind::kBase ||
                          term.kind == BlendTerm::Kind::kFront;
    AddTerm(rasters, policy, blend.open, term,
            is_layer ? &blend.masked : &blend.priors);
  }
  blend.counted = blend.open;
  for (std::size_t i = 0; i < blend.masked.size(); ++i) {
    double& v = blend.masked[i];
    v += blend.priors[i];
    // In paper_literal mode masks are applied before N, which is fitted on all
    // water; otherwise N is fitted on open cells and M_hard is applied last
    // (A4).
    if (policy.paper_literal) {
      v *= blend.open[i] ? blend.attenuation[i] : 0.0;
      blend.counted[i] = rasters.land[i] ? 0 : 1;
    } else {
      v = std::max(0.0, v) * blend.attenuation[i];
    }
  }
  return blend;
}

double ValueNormaliser::Apply(double x) const {
  if (!(range > 0.0)) return 0.0;
  return std::clamp((x - low) / range, 0.0, 1.0);
}

ValueNormaliser FitNormaliser(const std::vector<double>& values,
                              const kg_base::Mask& counted,
                              kg_mission::Normalisation kind) {
  std::vector<double> inside;
  inside.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (counted[i]) inside.push_back(values[i]);
  }
  if (inside.empty()) return {};
  const auto [min_value, max_value] =
      std::minmax_element(inside.begin(), inside.end());
  // Degenerate range (all values equal, or percentile 0): use the maximum.
  const ValueNormaliser by_max{0.0, *max_value};
  switch (kind) {
    case kg_mission::Normalisation::kMax:
      return by_max;
    case kg_mission::Normalisation::kMinMax:
      return *max_value > *min_value
                 ? ValueNormaliser{*min_value, *max_value - *min_value}
                 : by_max;
    case kg_mission::Normalisation::kPercentile: {
      const double range = NearestRank(inside);
      return range > 0.0 ? ValueNormaliser{0.0, range} : by_max;
    }
  }
  return by_max;
}

ValueNormaliser Merge(const ValueNormaliser& a, const ValueNormaliser& b) {
  const double low = std::min(a.low, b.low);
  const double top = std::max(a.low + a.range, b.low + b.range);
  return {low, top - low};
}

}  // namespace kg_compiler
