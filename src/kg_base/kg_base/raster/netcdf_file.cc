#include "kg_base/raster/netcdf_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_base/raster/classic_length.h"

namespace kg_base {
namespace {

constexpr std::size_t kMaxGroups = 1000;
constexpr std::size_t kMaxAttributeLength = std::size_t{64} * 1024;
// Limit of values per read: a slice of the largest supported grid.
constexpr std::size_t kMaxValues = std::size_t{1} << 26;

// Passes only regular files with the right first bytes to the library, which
// would also accept other data sets such as URLs.
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

// Text that is not UTF-8 is taken for Latin-1, in which older programs wrote
// degree signs and names.
std::string AsUtf8(const std::string& text) {
  if (!FirstBadUtf8(text)) return text;
  std::string utf8;
  for (const char c : text) AppendUtf8(static_cast<unsigned char>(c), &utf8);
  return utf8;
}

std::string Stripped(const std::string& text) {
  return AsUtf8(std::string(StripAsciiSpace(text.substr(0, text.find('\0')))));
}

bool IsNumber(int type) {
  return type >= netCDF::NcType::nc_BYTE && type <= netCDF::NcType::nc_UINT64 &&
         type != netCDF::NcType::nc_CHAR;
}

// How many values an integer type of 8 to 32 bits has; 0 for other types.
double IntegerValues(int type) {
  switch (type) {
    case netCDF::NcType::nc_BYTE:
    case netCDF::NcType::nc_UBYTE:
      return 256.0;
    case netCDF::NcType::nc_SHORT:
    case netCDF::NcType::nc_USHORT:
      return 65536.0;
    case netCDF::NcType::nc_INT:
    case netCDF::NcType::nc_UINT:
      return 4294967296.0;
    default:
      return 0.0;
  }
}

// The text of an attribute of type string, which holds exactly one.
std::string StringOf(const netCDF::NcVarAtt& attribute) {
  char* text = nullptr;
  attribute.getValues(&text);
  const std::string copy = text == nullptr ? "" : text;
  // The C library allocated it, and netcdf-c++ has no call that frees it.
  nc_free_string(1, &text);
  return copy;
}

// Reads an attribute; skips long ones and those of irrelevant types.
void ReadAttribute(const netCDF::NcVarAtt& attribute,
                   NetcdfVariable* variable) {
  const std::string name = attribute.getName();
  const netCDF::NcType type = attribute.getType();
  const std::size_t length = attribute.getAttLength();
  if (type.isNull() || length > kMaxAttributeLength) return;
  const int kind = type.getId();
  if (kind == netCDF::NcType::nc_CHAR) {
    std::string text;
    attribute.getValues(text);
    variable->texts[name] = Stripped(text);
  } else if (kind == netCDF::NcType::nc_STRING && length == 1) {
    variable->texts[name] = Stripped(StringOf(attribute));
  } else if (IsNumber(kind)) {
    std::vector<double> values(length);
    attribute.getValues(values.data());
    variable->numbers[name] = values;
  }
}

}  // namespace

std::string NetcdfVariable::Text(const std::string& attribute) const {
  const auto found = texts.find(attribute);
  return found == texts.end() ? "" : found->second;
}

double NetcdfVariable::WithDeclaredSign(double raw) const {
  const auto declared = texts.find("_Unsigned");
  if (declared == texts.end()) return raw;
  const bool is_unsigned = ToLowerAscii(declared->second) == "true";
  const double values = IntegerValues(type);
  if (values == 0.0) return raw;
  if (is_unsigned && raw < 0.0) return raw + values;
  if (!is_unsigned && raw >= values / 2) return raw - values;
  return raw;
}

bool NetcdfVariable::IsVisibleTo(const NetcdfVariable& other) const {
  return other.group_path.compare(0, group_path.size(), group_path) == 0;
}

NetcdfFile::NetcdfFile(const std::string& path) : path_(path) {
  CheckKind(path);
  CheckClassicLength(path);
  try {
    file_.open(path, netCDF::NcFile::read);
    ReadGroup(file_, "");
  } catch (const netCDF::exceptions::NcException& error) {
    Refuse(error);
  }
}

void NetcdfFile::Refuse(const std::string& what) const {
  std::string line = path_ + ": " + what;
  for (char& c : line) {
    // Names in the file may contain control characters.
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  throw InputError(line);
}

void NetcdfFile::Refuse(const NetcdfVariable& variable,
                        const std::string& what) const {
  Refuse("variable " + variable.name + ": " + what);
}

// The first line of the exception's text is the library's own message; the
// second names a line of netcdf-c++'s source.
void NetcdfFile::Refuse(const netCDF::exceptions::NcException& error) const {
  const std::string text = error.what();
  Refuse("damaged, the NetCDF library says: " +
         text.substr(0, text.find('\n')));
}

void NetcdfFile::ReadGroup(const netCDF::NcGroup& group,
                           const std::string& path) {
  groups_.push_back(group);
  ReadDimensions(group);
  const int count = group.getVarCount();
  for (int i = 0; i < count; ++i) {
    variables_.push_back(ReadVariable(netCDF::NcVar(group, i), path));
  }
  for (const auto& child : group.getGroups()) {
    if (groups_.size() >= kMaxGroups) Refuse("expected fewer groups");
    ReadGroup(child.second, path + child.first + "/");
  }
}

// Identifiers of dimensions are unique in the file, and in order of definition.
void NetcdfFile::ReadDimensions(const netCDF::NcGroup& group) {
  std::map<int, netCDF::NcDim> by_id;
  for (const auto& named : group.getDims()) {
    by_id.emplace(named.second.getId(), named.second);
  }
  for (const auto& [id, dimension] : by_id) {
    dimension_index_[id] = static_cast<int>(dimensions_.size());
    dimensions_.push_back({dimension.getName(), dimension.getSize()});
  }
}

NetcdfVariable NetcdfFile::ReadVariable(const netCDF::NcVar& source,
                                        const std::string& path) const {
  NetcdfVariable variable;
  variable.id = source.getId();
  variable.group = groups_.size() - 1;
  variable.group_path = path;
  variable.base_name = source.getName();
  variable.name = path + variable.base_name;
  variable.type = source.getType().getId();
  for (const netCDF::NcDim& dimension : source.getDims()) {
    const auto found = dimension_index_.find(dimension.getId());
    if (found == dimension_index_.end()) {
      Refuse(variable, "damaged, it has a dimension that the file has not");
    }
    variable.dimensions.push_back(found->second);
  }
  const int attributes = source.getAttCount();
  for (int i = 0; i < attributes; ++i) {
    ReadAttribute(netCDF::NcVarAtt(groups_.back(), source, i), &variable);
  }
  return variable;
}

netCDF::NcVar NetcdfFile::Source(const NetcdfVariable& variable) const {
  return netCDF::NcVar(groups_.at(variable.group), variable.id);
}

std::size_t NetcdfFile::ChunkLength(const NetcdfVariable& variable,
                                    std::size_t position) const {
  netCDF::NcVar::ChunkMode mode = netCDF::NcVar::nc_CONTIGUOUS;
  std::vector<std::size_t> lengths;
  try {
    Source(variable).getChunkingParameters(mode, lengths);
  } catch (const netCDF::exceptions::NcException& error) {
    return 1;  // Formats without chunks.
  }
  if (mode != netCDF::NcVar::nc_CHUNKED || position >= lengths.size()) return 1;
  return std::max<std::size_t>(lengths[position], 1);
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
    // Test n first: the product of two numbers within the limit cannot
    // overflow.
    if (n > kMaxValues || size * n > kMaxValues) {
      Refuse(variable, "expected at most " + std::to_string(kMaxValues) +
                           " values at a time");
    }
    size *= n;
  }
  std::vector<double> values(size);
  if (size == 0) return values;
  try {
    const netCDF::NcVar source = Source(variable);
    if (count.empty()) {  // A scalar, which has no first index to point to.
      source.getVar(values.data());
    } else {
      source.getVar(start, count, values.data());
    }
  } catch (const netCDF::exceptions::NcException& error) {
    Refuse(error);
  }
  for (double& value : values) value = variable.WithDeclaredSign(value);
  return values;
}

}  // namespace kg_base
