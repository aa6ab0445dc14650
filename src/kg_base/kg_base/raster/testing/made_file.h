// For tests: writes NetCDF files of any form, variable by variable.

#ifndef KG_BASE_RASTER_TESTING_MADE_FILE_H_
#define KG_BASE_RASTER_TESTING_MADE_FILE_H_

#include <map>
#include <netcdf>
#include <string>
#include <vector>

#include "kg_base/common/temporary_folder.h"
#include "kg_base/raster/read_field_file.h"
#include "kg_base/raster/testing/field_test_file.h"

namespace kg_base {

using AttributeTexts = std::map<std::string, std::string>;

// A NetCDF-4 file. By default it has the axes time (hours 0, 6, 12 since
// 2020-11-01), lat (3 rows) and lon (5 columns) on request.
class MadeFile {
 public:
  MadeFile() { nc_.create(path_, NC_CLOBBER | NC_NETCDF4); }

  // Later variables and dimensions lie in this group of the root.
  void InGroup(const std::string& name) {
    group_ = nc_.addGroup(name);
    has_group_ = true;
  }
  void InRoot() { has_group_ = false; }

  void Dimension(const std::string& name, std::size_t size) {
    Here().addDim(name, size);
  }
  netCDF::NcVar Put(const std::string& name,
                    const std::vector<std::string>& dimensions,
                    const std::vector<double>& values,
                    const AttributeTexts& texts = {},
                    const netCDF::NcType& type = netCDF::ncDouble) {
    const netCDF::NcVar variable = Here().addVar(name, type, Dims(dimensions));
    for (const auto& text : texts) variable.putAtt(text.first, text.second);
    variable.putVar(values.data());
    return variable;
  }
  void Axis(const std::string& name, const std::vector<double>& values,
            const AttributeTexts& texts = {},
            const netCDF::NcType& type = netCDF::ncDouble) {
    Dimension(name, values.size());
    Put(name, {name}, values, texts, type);
  }

  void Times(const std::vector<double>& hours = {0, 6, 12},
             AttributeTexts more = {}) {
    more["standard_name"] = "time";
    more["units"] = "hours since 2020-11-01 00:00:00";
    Axis("time", hours, more);
  }
  void Lat(const std::vector<double>& lat = {21, 21.1, 21.2}) {
    Axis("lat", lat,
         {{"units", "degrees_north"}, {"standard_name", "latitude"}});
  }
  void Lon(const std::vector<double>& lon = {-98, -97.9, -97.8, -97.7, -97.6}) {
    Axis("lon", lon,
         {{"units", "degrees_east"}, {"standard_name", "longitude"}});
  }
  void Box() {
    Lat();
    Lon();
  }
  // water_u and water_v with these values, unless `texts` say otherwise.
  void Currents(const std::vector<std::string>& dimensions,
                const std::vector<double>& values, AttributeTexts texts = {}) {
    texts.emplace("units", "m s-1");
    texts["standard_name"] = "eastward_sea_water_velocity";
    Put("water_u", dimensions, values, texts);
    texts["standard_name"] = "northward_sea_water_velocity";
    Put("water_v", dimensions, values, texts);
  }
  // As above, stored in compressed chunks of this shape.
  void ChunkedCurrents(const std::vector<std::string>& dimensions,
                       const std::vector<double>& values,
                       std::vector<std::size_t> chunks) {
    for (const char* name : {"eastward", "northward"}) {
      netCDF::NcVar field =
          Here().addVar(name, netCDF::ncFloat, Dims(dimensions));
      field.setChunking(netCDF::NcVar::nc_CHUNKED, chunks);
      field.setCompression(false, true, 1);
      field.putAtt("units", "m s-1");
      field.putAtt("standard_name", std::string(name) + "_sea_water_velocity");
      field.putVar(values.data());
    }
  }
  // The values `at_index[i]` of the outer dimensions, each for all of `cells`.
  static std::vector<double> Repeated(const std::vector<double>& at_index,
                                      std::size_t cells = 15) {
    std::vector<double> values;
    for (const double value : at_index) {
      values.insert(values.end(), cells, value);
    }
    return values;
  }

  FieldFile Read(const std::vector<FieldQuantity>& wanted = BothVelocities()) {
    nc_.close();
    return ReadFieldFile(path_, wanted);
  }
  FieldFile ReadNamed(const std::string& variable) {
    nc_.close();
    return ReadVariable(path_, variable);
  }
  std::string Refusal() {
    return InputErrorOf([&] { Read(); });
  }

 private:
  netCDF::NcGroup Here() const {
    return has_group_ ? group_ : static_cast<const netCDF::NcGroup&>(nc_);
  }
  std::vector<netCDF::NcDim> Dims(const std::vector<std::string>& names) const {
    std::vector<netCDF::NcDim> found;
    for (const std::string& name : names) {
      found.push_back(Here().getDim(name, netCDF::NcGroup::ParentsAndCurrent));
    }
    return found;
  }

  TemporaryFolder folder_;
  const std::string path_ = folder_ / "file.nc";
  netCDF::NcFile nc_;
  netCDF::NcGroup group_;
  bool has_group_ = false;
};

// All warnings of a file's variables in one text, a line each.
inline std::string WarningsOf(const FieldFile& file) {
  std::string text;
  for (const QuantitySeries& series : file.series) {
    for (const std::string& warning : series.report.warnings) {
      text += series.variable + ": " + warning + "\n";
    }
  }
  return text;
}

}  // namespace kg_base

#endif  // KG_BASE_RASTER_TESTING_MADE_FILE_H_
