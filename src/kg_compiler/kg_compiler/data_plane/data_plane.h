// The data plane, Phi 2: facts -> mission tensors (paper Eq. 1, as settled).
//
//   V = alpha B_t + sum_k beta_k P_tk + beta_poi P_events + gamma F(B_t)
//   U = w_t * N( max(0, V) * M_soft ) (.) M_hard
//
//   N       divides by the maximum over feasible cells (A5; minmax and
//           percentile by policy); an all-zero field stays zero.
//   w_t     after N, which would otherwise cancel it (A1; `pre` and `horizon`
//           by policy).
//   M_soft  product (or minimum) of the attenuations of the soft zones that
//           contain the cell's centre (A10), with the policy's softOverrides
//           replacing their factors; zones that the agent must avoid are part
//           of M_hard (A11).
//   M_hard  0 where a no_go area touches the cell (supercover) or a mask
//           contains it, within its buffer (Euclidean or Chebyshev, in cells),
//           and on land; applied last, so forbidden cells are exactly 0 (A4).
//   F       gradient magnitude per km (Sobel or central, NaN-aware), divided by
//           its maximum over the window's feasible cells (A16), or by the
//           stated scale; skipped for gamma = 0. B is scaled likewise.
//   P       areas, 1 inside, with soft edges; rasters unchanged.
//   Events  value-weighted Gaussian bumps in the windows they are active (A42).
//
//   paper_literal: U = N( w_t V M_soft M_hard ), layers unscaled, N min-max
//           over all water; 0 on land.
//
// In float32, one pass over the rows; see compile_blend.h and
// compiled_tensor.h.

#ifndef KG_COMPILER_DATA_PLANE_DATA_PLANE_H_
#define KG_COMPILER_DATA_PLANE_DATA_PLANE_H_

#include <memory>
#include <string>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/blend.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_compiler/data_plane/tensor_inputs.h"
#include "kg_compiler/data_plane/window_rasters.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

// Common N of all windows. `rasters`: one per window of the mission, by index.
HorizonScale MeasureHorizon(
    const kg_mission::Mission& mission, const kg_mission::Agent& agent,
    const std::vector<std::shared_ptr<const WindowRasters>>& rasters,
    DataPlaneCache* cache);
HorizonScale MeasureHorizon(const kg_mission::Mission& mission,
                            const kg_mission::Agent& agent,
                            const std::vector<WindowRasters>& rasters);

// The reference: intermediate results of a tensor in double precision: the
// input of N, N, and the factor w_t. U = after N(masked) on the counted cells,
// 0 elsewhere; w_t is either in `after` (A1, `post`) or, via `before`, already
// in masked.
struct TensorBlend {
  LayerBlend blend;
  ValueNormaliser n;
  double before = 1.0;
  double after = 1.0;
};
TensorBlend BlendTensor(const kg_mission::Agent& agent,
                        const kg_mission::TimeWindow& window,
                        const WindowRasters& rasters, const ActiveFacts& active,
                        const HorizonScale* horizon);

// Inputs of compiling a tensor, selected once for its hash, its provenance and
// its blend.
struct TensorRequest {
  TensorInputs inputs;
  ActiveFacts active;
  std::string hash;  // As TensorHash.
  // From the horizon, or the sorted IRIs of the facts and files that are read:
  // always the policy, the window and the field whose gaps are land; the value
  // layer and its file if alpha or gamma is not 0; every constraint, weighted
  // prior and event with a bump in force, with the policy's ex:SoftOverride or
  // ex:PriorWeight of it, and for each zone that the agent must avoid the fact
  // stating so (an inference, or the agent); the agent itself only if one of
  // them is in force because it names the agent.
  std::vector<std::string> sources;
};
TensorRequest PrepareTensor(const TensorInputs& inputs);

// Recomputes only the differences from `previous`, if given and compiled: any
// tensor is valid, ideally that of the same agent and window before the facts
// changed. The result is bit-identical for every `previous`; `cells_computed`
// reports the work done. Throws std::logic_error if the rasters' sizes or the
// horizon do not agree with the rest.
MissionTensor CompilePrepared(const TensorRequest& request,
                              const MissionTensor* previous);
MissionTensor CompileTensor(const TensorInputs& inputs,
                            const MissionTensor* previous);

// Compiles from scratch.
MissionTensor CompileTensor(const kg_mission::Mission& mission,
                            const kg_mission::Agent& agent,
                            const kg_mission::TimeWindow& window,
                            const WindowRasters& rasters,
                            const HorizonScale* horizon = nullptr);

// The hash that CompileTensor would return, without compiling: covers exactly
// the inputs it would read. Equal hash = equal layers, for any agent.
std::string TensorHash(const kg_mission::Mission& mission,
                       const kg_mission::Agent& agent,
                       const kg_mission::TimeWindow& window,
                       const WindowRasters& rasters,
                       const HorizonScale* horizon = nullptr);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_DATA_PLANE_H_
