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
//           escalated to M_hard by the policy (A11).
//   M_hard  0 where a no_go area touches the cell (supercover), within the land
//           buffer (Euclidean distance to land <= bufferCells), and on land;
//           applied last, so forbidden cells are exactly 0 (A4).
//   F       gradient magnitude per km (Sobel, NaN-aware), scaled to [0, 1] by
//           its maximum over the window's feasible cells (A16); skipped for
//           gamma = 0. B and F enter in [0, 1].
//   Events  value-weighted Gaussian bumps in the windows they are active (A42).

#ifndef KG_COMPILER_DATA_PLANE_H_
#define KG_COMPILER_DATA_PLANE_H_

#include "kg_compiler/mission_tensor.h"
#include "kg_core/mission/mission.h"
#include "kg_core/raster/grid.h"

namespace kg_compiler {

// What does not depend on the agent, for one window.
struct WindowRasters {
  kg_core::Grid grid;
  kg_core::Mask land;            // 1 = land (no current data).
  kg_core::Raster value;         // B_t in its own unit; NaN = no data.
  std::string value_iri;         // The ex:ValueLayer.
  std::string value_file_iri;
  std::string field_iri;         // The ex:CurrentField whose gaps are land.
  std::string content_hash;      // Of grid, land and value.
};

// Throws std::logic_error if sizes do not agree.
MissionTensor CompileTensor(const kg_core::Mission& mission,
                            const kg_core::Agent& agent,
                            const kg_core::TimeWindow& window,
                            const WindowRasters& rasters);

// The hash CompileTensor would give, without the work: of everything it would
// read, and nothing else. Equal hash = equal tensor.
std::string TensorHash(const kg_core::Mission& mission,
                       const kg_core::Agent& agent,
                       const kg_core::TimeWindow& window,
                       const WindowRasters& rasters);

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_H_
