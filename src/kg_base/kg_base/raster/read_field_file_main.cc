// read_field_file FILE DEADLINE_S (QUANTITY... | variable=NAME): reads a
// gridded file and writes its contents, or an error line, to its standard
// output in the format of field_protocol.h. A separate process, because damaged
// NetCDF-4 files can hang or crash the library; it also terminates itself soon
// after its deadline, in case its parent has died. Exits 0 when all output was
// written.

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "kg_base/raster/field_protocol.h"
#include "kg_base/raster/read_field_file.h"

namespace {

using kg_base::FieldQuantity;

// Far more than kMaxFieldValues needs, but bounds a runaway library.
constexpr rlim_t kMaxAddressSpace = rlim_t{8} << 30;

void LimitMyself(double deadline_s) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const rlimit memory{kMaxAddressSpace, kMaxAddressSpace};
  setrlimit(RLIMIT_AS, &memory);
#endif
  alarm(static_cast<unsigned>(std::ceil(deadline_s)) + 1);
}

void Put(const void* bytes, std::size_t count) {
  const char* at = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = write(STDOUT_FILENO, at, count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(1);  // The reader has closed the pipe.
    at += written;
    count -= static_cast<std::size_t>(written);
  }
}

std::vector<FieldQuantity> Quantities(int argc, char** argv) {
  std::vector<FieldQuantity> quantities;
  for (int i = 3; i < argc; ++i) {
    quantities.push_back(static_cast<FieldQuantity>(std::atoi(argv[i])));
  }
  return quantities;
}

kg_base::FieldFile Read(int argc, char** argv) {
  const std::string wanted = argv[3];
  const std::string by_name = kg_base::kVariableArgument;
  if (wanted.compare(0, by_name.size(), by_name) == 0) {
    return kg_base::ReadVariable(argv[1], wanted.substr(by_name.size()));
  }
  return kg_base::ReadFieldFile(argv[1], Quantities(argc, argv));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  LimitMyself(std::atof(argv[2]));
  try {
    kg_base::WriteFieldFile(Read(argc, argv), Put);
  } catch (const std::exception& error) {
    kg_base::WriteFieldError(error.what(), Put);
  }
  // Not exit(): cleanup in the library may fail after a damaged file.
  _exit(0);
}
