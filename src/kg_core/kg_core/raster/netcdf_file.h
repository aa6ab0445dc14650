// A NetCDF file's dimensions, variables and attributes as plain values, and its
// numbers. Root group only.

#ifndef KG_CORE_RASTER_NETCDF_FILE_H_
#define KG_CORE_RASTER_NETCDF_FILE_H_

#include <netcdf.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace kg_core {

struct NetcdfDimension {
  std::string name;
  std::size_t size = 0;
};

struct NetcdfVariable {
  int id = 0;
  std::string name;
  nc_type type = NC_NAT;
  std::vector<int> dimensions;
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<double>> numbers;

  std::string Text(const std::string& attribute) const;  // "" if absent.
};

class NetcdfFile {
 public:
  // Throws InputError for what is no regular NetCDF file, or a truncated one.
  explicit NetcdfFile(const std::string& path);
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  const std::vector<NetcdfDimension>& dimensions() const { return dimensions_; }
  const std::vector<NetcdfVariable>& variables() const { return variables_; }

  // Raw values, not unpacked.
  std::vector<double> Values(const NetcdfVariable& variable) const;
  std::vector<double> Values(const NetcdfVariable& variable,
                             const std::vector<std::size_t>& start,
                             const std::vector<std::size_t>& count) const;

  // Throws InputError: path, (variable), what is wrong.
  [[noreturn]] void Refuse(const std::string& what) const;
  [[noreturn]] void Refuse(const NetcdfVariable& variable,
                           const std::string& what) const;

 private:
  void Check(int status) const;
  void ReadDimensions();
  void ReadVariables();
  NetcdfVariable ReadVariable(int id) const;
  void ReadAttribute(const std::string& name, NetcdfVariable* variable) const;

  std::string path_;
  int id_ = -1;
  std::vector<NetcdfDimension> dimensions_;
  std::vector<NetcdfVariable> variables_;
};

}  // namespace kg_core

#endif  // KG_CORE_RASTER_NETCDF_FILE_H_
