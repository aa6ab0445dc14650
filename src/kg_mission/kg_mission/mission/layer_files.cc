#include "kg_mission/mission/layer_files.h"

#include <cmath>
#include <memory>

#include "kg_base/common/input_error.h"
#include "kg_base/raster/resample.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/source_quantities.h"

namespace kg_mission {
namespace {

using kg_base::FieldQuantity;
using kg_base::Grid;
using kg_base::InputError;
using kg_base::Raster;
using kg_base::Resampling;
using kg_base::SharedRaster;
using kg_core::SourceFile;

using File = std::shared_ptr<const kg_base::FieldFile>;

const SourceFile& FindFile(const Mission& mission, const std::string& iri) {
  const auto found = mission.files.find(iri);
  if (found != mission.files.end()) return found->second;
  throw InputError(kg_core::ToTurtle(kg_core::Iri(iri)) +
                   ": expected an ex:SourceFile");
}

// Throws InputError if the file's sha256 differs from that in the facts.
File Checked(File ocean, const SourceFile& file) {
  if (ocean->sha256 == file.sha256) return ocean;
  throw InputError(file.path + ": has changed since it was ingested: sha256 " +
                   ocean->sha256 + ", expected " + file.sha256);
}

File ReadReferred(FileCache& cache, const Mission& mission,
                  const std::string& iri,
                  const std::vector<FieldQuantity>& wanted) {
  const SourceFile& file = FindFile(mission, iri);
  return Checked(cache.Read(file.path, wanted), file);
}

// One time step of a file; shares ownership of the whole file.
SharedRaster StepAt(const File& file, std::size_t series, int index) {
  const std::vector<Raster>& steps = file->series.at(series).at_time;
  if (index >= 0 && index < static_cast<int>(steps.size())) {
    return SharedRaster(std::shared_ptr<const Raster>(file, &steps[index]));
  }
  throw InputError(file->path + ": has " + std::to_string(steps.size()) +
                   " time steps, none with index " + std::to_string(index));
}

Raster AbsoluteDifference(const Raster& a, const Raster& b) {
  Raster difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference[i] = std::abs(a[i] - b[i]);
  }
  return difference;
}

// Loads a cost field on the grid of the velocity field, for the time steps
// named in the facts.
kg_base::ScalarField LoadCostField(FileCache& cache, const Mission& mission,
                                   const CostFieldRef& field,
                                   const Grid& grid) {
  const File file = ReadReferred(cache, mission, field.file_iri,
                                 FindFieldQuantity(field.quantity).components);
  kg_base::ScalarField loaded;
  loaded.quantity = field.quantity;
  for (int i = field.first_time_index; i <= field.last_time_index; ++i) {
    const SharedRaster values = StepAt(file, 0, i);
    loaded.slices.push_back(
        {file->time_s.at(i),
         OnGrid(field.iri, {file->grid, values}, grid, field.resampling)});
  }
  return loaded;
}

bool Overlap(const Grid& a, const Grid& b) {
  return a.west_deg() < b.east_deg() && b.west_deg() < a.east_deg() &&
         a.south_deg() < b.north_deg() && b.south_deg() < a.north_deg();
}

}  // namespace

kg_base::VectorField LoadWorkField(FileCache& cache, const Mission& mission,
                                   const WorkFieldRef& field) {
  const File file = ReadReferred(
      cache, mission, field.file_iri,
      {FieldQuantity::kEastwardVelocity, FieldQuantity::kNorthwardVelocity});
  kg_base::VectorField loaded;
  loaded.grid = file->grid;
  for (int i = field.first_time_index; i <= field.last_time_index; ++i) {
    const SharedRaster east_mps = StepAt(file, 0, i);
    loaded.slices.push_back({file->time_s.at(i), east_mps, StepAt(file, 1, i)});
  }
  for (const CostFieldRef& cost : mission.cost_fields) {
    if (cost.window != field.window) continue;
    loaded.scalars.push_back(LoadCostField(cache, mission, cost, loaded.grid));
  }
  return loaded;
}

GriddedRaster LoadValueLayer(FileCache& cache, const Mission& mission,
                             const ValueLayer& layer) {
  const File file = ReadReferred(cache, mission, layer.file_iri,
                                 {FieldQuantity::kTemperature});
  const SharedRaster now = StepAt(file, 0, layer.time_index);
  if (layer.kind != kDifferenceKind) return {file->grid, now};
  const SharedRaster before = StepAt(file, 0, layer.previous_time_index);
  return {file->grid, AbsoluteDifference(now, before)};
}

GriddedRaster LoadRaster(FileCache& cache, const Mission& mission,
                         const RasterRef& ref) {
  const SourceFile& source = FindFile(mission, ref.file_iri);
  const File file =
      Checked(cache.ReadVariable(source.path, ref.variable), source);
  return {file->grid, StepAt(file, 0, ref.time_index)};
}

void CheckGrids(const std::string& layer, const Grid& own,
                const Grid& mission_grid, Resampling declared) {
  if (own.AlmostEquals(mission_grid)) return;
  const std::string name = kg_core::ToTurtle(kg_core::Iri(layer));
  const std::string grids = "its grid (" + own.Text() +
                            ") is not the mission's, that of the work " +
                            "fields (" + mission_grid.Text() + ")";
  if (declared == Resampling::kNone) {
    throw InputError(name + " ex:resampling: expected \"nearest\", or " +
                     "\"bilinear\" unless it is a mask, because " + grids);
  }
  if (!Overlap(own, mission_grid)) {
    throw InputError(name +
                     ": expected a raster of the mission's region, but " +
                     grids + " and they have no place in common");
  }
}

SharedRaster OnGrid(const std::string& layer, const GriddedRaster& raster,
                    const Grid& mission_grid, Resampling declared) {
  CheckGrids(layer, raster.grid, mission_grid, declared);
  if (raster.grid.AlmostEquals(mission_grid)) return raster.values;
  return kg_base::Resample(raster.grid, raster.values, mission_grid, declared);
}

kg_base::Mask MakeMask(const Raster& values) {
  kg_base::Mask mask(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    mask[i] = !std::isnan(values[i]) && values[i] != 0.0f ? 1 : 0;
  }
  return mask;
}

}  // namespace kg_mission
