// The mission that tensor_bench measures, on a grid of any size.

#ifndef KG_COMPILER_DATA_PLANE_TESTING_TENSOR_BENCH_WORLD_H_
#define KG_COMPILER_DATA_PLANE_TESTING_TENSOR_BENCH_WORLD_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "kg_compiler/data_plane/compiled_tensor.h"
#include "kg_compiler/data_plane/data_plane.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {

struct Size {
  int rows;
  int cols;
  std::string Name() const {
    return std::to_string(cols) + "x" + std::to_string(rows);
  }
};

// The border cells are forbidden because OpenCV and the pass treat them
// differently.
struct World {
  explicit World(Size size)
      : grid(EvenGrid(-98.0, 18.1, 21.6 / size.cols, size.rows, size.cols)) {
    std::mt19937 rng(1);
    kg_base::Raster value(grid.size()), prior(grid.size());
    kg_base::Mask hard(grid.size(), 0), soft(grid.size(), 0);
    for (int r = 0; r < size.rows; ++r) {
      for (int c = 0; c < size.cols; ++c) {
        const std::size_t i = grid.Index({r, c});
        value[i] =
            static_cast<float>(2.0 + std::sin(c * 0.02) + std::cos(r * 0.03) +
                               0.1 * (rng() % 1000) / 1000.0);
        prior[i] = static_cast<float>(0.3 * std::sin(c * 0.01 - r * 0.02));
        hard[i] = r == 0 || c == 0 || r + 1 == size.rows ||
                  c + 1 == size.cols || (r / 40 + c / 60) % 9 == 0;
        soft[i] = (r / 30 + c / 50) % 3 == 0;
      }
    }
    rasters = TestRasters(grid, value, kg_base::Mask(grid.size(), 0));
    rasters.prior_rasters["ex:p"] =
        std::make_shared<kg_base::Raster>(std::move(prior));
    rasters.constraint_masks["ex:hard"] =
        std::make_shared<kg_base::Mask>(std::move(hard));
    rasters.constraint_masks["ex:soft"] =
        std::make_shared<kg_base::Mask>(std::move(soft));
    mission.windows = {TestWindow(0, 0.8)};
    mission.agents = {TestAgent("alpha")};
    kg_mission::Policy& policy = mission.agents[0].policy;
    policy.gamma_front = 0.5;
    policy.beta = {{"ex:p", 0.7}};
    policy.front_operator = kg_mission::FrontOperator::kCentral;
    mission.priors.push_back({"ex:p",
                              "p",
                              std::nullopt,
                              0.0,
                              {},
                              {},
                              kg_mission::RasterRef{"ex:file", "p", 0}});
    for (const char* iri : {"ex:hard", "ex:soft"}) {
      kg_mission::Constraint zone;
      zone.iri = iri;
      zone.mask = kg_mission::RasterRef{"ex:file", iri, 0};
      zone.kind = mission.constraints.empty()
                      ? kg_mission::ConstraintKind::kNoGo
                      : kg_mission::ConstraintKind::kSoft;
      zone.attenuation = 0.4;
      mission.constraints.push_back(zone);
    }
    tensor = CompileTensor(Inputs(), nullptr);
    field = *dynamic_cast<const CompiledTensor&>(*tensor.content).field();
    field.masked = RowBands<float>(size.rows, size.cols);
    fused.resize(grid.size());
  }

  TensorInputs Inputs() const {
    return {
        &mission, &mission.agents[0], &mission.windows[0], &rasters, nullptr,
        nullptr};
  }

  void Lazy(int row, int row_end) {
    ComputeRows(rasters, row, row_end, &field);
  }
  void Lazy() { Lazy(0, grid.rows()); }
  // Runs the pass and computes U as a raster.
  void Materialised() {
    Lazy();
    RowScale n = FitScale(field, mission.agents[0].policy, 1.0f, nullptr);
    n.after = 0.8f;
    const bool is_large = grid.size() > 4'000'000;
    for (int r = 0; r < grid.rows(); ++r) {
      for (int c = 0; c < grid.cols(); c += kTileCols) {
        const int count = std::min(kTileCols, grid.cols() - c);
        float* to = &fused[grid.Index({r, c})];
        float u[kTileCols];
        NormaliseOpen(field.masked.Row(r) + c, field.state.Row(r) + c, n, count,
                      is_large ? u : to);
        if (is_large) Stream(u, count, to);
      }
    }
    StreamEnd();
  }

  kg_base::Grid grid;
  kg_mission::Mission mission;
  WindowRasters rasters;
  MissionTensor tensor;
  BlendedField field;
  kg_base::Raster fused;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_TESTING_TENSOR_BENCH_WORLD_H_
