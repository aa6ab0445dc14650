#include "kg_engine/export/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "kg_base/common/input_error.h"

namespace kg_engine {
namespace {

namespace fs = std::filesystem;
using kg_base::InputError;

// Deleted on destruction unless it has been renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path)
      : path_(path + ".part" + std::to_string(::getpid())) {}
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

[[noreturn]] void Refuse(const std::string& path, const std::string& why) {
  throw InputError(path + ": cannot be written: " + why);
}

}  // namespace

void WriteAtomically(const std::string& path,
                     absl::FunctionRef<void(const std::string& path)> write) {
  if (!fs::path(path).is_absolute()) {
    throw InputError("path '" + path + "': expected an absolute path");
  }
  std::error_code error;
  if (fs::is_directory(path, error)) Refuse(path, "it is a folder");
  const TemporaryFile temporary(path);
  write(temporary.path());
  fs::rename(temporary.path(), path, error);
  if (error) Refuse(path, error.message());
}

void WriteAtomically(const std::string& path, std::string_view text) {
  WriteAtomically(path, [&](const std::string& temporary) {
    errno = 0;
    std::ofstream file(temporary, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) Refuse(path, std::strerror(errno == 0 ? EIO : errno));
  });
}

}  // namespace kg_engine
