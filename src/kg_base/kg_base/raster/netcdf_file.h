// Dimensions, variables and attributes of a NetCDF file as plain values, and
// its data, read with netcdf-c++. Root group only.

#ifndef KG_BASE_RASTER_NETCDF_FILE_H_
#define KG_BASE_RASTER_NETCDF_FILE_H_

#include <cstddef>
#include <map>
#include <netcdf>
#include <string>
#include <vector>

namespace kg_base {

struct NetcdfDimension {
  std::string name;
  std::size_t size = 0;
};

struct NetcdfVariable {
  int id = 0;
  std::string name;
  int type = 0;  // A netCDF::NcType::ncType, or a user-defined type.
  std::vector<int> dimensions;
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<double>> numbers;

  std::string Text(const std::string& attribute) const;  // "" if absent.
};

class NetcdfFile {
 public:
  // Throws InputError if it is not a regular NetCDF file, or is truncated.
  explicit NetcdfFile(const std::string& path);
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  const std::vector<NetcdfDimension>& dimensions() const { return dimensions_; }
  const std::vector<NetcdfVariable>& variables() const { return variables_; }

  // Raw values, not unpacked. Throws InputError.
  std::vector<double> Values(const NetcdfVariable& variable) const;
  std::vector<double> Values(const NetcdfVariable& variable,
                             const std::vector<std::size_t>& start,
                             const std::vector<std::size_t>& count) const;

  // Throws InputError: path, (variable), cause.
  [[noreturn]] void Refuse(const std::string& what) const;
  [[noreturn]] void Refuse(const NetcdfVariable& variable,
                           const std::string& what) const;

 private:
  [[noreturn]] void Refuse(const netCDF::exceptions::NcException& error) const;
  void ReadDimensions();
  void ReadVariables();
  NetcdfVariable ReadVariable(const netCDF::NcVar& source) const;

  std::string path_;
  netCDF::NcFile file_;
  std::vector<NetcdfDimension> dimensions_;
  std::vector<NetcdfVariable> variables_;
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_NETCDF_FILE_H_
