// Dimensions, variables and attributes of a NetCDF file as plain values, and
// its data, read with netcdf-c++, in all groups.

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
  int id = 0;  // Within its group.
  std::size_t group = 0;
  std::string group_path;  // "" in the root, otherwise "forecast/surface/".
  std::string base_name;
  std::string name;  // group_path and base_name.
  int type = 0;      // A netCDF::NcType::ncType, or a user-defined type.
  std::vector<int> dimensions;
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<double>> numbers;

  std::string Text(const std::string& attribute) const;  // "" if absent.
  // The raw value with the sign that attribute _Unsigned declares, by which
  // classic files have unsigned integers.
  double WithDeclaredSign(double raw) const;
  // Is this variable in scope of `other`: in its group or one around it?
  bool IsVisibleTo(const NetcdfVariable& other) const;
};

class NetcdfFile {
 public:
  // Throws InputError if it is not a regular NetCDF file, or is truncated.
  explicit NetcdfFile(const std::string& path);
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  const std::vector<NetcdfDimension>& dimensions() const { return dimensions_; }
  const std::vector<NetcdfVariable>& variables() const { return variables_; }

  // Values not unpacked, with the declared sign. Throws InputError.
  std::vector<double> Values(const NetcdfVariable& variable) const;
  std::vector<double> Values(const NetcdfVariable& variable,
                             const std::vector<std::size_t>& start,
                             const std::vector<std::size_t>& count) const;
  // Length of the variable's chunks along one of its dimensions, as stored; 1
  // if it is not stored in chunks.
  std::size_t ChunkLength(const NetcdfVariable& variable,
                          std::size_t position) const;

  // Throws InputError: path, (variable), cause.
  [[noreturn]] void Refuse(const std::string& what) const;
  [[noreturn]] void Refuse(const NetcdfVariable& variable,
                           const std::string& what) const;

 private:
  [[noreturn]] void Refuse(const netCDF::exceptions::NcException& error) const;
  void ReadGroup(const netCDF::NcGroup& group, const std::string& path);
  void ReadDimensions(const netCDF::NcGroup& group);
  NetcdfVariable ReadVariable(const netCDF::NcVar& source,
                              const std::string& path) const;
  netCDF::NcVar Source(const NetcdfVariable& variable) const;

  std::string path_;
  netCDF::NcFile file_;
  std::vector<netCDF::NcGroup> groups_;  // The root first.
  std::map<int, int> dimension_index_;   // By the library's identifier.
  std::vector<NetcdfDimension> dimensions_;
  std::vector<NetcdfVariable> variables_;
};

}  // namespace kg_base

#endif  // KG_BASE_RASTER_NETCDF_FILE_H_
