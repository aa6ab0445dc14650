// Cache of the rasters a mission refers to, read on first use and kept while in
// use: work fields, and per window the inputs of the data plane. Data shared by
// several windows (time steps, priors, masks) is stored once.
//
// The mission's grid is that of its work fields, one for all windows. Rasters
// on other grids are resampled as their facts declare (kg_core's
// layer_files.h).

#ifndef KG_COMPILER_COMPILE_RASTER_STORE_H_
#define KG_COMPILER_COMPILE_RASTER_STORE_H_

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "kg_base/raster/vector_field.h"
#include "kg_compiler/data_plane/data_plane.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

struct WorkField {
  int window = 0;
  std::string iri;
  kg_base::VectorField field;
  std::string hash;
};

// Source of rasters: kg_core's files, or generated data in tests.
struct RasterReaders {
  std::function<kg_base::VectorField(const kg_mission::Mission&,
                                     const kg_mission::WorkFieldRef&)>
      field;
  std::function<kg_base::Raster(const kg_mission::Mission&,
                                const kg_mission::ValueLayer&,
                                const kg_base::Grid&)>
      value;
  // Reads the raster of the prior or constraint `iri`, resampled as the
  // reference says. May be empty if a mission has none from files.
  std::function<kg_base::Raster(
      const kg_mission::Mission&, const std::string& iri,
      const kg_mission::RasterRef&, const kg_base::Grid&)>
      raster = nullptr;
};
// A value layer of kind "frontness" is the gradient, taken on its own grid.
RasterReaders ReadersOf(kg_mission::FileCache* files);

class RasterStore {
 public:
  explicit RasterStore(RasterReaders readers);

  // Throws InputError if the window has no work field, its file fails, or its
  // grid is not that of the other windows.
  std::shared_ptr<const WorkField> Field(const kg_mission::Mission& mission,
                                         int window);
  // The value layer has the kind stated by the policy; of several the latest
  // one is used (A29). Throws InputError if there is none, if two have the same
  // time, or if the policy requires a scale that the layer does not have. A
  // policy that reads no value (alpha = gamma = 0) gets a raster without data.
  // Includes the rasters of priors weighted by the policy, and the masks of all
  // constraints in force in the window.
  std::shared_ptr<const WindowRasters> Rasters(
      const kg_mission::Mission& mission, const kg_mission::Policy& policy,
      const WorkField& field);
  // Drops entries not used since the last call.
  void ForgetUnused();

 private:
  template <typename T>
  struct Kept {
    std::shared_ptr<const T> value;
    bool used = true;
  };

  // Rasters of a window's priors and constraints read from files, and their
  // key.
  struct FromFiles {
    std::map<std::string, std::shared_ptr<const kg_base::Raster>> priors;
    std::map<std::string, std::shared_ptr<const kg_base::Mask>> masks;
    std::map<std::string, std::shared_ptr<const kg_base::Mask>> avoided_masks;
    std::string key;
  };
  struct HashedGrid {
    kg_base::Grid grid;
    std::string hash;  // Empty until it is needed.
  };
  struct FileRequest {
    const kg_mission::Mission* mission;
    std::string iri;  // Of the prior or constraint.
    kg_mission::RasterRef ref;
    HashedGrid* grid;
  };
  // The entry in `kept`, computed by `make` from the raster read if it is new;
  // its key is appended to `read`.
  template <typename T, typename Make>
  std::shared_ptr<const T> Keep(const FileRequest& request,
                                std::map<std::string, Kept<T>>* kept,
                                const Make& make, std::string* read);
  FromFiles ReadFiles(const kg_mission::Mission& mission,
                      const kg_mission::Policy& policy, const WorkField& field);
  // Masks of forbidden places cover every cell that they touch, also those of
  // soft zones for agents that must avoid them.
  void ReadMask(const kg_mission::Mission& mission,
                const kg_mission::Constraint& constraint, HashedGrid* grid,
                FromFiles* read);
  void CheckGrid(const kg_mission::Mission& mission,
                 const WorkField& field) const;

  RasterReaders readers_;
  // Keyed by all inputs: IRIs of facts, sha256 of files, time indices.
  std::map<std::string, Kept<WorkField>> fields_;
  std::map<std::string, Kept<WindowRasters>> rasters_;
  std::map<std::string, Kept<kg_base::Raster>> priors_;
  std::map<std::string, Kept<kg_base::Mask>> masks_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_COMPILE_RASTER_STORE_H_
