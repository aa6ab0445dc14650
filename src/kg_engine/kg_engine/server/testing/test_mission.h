// For tests: a mission folder of one agent and two daily windows, with an ocean
// of 40 x 30 cells: a coast in the west, a weak current, a moving warm patch.

#ifndef KG_ENGINE_SERVER_TESTING_TEST_MISSION_H_
#define KG_ENGINE_SERVER_TESTING_TEST_MISSION_H_

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <netcdf>
#include <string>
#include <vector>

namespace kg_engine {

inline constexpr char kTestMission[] = R"ttl(
@prefix ex: <http://example.org/mission/> .
@prefix geo: <http://www.opengis.net/ont/geosparql#> .
@prefix time: <http://www.w3.org/2006/time#> .
@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .

ex:mission a ex:Mission ; ex:name "test" ;
    ex:hasWindow ex:w0 , ex:w1 ; ex:hasAgent ex:alpha ;
    ex:waypointsPerWindow 5 ; ex:waypointSpacingKm 10 ;
    ex:minimumSeparationKm 2 ; ex:candidatesPerAgent 3 .
ex:w0 a ex:TimeWindow ; ex:index 0 ; ex:confidence 1.0 ; ex:durationHours 24 ;
    time:hasBeginning "2026-06-02T00:00:00Z"^^xsd:dateTime .
ex:w1 a ex:TimeWindow ; ex:index 1 ; ex:confidence 0.9 ; ex:durationHours 24 ;
    time:hasBeginning "2026-06-03T00:00:00Z"^^xsd:dateTime .
ex:currents a ex:DataSource ; ex:file "ocean.nc" ; ex:provides "current" .
ex:sst a ex:DataSource ; ex:file "ocean.nc" ; ex:provides "temperature" ;
    ex:kind "delta_sst" .
ex:land a ex:Constraint ; ex:kind "no_go" ; ex:gridRef "land" ;
    ex:bufferCells 2 .
ex:bloom a ex:Event ; ex:forWindow ex:w0 , ex:w1 ; ex:value 3 ; ex:capacity 1 ;
    ex:radiusKm 20 ; geo:asWKT "POINT(-90.9 25.7)"^^geo:wktLiteral .
ex:fast a ex:Policy ; ex:name "fast" ; ex:alpha_base 1.0 .
ex:safe a ex:Policy ; ex:name "safe" ; ex:alpha_base 1.0 ; ex:gamma_front 0.5 .
ex:alpha a ex:Agent ; ex:id "alpha" ; ex:mobility "glider" ;
    ex:usesPolicy ex:fast ; ex:hasCapabilities ex:alpha_capabilities .
ex:alpha_capabilities a ex:AgentCapabilities ; ex:cruiseSpeedKts 0.6 ;
    ex:maxSpeedKts 1.0 ; ex:energyPerKm 2.0 ; ex:hotelLoadW 1.0 ;
    ex:energyBudget 5000 ; ex:sensorRadiusKm 8 .
ex:alpha_start a ex:AgentState ; ex:forAgent ex:alpha ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-90.9 25.7)"^^geo:wktLiteral ; ex:headingDeg 90 .
)ttl";

class TestOcean {
 public:
  static void Write(const std::string& path) { TestOcean ocean(path); }

 private:
  static constexpr std::size_t kDays = 5;
  static constexpr std::size_t kRows = 30;
  static constexpr std::size_t kCols = 40;
  static constexpr float kFill = -1e30F;

  explicit TestOcean(const std::string& path) {
    file_.create(path, NC_CLOBBER);
    const netCDF::NcVar time =
        Axis("time", kDays, "hours since 2026-06-01 12:00:00");
    const netCDF::NcVar lat = Axis("lat", kRows, "degrees_north");
    const netCDF::NcVar lon = Axis("lon", kCols, "degrees_east");
    const netCDF::NcVar u =
        Variable("water_u", "eastward_sea_water_velocity", "m/s");
    const netCDF::NcVar v =
        Variable("water_v", "northward_sea_water_velocity", "m/s");
    const netCDF::NcVar t =
        Variable("water_temp", "sea_water_temperature", "degC");
    file_.enddef();
    Fill(time, 0.0, 24.0, kDays);
    Fill(lat, 25.0, 0.05, kRows);
    Fill(lon, -92.0, 0.05, kCols);
    Put(u, [](double, double, double) { return 0.05; });
    Put(v, [](double, double, double) { return -0.03; });
    Put(t, [](double day, double row, double col) {
      const double x = (col - 20.0 - day) / 6.0;
      const double y = (row - 15.0) / 5.0;
      return 25.0 + 3.0 * std::exp(-x * x - y * y);
    });
    file_.close();
  }

  netCDF::NcVar Axis(const char* name, std::size_t size,
                     const std::string& units) {
    dims_.push_back(file_.addDim(name, size));
    const netCDF::NcVar axis =
        file_.addVar(name, netCDF::ncDouble, dims_.back());
    axis.putAtt("units", units);
    return axis;
  }
  netCDF::NcVar Variable(const char* name, const std::string& standard,
                         const std::string& units) {
    const netCDF::NcVar variable = file_.addVar(name, netCDF::ncFloat, dims_);
    variable.putAtt("standard_name", standard);
    variable.putAtt("units", units);
    variable.putAtt("_FillValue", netCDF::ncFloat, kFill);
    return variable;
  }
  static void Fill(const netCDF::NcVar& axis, double begin, double step,
                   std::size_t size) {
    std::vector<double> values;
    for (std::size_t i = 0; i < size; ++i) values.push_back(begin + i * step);
    axis.putVar(values.data());
  }
  template <typename Function>
  static void Put(const netCDF::NcVar& variable, Function value) {
    std::vector<float> values;
    for (std::size_t day = 0; day < kDays; ++day) {
      for (std::size_t row = 0; row < kRows; ++row) {
        for (std::size_t col = 0; col < kCols; ++col) {
          const bool land = col < 3;
          values.push_back(land ? kFill
                                : static_cast<float>(value(day, row, col)));
        }
      }
    }
    variable.putVar(values.data());
  }

  netCDF::NcFile file_;
  std::vector<netCDF::NcDim> dims_;
};

inline void WriteTestMission(const std::string& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/mission.ttl") << kTestMission;
  TestOcean::Write(folder + "/ocean.nc");
}

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_TESTING_TEST_MISSION_H_
