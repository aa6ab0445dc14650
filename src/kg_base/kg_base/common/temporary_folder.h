// A temporary folder for tests that need files; removed by the destructor.

#ifndef KG_BASE_COMMON_TEMPORARY_FOLDER_H_
#define KG_BASE_COMMON_TEMPORARY_FOLDER_H_

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace kg_base {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    path_ = (std::filesystem::temp_directory_path() / "kg_XXXXXX").string();
    if (mkdtemp(path_.data()) == nullptr) {
      throw std::runtime_error(path_ + ": no temporary folder can be made");
    }
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const {
    return path_ + "/" + name;
  }

 private:
  std::string path_;
};

}  // namespace kg_base

#endif  // KG_BASE_COMMON_TEMPORARY_FOLDER_H_
