#include "kg_core/mission/layer_files.h"

#include <cmath>
#include <memory>

#include "kg_core/base/input_error.h"
#include "kg_core/mission/terms.h"
#include "kg_core/raster/resample.h"

namespace kg_core {
namespace {

using File = std::shared_ptr<const FieldFile>;

const SourceFile& FindFile(const Mission& mission, const std::string& iri) {
  const auto found = mission.files.find(iri);
  if (found != mission.files.end()) return found->second;
  throw InputError(ToTurtle(Iri(iri)) + ": expected an ex:SourceFile");
}

// Refused if it is another one than facts refer to by now.
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

// Lives as long as the whole file does.
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

bool Overlap(const Grid& a, const Grid& b) {
  return a.west_deg() < b.east_deg() && b.west_deg() < a.east_deg() &&
         a.south_deg() < b.north_deg() && b.south_deg() < a.north_deg();
}

}  // namespace

VectorField LoadWorkField(FileCache& cache, const Mission& mission,
                          const WorkFieldRef& field) {
  const File file = ReadReferred(
      cache, mission, field.file_iri,
      {FieldQuantity::kEastwardVelocity, FieldQuantity::kNorthwardVelocity});
  VectorField loaded;
  loaded.grid = file->grid;
  for (int i = field.first_time_index; i <= field.last_time_index; ++i) {
    const SharedRaster east_mps = StepAt(file, 0, i);
    loaded.slices.push_back({file->time_s.at(i), east_mps, StepAt(file, 1, i)});
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
  const std::string name = ToTurtle(Iri(layer));
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
  return Resample(raster.grid, raster.values, mission_grid, declared);
}

Mask MaskOf(const Raster& values) {
  Mask mask(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    mask[i] = !std::isnan(values[i]) && values[i] != 0.0f ? 1 : 0;
  }
  return mask;
}

}  // namespace kg_core
