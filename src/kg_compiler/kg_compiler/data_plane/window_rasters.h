// Rasters that the data plane reads for one window, all on one grid.

#ifndef KG_COMPILER_DATA_PLANE_WINDOW_RASTERS_H_
#define KG_COMPILER_DATA_PLANE_WINDOW_RASTERS_H_

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "kg_base/raster/grid.h"

namespace kg_compiler {

// Agent-independent inputs of one window.
struct WindowRasters {
  kg_base::Grid grid;
  kg_base::Mask land;     // 1 = land (no current data).
  kg_base::Raster value;  // B_t in its own unit; NaN = no data.
  std::string value_iri;  // The ex:ValueLayer.
  std::string value_file_iri;
  std::string field_iri;     // The ex:CurrentField whose gaps are land.
  std::string content_hash;  // Hash of grid, land and value.
  std::string land_hash;     // Hash of grid and land.
  // ex:fullScale and ex:frontFullScale of the value layer, if it has them.
  std::optional<double> full_scale;
  std::optional<double> front_full_scale;
  // Rasters read from files, on this grid: values of priors (NaN = no data) and
  // masks of constraints (1 = inside), by IRI. The files' sha256 identify them,
  // so they need no hash here. A mask from another grid is on this one extended
  // by BufferMargin (masks.h).
  std::map<std::string, std::shared_ptr<const kg_base::Raster>> prior_rasters;
  std::map<std::string, std::shared_ptr<const kg_base::Mask>> constraint_masks;
  // The masks of soft zones from another grid, for agents that must avoid them:
  // every cell that a masked cell touches.
  std::map<std::string, std::shared_ptr<const kg_base::Mask>> avoided_masks;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_WINDOW_RASTERS_H_
