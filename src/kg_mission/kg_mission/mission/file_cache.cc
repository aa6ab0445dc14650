#include "kg_mission/mission/file_cache.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_base/raster/field_child.h"

namespace kg_mission {
namespace {

using kg_base::FieldFile;

namespace fs = std::filesystem;

std::string ComputeVersion(const std::string& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error) {
    throw kg_base::InputError(path + ": cannot be read: " + error.message());
  }
  const auto time = fs::last_write_time(path, error);
  return std::to_string(size) + "|" +
         std::to_string(time.time_since_epoch().count());
}

}  // namespace

FileCache::FileCache(std::string mission_folder, std::string data_folder)
    : mission_folder_(std::move(mission_folder)),
      data_folder_(std::move(data_folder)) {}

std::string FileCache::Resolve(const std::string& file) const {
  const fs::path name(file);
  std::vector<std::string> tried;
  for (const std::string& folder : {data_folder_, mission_folder_}) {
    if (folder.empty() && name.is_relative()) continue;
    const fs::path path = fs::absolute(fs::path(folder) / name);
    std::error_code error;
    if (fs::is_regular_file(path, error)) {
      return path.lexically_normal().string();
    }
    tried.push_back(path.lexically_normal().string());
    if (name.is_absolute()) break;
  }
  throw kg_base::InputError("file \"" + file + "\" not found; looked for " +
                            (tried.empty() ? "it nowhere: no folder is given"
                                           : kg_base::JoinStrings(tried)));
}

std::shared_ptr<const FieldFile> FileCache::Read(
    const std::string& path,
    const std::vector<kg_base::FieldQuantity>& wanted) {
  std::string names;
  for (const kg_base::FieldQuantity quantity : wanted) {
    names += std::string("|") + kg_base::Name(quantity);
  }
  return Get(path, names,
             [&] { return kg_base::ReadFieldFileSafely(path, wanted); });
}

std::shared_ptr<const FieldFile> FileCache::ReadVariable(
    const std::string& path, const std::string& variable) {
  return Get(path, "#" + variable,
             [&] { return kg_base::ReadVariableSafely(path, variable); });
}

std::shared_ptr<const FieldFile> FileCache::Get(
    const std::string& path, const std::string& wanted,
    const std::function<FieldFile()>& read) {
  const std::string version = ComputeVersion(path);
  const auto known = [&]() -> std::shared_ptr<const FieldFile> {
    const auto found = files_.find(path + wanted);
    if (found == files_.end() || found->second.version != version) return {};
    return found->second.contents;
  };
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto file = known()) return file;
  }
  auto file = std::make_shared<const FieldFile>(read());
  const std::lock_guard<std::mutex> lock(mutex_);
  if (const auto other = known()) return other;
  files_[path + wanted] = {version, file};
  return file;
}

}  // namespace kg_mission
