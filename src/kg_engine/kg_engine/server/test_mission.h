// For tests: a mission folder of one agent and two daily windows, with an ocean
// of 40 x 30 cells: a coast in the west, a weak current, a warm patch that
// moves.

#ifndef KG_ENGINE_SERVER_TEST_MISSION_H_
#define KG_ENGINE_SERVER_TEST_MISSION_H_

#include <netcdf.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
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
    Check(nc_create(path.c_str(), NC_CLOBBER, &file_));
    const int time = Axis(0, "time", kDays, "hours since 2026-06-01 12:00:00");
    const int lat = Axis(1, "lat", kRows, "degrees_north");
    const int lon = Axis(2, "lon", kCols, "degrees_east");
    const int u = Variable("water_u", "eastward_sea_water_velocity", "m/s");
    const int v = Variable("water_v", "northward_sea_water_velocity", "m/s");
    const int t = Variable("water_temp", "sea_water_temperature", "degC");
    Check(nc_enddef(file_));
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
    Check(nc_close(file_));
  }

  static void Check(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
  }
  void Text(int variable, const char* name, const std::string& text) {
    Check(nc_put_att_text(file_, variable, name, text.size(), text.c_str()));
  }
  int Axis(int place, const char* name, std::size_t size,
           const std::string& units) {
    int variable = 0;
    Check(nc_def_dim(file_, name, size, &dims_[place]));
    Check(nc_def_var(file_, name, NC_DOUBLE, 1, &dims_[place], &variable));
    Text(variable, "units", units);
    return variable;
  }
  int Variable(const char* name, const std::string& standard,
               const std::string& units) {
    int variable = 0;
    Check(nc_def_var(file_, name, NC_FLOAT, 3, dims_, &variable));
    Text(variable, "standard_name", standard);
    Text(variable, "units", units);
    Check(nc_put_att_float(file_, variable, "_FillValue", NC_FLOAT, 1, &kFill));
    return variable;
  }
  void Fill(int variable, double begin, double step, std::size_t size) {
    std::vector<double> values;
    for (std::size_t i = 0; i < size; ++i) values.push_back(begin + i * step);
    Check(nc_put_var_double(file_, variable, values.data()));
  }
  template <typename Function>
  void Put(int variable, Function value) {
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
    Check(nc_put_var_float(file_, variable, values.data()));
  }

  int file_ = 0;
  int dims_[3] = {};
};

inline void WriteTestMission(const std::string& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/mission.ttl") << kTestMission;
  TestOcean::Write(folder + "/ocean.nc");
}

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_TEST_MISSION_H_
