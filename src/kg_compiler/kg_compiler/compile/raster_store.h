// The rasters a mission refers to, read when first wanted and kept while
// wanted: work fields, and per window what the data plane reads. What several
// windows read (time steps, priors, masks) is held once.
//
// The mission's grid is that of its work fields, one for all windows. What is
// on another grid comes to it as its facts declare (kg_core's layer_files.h).

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

// Where rasters come from: kg_core's files, or what a test makes up.
struct RasterReaders {
  std::function<kg_base::VectorField(const kg_mission::Mission&,
                                     const kg_mission::WorkFieldRef&)>
      field;
  std::function<kg_base::Raster(const kg_mission::Mission&,
                                const kg_mission::ValueLayer&,
                                const kg_base::Grid&)>
      value;
  // Of the prior or constraint of that IRI. May be absent where a mission has
  // none from files.
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
  // The value layer is the policy's kind's; of several the one with the latest
  // time (A29). Throws InputError if there is none, or two of one time, or if
  // the policy wants a scale that the layer does not have. A policy that reads
  // no value (alpha = gamma = 0) gets a raster without data. Prior rasters are
  // those that the policy weighs, masks those of all constraints in force in
  // the window.
  std::shared_ptr<const WindowRasters> Rasters(
      const kg_mission::Mission& mission, const kg_mission::Policy& policy,
      const WorkField& field);
  // Forgets what was not asked for since the last time.
  void ForgetUnused();

 private:
  template <typename T>
  struct Kept {
    std::shared_ptr<const T> value;
    bool used = true;
  };

  // What a window's priors and constraints read from files, and its key.
  struct FromFiles {
    std::map<std::string, std::shared_ptr<const kg_base::Raster>> priors;
    std::map<std::string, std::shared_ptr<const kg_base::Mask>> masks;
    std::string key;
  };
  FromFiles ReadFiles(const kg_mission::Mission& mission,
                      const kg_mission::Policy& policy, const WorkField& field);
  void CheckGrid(const kg_mission::Mission& mission,
                 const WorkField& field) const;

  RasterReaders readers_;
  // By all that they are made of: facts' IRIs, files' sha256, time indices.
  std::map<std::string, Kept<WorkField>> fields_;
  std::map<std::string, Kept<WindowRasters>> rasters_;
  std::map<std::string, Kept<kg_base::Raster>> priors_;
  std::map<std::string, Kept<kg_base::Mask>> masks_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_COMPILE_RASTER_STORE_H_
