// The data plane, Phi 2: facts -> mission tensors (paper Eq. 1, as settled).
//
//   V = alpha B_t + sum_k beta_k P_tk + beta_poi P_events + gamma F(B_t)
//   U = w_t * N( max(0, V) * M_soft ) (.) M_hard
//
//   N       divides by the maximum over feasible cells (A5; minmax and
//           percentile by policy); an all-zero field stays zero.
//   w_t     after N, else it would cancel (A1; `pre` and `horizon` by policy).
//   M_soft  product of the attenuations of the soft zones a cell's centre is in
//           (A10), the policy's softOverrides in place of their own factor;
//           those that the agent must avoid are in M_hard instead (A11).
//   M_hard  0 where a no_go area touches the cell (supercover), within the land
//           buffer (Euclidean distance to land <= bufferCells), and on land;
//           applied last, so forbidden cells are exactly 0 (A4).
//   F       gradient magnitude per km (Sobel, NaN-aware), scaled to [0, 1] by
//           its maximum over the window's feasible cells (A16); skipped for
//           gamma = 0. B enters in [0, 1] likewise.
//   Events  value-weighted Gaussian bumps in the windows they are active (A42).

#ifndef KG_COMPILER_DATA_PLANE_DATA_PLANE_H_
#define KG_COMPILER_DATA_PLANE_DATA_PLANE_H_

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kg_compiler/data_plane/blend.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_core/mission/mission.h"
#include "kg_core/raster/grid.h"

namespace kg_compiler {

// What does not depend on the agent, for one window.
struct WindowRasters {
  kg_core::Grid grid;
  kg_core::Mask land;     // 1 = land (no current data).
  kg_core::Raster value;  // B_t in its own unit; NaN = no data.
  std::string value_iri;  // The ex:ValueLayer.
  std::string value_file_iri;
  std::string field_iri;     // The ex:CurrentField whose gaps are land.
  std::string content_hash;  // Of grid, land and value.
  std::string land_hash;     // Of grid and land.
  // ex:fullScale and ex:frontFullScale of the value layer, if it has them.
  std::optional<double> full_scale;
  std::optional<double> front_full_scale;
  // Those that are read from files, on this grid: priors' values (NaN = no
  // data) by the prior's IRI, constraints' masks (1 = inside) by theirs. What a
  // file says is known by its sha256: these need no hash of their own.
  std::map<std::string, std::shared_ptr<const kg_core::Raster>> prior_rasters;
  std::map<std::string, std::shared_ptr<const kg_core::Mask>> constraint_masks;
};

// One N for all windows of an agent (A1, `horizon`).
struct HorizonScale {
  double low = 0.0;
  double range = 0.0;
  std::vector<std::string> derived_from;  // What every window's blend read.
};

// `rasters` of every window of the mission, by index.
HorizonScale MeasureHorizon(const kg_core::Mission& mission,
                            const kg_core::Agent& agent,
                            const std::vector<WindowRasters>& rasters);

// A tensor on its way: what N is applied to, N, and what the confidence w_t is
// multiplied into. U = after N(masked) (.) M_hard; w_t stands either in `after`
// (A1, `post`) or, by `before`, in masked already.
struct TensorBlend {
  Blend blend;
  Normaliser n;
  double before = 1.0;
  double after = 1.0;
};
TensorBlend BlendTensor(const kg_core::Agent& agent,
                        const kg_core::TimeWindow& window,
                        const WindowRasters& rasters, const ActiveFacts& active,
                        const HorizonScale* horizon);

// `horizon` if and only if the policy's confidence mode is kHorizon. Throws
// std::logic_error if that or the rasters' sizes do not agree.
MissionTensor CompileTensor(const kg_core::Mission& mission,
                            const kg_core::Agent& agent,
                            const kg_core::TimeWindow& window,
                            const WindowRasters& rasters,
                            const HorizonScale* horizon = nullptr);

// The hash CompileTensor would give, without the work: of everything it would
// read, and nothing else. Equal hash = equal layers, whoever's they are.
std::string TensorHash(const kg_core::Mission& mission,
                       const kg_core::Agent& agent,
                       const kg_core::TimeWindow& window,
                       const WindowRasters& rasters,
                       const HorizonScale* horizon = nullptr);

// The IRIs of the facts and files that it reads, sorted: the policy, the window
// and the field whose gaps are land always; the value layer and its file if
// alpha or gamma is not 0; every constraint, weighted prior and bumping event
// in force, with the policy's ex:SoftOverride or ex:PriorWeight of it, and for
// each that the agent must avoid what says so (an inference, or the agent); the
// agent itself only if one of them is in force for naming it.
std::vector<std::string> TensorSources(const kg_core::Mission& mission,
                                       const kg_core::Agent& agent,
                                       const kg_core::TimeWindow& window,
                                       const WindowRasters& rasters);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_DATA_PLANE_H_
