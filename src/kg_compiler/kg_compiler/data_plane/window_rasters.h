// What the data plane reads of one window, all on one grid.

#ifndef KG_COMPILER_DATA_PLANE_WINDOW_RASTERS_H_
#define KG_COMPILER_DATA_PLANE_WINDOW_RASTERS_H_

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "kg_base/raster/grid.h"

namespace kg_compiler {

// What does not depend on the agent, for one window.
struct WindowRasters {
  kg_base::Grid grid;
  kg_base::Mask land;     // 1 = land (no current data).
  kg_base::Raster value;  // B_t in its own unit; NaN = no data.
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
  std::map<std::string, std::shared_ptr<const kg_base::Raster>> prior_rasters;
  std::map<std::string, std::shared_ptr<const kg_base::Mask>> constraint_masks;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_DATA_PLANE_WINDOW_RASTERS_H_
