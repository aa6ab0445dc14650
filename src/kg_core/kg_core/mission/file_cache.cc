// The rasters behind the typed references, each file read once.

#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_core/mission/ingest.h"
#include "kg_core/mission/terms.h"

namespace kg_core {
namespace {

namespace fs = std::filesystem;

// A file that is written anew is read anew.
std::string KeyOf(const std::string& path,
                  const std::vector<Quantity>& wanted) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error) throw InputError(path + ": cannot be read: " + error.message());
  const auto time = fs::last_write_time(path, error);
  std::string key = path + "|" + std::to_string(size) + "|" +
                    std::to_string(time.time_since_epoch().count());
  for (const Quantity quantity : wanted) {
    key += std::string("|") + Name(quantity);
  }
  return key;
}

// The file that facts refer to; refused if it is another one by now.
std::shared_ptr<const OceanFile> ReadReferred(
    FileCache& cache, const Mission& mission, const std::string& file_iri,
    const std::vector<Quantity>& wanted) {
  const auto found = mission.files.find(file_iri);
  if (found == mission.files.end()) {
    throw InputError(ToTurtle(Iri(file_iri)) + ": expected an ex:SourceFile");
  }
  const SourceFile& file = found->second;
  std::shared_ptr<const OceanFile> ocean = cache.Read(file.path, wanted);
  if (ocean->sha256 != file.sha256) {
    throw InputError(file.path +
                     ": has changed since it was ingested: sha256 " +
                     ocean->sha256 + ", expected " + file.sha256);
  }
  return ocean;
}

const Raster& StepAt(const OceanFile& file, std::size_t series, int index) {
  const std::vector<Raster>& steps = file.series.at(series).at_time;
  if (index >= 0 && index < static_cast<int>(steps.size())) {
    return steps[index];
  }
  throw InputError(file.path + ": has " + std::to_string(steps.size()) +
                   " time steps, none with index " + std::to_string(index));
}

Raster AbsoluteDifference(const Raster& a, const Raster& b) {
  Raster difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference[i] = std::abs(a[i] - b[i]);
  }
  return difference;
}

}  // namespace

FileCache::FileCache(std::string mission_folder, std::string data_folder)
    : mission_folder_(std::move(mission_folder)),
      data_folder_(std::move(data_folder)) {}

std::string FileCache::Resolve(const std::string& file) const {
  const fs::path name(file);
  std::string tried;
  for (const std::string& folder : {data_folder_, mission_folder_}) {
    if (folder.empty() && name.is_relative()) continue;
    const fs::path path = fs::absolute(fs::path(folder) / name);
    std::error_code error;
    if (fs::is_regular_file(path, error)) {
      return path.lexically_normal().string();
    }
    tried += (tried.empty() ? "" : ", ") + path.lexically_normal().string();
    if (name.is_absolute()) break;
  }
  throw InputError("file \"" + file + "\" is not there; looked for " +
                   (tried.empty() ? "it nowhere: no folder is given" : tried));
}

std::shared_ptr<const OceanFile> FileCache::Read(
    const std::string& path, const std::vector<Quantity>& wanted) {
  const std::string key = KeyOf(path, wanted);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto known = files_.find(key);
    if (known != files_.end()) return known->second;
  }
  auto file =
      std::make_shared<const OceanFile>(ReadOceanFileSafely(path, wanted));
  const std::lock_guard<std::mutex> lock(mutex_);
  return files_.emplace(key, std::move(file)).first->second;
}

VectorField LoadWorkField(FileCache& cache, const Mission& mission,
                          const WorkFieldRef& field) {
  const auto file =
      ReadReferred(cache, mission, field.file_iri,
                   {Quantity::kEastwardVelocity, Quantity::kNorthwardVelocity});
  VectorField loaded;
  loaded.grid = file->grid;
  for (int i = field.first_time_index; i <= field.last_time_index; ++i) {
    const Raster& east_mps = StepAt(*file, 0, i);
    loaded.slices.push_back(
        {file->time_s.at(i), east_mps, StepAt(*file, 1, i)});
  }
  return loaded;
}

Raster LoadValueLayer(FileCache& cache, const Mission& mission,
                      const ValueLayer& layer, const Grid& grid) {
  const auto file =
      ReadReferred(cache, mission, layer.file_iri, {Quantity::kTemperature});
  Raster values = StepAt(*file, 0, layer.time_index);
  if (layer.kind == kDifferenceKind) {
    values =
        AbsoluteDifference(values, StepAt(*file, 0, layer.previous_time_index));
  }
  if (file->grid.AlmostEquals(grid)) return values;
  return ResampleBilinear(file->grid, values, grid);
}

}  // namespace kg_core
