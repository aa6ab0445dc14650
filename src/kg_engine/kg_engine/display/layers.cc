#include "kg_engine/display/layers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace kg_engine {
namespace {

using kg_compiler::CellAccess;
using kg_compiler::Layer;
using kg_compiler::MissionTensor;
using kg_compiler::WorkMap;

constexpr double kMostWork = 98.0;
constexpr std::int8_t kTooFarPercent = 99;
constexpr std::int8_t kForbiddenPercent = 100;

std::int8_t ToPercent(double share) {
  return static_cast<std::int8_t>(
      std::lround(100.0 * std::clamp(share, 0.0, 1.0)));
}

// scale * values + offset; no data where either raster has none.
Percents Scaled(const MissionTensor& tensor, const kg_base::Raster& values,
                double scale, double offset = 0.0) {
  const kg_base::Raster feasibility = tensor.Get(Layer::kFeasibility);
  Percents percents(values.size(), kNoDataPercent);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(feasibility[i]) || std::isnan(values[i])) continue;
    percents[i] = ToPercent(values[i] * scale + offset);
  }
  return percents;
}

// Value displayed as 100: the kShare quantile of the nonzero cells.
float TopOfScale(const kg_base::Raster& values) {
  constexpr double kShare = 0.995;
  std::vector<float> worth;
  std::copy_if(values.begin(), values.end(), std::back_inserter(worth),
               [](float value) { return value > 0.0F; });
  if (worth.empty()) return 0.0F;
  const auto rank = static_cast<std::ptrdiff_t>(
      std::ceil(kShare * static_cast<double>(worth.size() - 1)));
  std::nth_element(worth.begin(), worth.begin() + rank, worth.end());
  return worth[rank];
}

Percents OfItsTop(const MissionTensor& tensor, const kg_base::Raster& values) {
  const float top = TopOfScale(values);
  return Scaled(tensor, values, top > 0.0F ? 1.0 / top : 0.0);
}

Percents Reward(const MissionTensor& tensor, const WorkMap*) {
  return OfItsTop(tensor, tensor.Get(Layer::kReward));
}

Percents Uncertainty(const MissionTensor& tensor, const WorkMap*) {
  return Scaled(tensor, tensor.Get(Layer::kUncertainty), 1.0);
}

Percents Policy(const MissionTensor& tensor, const WorkMap*) {
  const kg_base::Raster policy = tensor.Get(Layer::kPolicy);
  const kg_base::Raster feasibility = tensor.Get(Layer::kFeasibility);
  float most = 0.0F;
  for (std::size_t i = 0; i < policy.size(); ++i) {
    if (!std::isnan(feasibility[i])) most = std::max(most, std::abs(policy[i]));
  }
  return Scaled(tensor, policy, most > 0.0F ? 0.5 / most : 0.0, 0.5);
}

Percents Attenuation(const MissionTensor& tensor, const WorkMap*) {
  return Scaled(tensor, tensor.Get(Layer::kAttenuation), 1.0);
}

Percents Feasibility(const MissionTensor& tensor, const WorkMap*) {
  return Scaled(tensor, tensor.Get(Layer::kFeasibility), 1.0);
}

Percents Fused(const MissionTensor& tensor, const WorkMap*) {
  return FusedPercents(tensor);
}

Percents Reach(const MissionTensor&, const WorkMap* work) {
  Percents percents;
  percents.reserve(work->access.size());
  for (const CellAccess access : work->access) {
    percents.push_back(access == CellAccess::kNoData    ? kNoDataPercent
                       : access == CellAccess::kReached ? std::int8_t{100}
                                                        : std::int8_t{0});
  }
  return percents;
}

std::int8_t WorkPercent(const WorkMap& work, std::size_t cell) {
  switch (work.access[cell]) {
    case CellAccess::kNoData:
      return kNoDataPercent;
    case CellAccess::kForbidden:
      return kForbiddenPercent;
    case CellAccess::kTooFar:
      return kTooFarPercent;
    case CellAccess::kReached:
      break;
  }
  return static_cast<std::int8_t>(std::lround(kMostWork * *work.Share(cell)));
}

Percents Work(const MissionTensor&, const WorkMap* work) {
  Percents percents;
  percents.reserve(work->access.size());
  for (std::size_t i = 0; i < work->access.size(); ++i) {
    percents.push_back(WorkPercent(*work, i));
  }
  return percents;
}

Percents FusedView(const MissionTensor& tensor, const WorkMap* work) {
  return OfItsTop(tensor, kg_compiler::FusedView(tensor, *work));
}

}  // namespace

Percents FusedPercents(const MissionTensor& tensor) {
  return OfItsTop(tensor, tensor.Get(Layer::kFused));
}

const std::vector<ShownLayer>& ShownLayers() {
  static const std::vector<ShownLayer> layers = {
      {"REWARD", false, Reward},
      {"UNCERTAINTY", false, Uncertainty},
      {"POLICY", false, Policy},
      {"ATTENUATION", false, Attenuation},
      {"FEASIBILITY", false, Feasibility},
      {"FUSED", false, Fused},
      {"REACH", true, Reach},
      {"WORK", true, Work},
      {"FUSED_VIEW", true, FusedView},
  };
  return layers;
}

}  // namespace kg_engine
