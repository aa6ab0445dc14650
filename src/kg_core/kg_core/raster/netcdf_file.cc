#include "kg_core/raster/netcdf_file.h"

#include <sys/stat.h>

#include <fstream>

#include "kg_core/base/input_error.h"
#include "kg_core/base/text.h"
#include "kg_core/raster/classic_length.h"

namespace kg_core {
namespace {

constexpr std::size_t kMaxAttributeLength = 64 * 1024;
// Of one read: a slice of the largest grid believed.
constexpr std::size_t kMaxValues = std::size_t{1} << 26;

// Only a regular file with the right first bytes reaches the library, which
// would take other things, addresses for one, for data sets too.
void CheckKind(const std::string& path) {
  struct stat status;
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
    throw InputError(path + ": expected a file that exists");
  }
  char first[4] = {};
  std::ifstream(path, std::ios::binary).read(first, sizeof(first));
  const std::string magic(first, sizeof(first));
  if (magic != "\x89HDF" && magic != std::string("CDF\1") &&
      magic != std::string("CDF\2") && magic != std::string("CDF\5")) {
    throw InputError(path + ": expected a NetCDF file (classic or 4)");
  }
}

std::string Stripped(const std::string& text) {
  return std::string(StripAsciiSpace(text.substr(0, text.find('\0'))));
}

bool IsNumber(nc_type type) {
  return type >= NC_BYTE && type <= NC_UINT64 && type != NC_CHAR;
}

}  // namespace

std::string NetcdfVariable::Text(const std::string& attribute) const {
  const auto found = texts.find(attribute);
  return found == texts.end() ? "" : found->second;
}

NetcdfFile::NetcdfFile(const std::string& path) : path_(path) {
  CheckKind(path);
  CheckClassicLength(path);
  Check(nc_open(path.c_str(), NC_NOWRITE, &id_));
  try {
    ReadDimensions();
    ReadVariables();
  } catch (...) {
    nc_close(id_);
    throw;
  }
}

NetcdfFile::~NetcdfFile() { nc_close(id_); }

void NetcdfFile::Refuse(const std::string& what) const {
  std::string line = path_ + ": " + what;
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';  // Of names in the file.
  }
  throw InputError(line);
}

void NetcdfFile::Refuse(const NetcdfVariable& variable,
                        const std::string& what) const {
  Refuse("variable " + variable.name + ": " + what);
}

void NetcdfFile::Check(int status) const {
  if (status != NC_NOERR) {
    Refuse(std::string("damaged, the NetCDF library says: ") +
           nc_strerror(status));
  }
}

void NetcdfFile::ReadDimensions() {
  int count = 0;
  Check(nc_inq_ndims(id_, &count));
  // Root group's dimensions have the identifiers 0, 1, ...
  for (int i = 0; i < count; ++i) {
    char name[NC_MAX_NAME + 1] = {};
    NetcdfDimension dimension;
    Check(nc_inq_dim(id_, i, name, &dimension.size));
    dimension.name = name;
    dimensions_.push_back(dimension);
  }
}

void NetcdfFile::ReadVariables() {
  int count = 0;
  Check(nc_inq_nvars(id_, &count));
  for (int i = 0; i < count; ++i) variables_.push_back(ReadVariable(i));
}

NetcdfVariable NetcdfFile::ReadVariable(int id) const {
  NetcdfVariable variable;
  variable.id = id;
  char name[NC_MAX_NAME + 1] = {};
  int rank = 0;
  int attributes = 0;
  Check(nc_inq_varndims(id_, id, &rank));
  variable.dimensions.resize(static_cast<std::size_t>(rank));
  Check(nc_inq_var(id_, id, name, &variable.type, &rank,
                   variable.dimensions.data(), &attributes));
  variable.name = name;
  for (const int dimension : variable.dimensions) {
    if (dimension < 0 || dimension >= static_cast<int>(dimensions_.size())) {
      Refuse(variable, "damaged, it has a dimension that the file has not");
    }
  }
  for (int i = 0; i < attributes; ++i) {
    Check(nc_inq_attname(id_, id, i, name));
    ReadAttribute(name, &variable);
  }
  return variable;
}

// Long attributes, and those of types that mean nothing here, are left out.
void NetcdfFile::ReadAttribute(const std::string& name,
                               NetcdfVariable* variable) const {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  const char* key = name.c_str();
  Check(nc_inq_att(id_, variable->id, key, &type, &length));
  if (length > kMaxAttributeLength) return;
  if (type == NC_CHAR) {
    std::string text(length, '\0');
    Check(nc_get_att_text(id_, variable->id, key, &text[0]));
    variable->texts[name] = Stripped(text);
  } else if (type == NC_STRING && length == 1) {
    char* text = nullptr;
    Check(nc_get_att_string(id_, variable->id, key, &text));
    variable->texts[name] = Stripped(text == nullptr ? "" : text);
    nc_free_string(1, &text);
  } else if (IsNumber(type)) {
    std::vector<double> values(length);
    Check(nc_get_att_double(id_, variable->id, key, values.data()));
    variable->numbers[name] = values;
  }
}

std::vector<double> NetcdfFile::Values(const NetcdfVariable& variable) const {
  std::vector<std::size_t> count;
  for (const int d : variable.dimensions) count.push_back(dimensions_[d].size);
  return Values(variable, std::vector<std::size_t>(count.size(), 0), count);
}

std::vector<double> NetcdfFile::Values(
    const NetcdfVariable& variable, const std::vector<std::size_t>& start,
    const std::vector<std::size_t>& count) const {
  if (!IsNumber(variable.type)) Refuse(variable, "expected numbers");
  std::size_t size = 1;
  for (const std::size_t n : count) {
    if (n > kMaxValues || size * n > kMaxValues) {
      Refuse(variable, "expected at most " + std::to_string(kMaxValues) +
                           " values at a time");
    }
    size *= n;
  }
  std::vector<double> values(size);
  if (size == 0) return values;
  Check(nc_get_vara_double(id_, variable.id, start.data(), count.data(),
                           values.data()));
  return values;
}

}  // namespace kg_core
