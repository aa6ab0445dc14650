// Cache of the rasters of files referred to by facts. A file is read once, in a
// child process (ReadFieldFileSafely), and read again when it changes on disk.

#ifndef KG_MISSION_MISSION_FILE_CACHE_H_
#define KG_MISSION_MISSION_FILE_CACHE_H_

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "kg_base/raster/field_file.h"

namespace kg_mission {

// Thread-safe. Two threads that request a new file at the same time may both
// read it; they get the same rasters.
class FileCache {
 public:
  // `data_folder`: first search folder for relative ex:file names (launch
  // argument data:=), followed by `mission_folder`.
  FileCache(std::string mission_folder, std::string data_folder);

  // The absolute path of a file named by facts; throws InputError.
  std::string Resolve(const std::string& file) const;
  // Both throw InputError (unreadable, truncated, missing variable, ...).
  std::shared_ptr<const kg_base::FieldFile> Read(
      const std::string& path,
      const std::vector<kg_base::FieldQuantity>& wanted);
  std::shared_ptr<const kg_base::FieldFile> ReadVariable(
      const std::string& path, const std::string& variable);

 private:
  struct Held {
    std::string version;  // Size and modification time of the file on disk.
    std::shared_ptr<const kg_base::FieldFile> contents;
  };
  std::shared_ptr<const kg_base::FieldFile> Get(
      const std::string& path, const std::string& wanted,
      const std::function<kg_base::FieldFile()>& read);

  std::string mission_folder_;
  std::string data_folder_;
  // Guards files_; not held while reading a file.
  std::mutex mutex_;
  std::map<std::string, Held> files_;  // Keyed by path and requested content.
};

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_FILE_CACHE_H_
