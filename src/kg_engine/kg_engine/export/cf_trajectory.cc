#include "kg_engine/export/cf_trajectory.h"

#include <algorithm>
#include <netcdf>
#include <vector>

#include "kg_base/common/input_error.h"

namespace kg_engine {
namespace {

// All agents' points, one agent after the other.
struct Ragged {
  std::vector<std::string> ids;
  std::vector<int> sizes;
  std::vector<double> time_s, lon_deg, lat_deg;
};

// Joins parts: the two points of a cut at the antimeridian become one.
Ragged Flatten(const PlanTracks& plan) {
  Ragged all;
  for (const PlannedAgent& agent : plan.agents) {
    const std::size_t before = all.time_s.size();
    for (const Track& part : agent.parts) {
      for (const auto& point : part) {
        if (all.time_s.size() > before && point.time_s == all.time_s.back()) {
          continue;
        }
        all.time_s.push_back(point.time_s);
        all.lon_deg.push_back(point.position.lon_deg);
        all.lat_deg.push_back(point.position.lat_deg);
      }
    }
    if (all.time_s.size() == before) continue;
    all.ids.push_back(agent.id);
    all.sizes.push_back(static_cast<int>(all.time_s.size() - before));
  }
  return all;
}

struct TrajectoryVariables {
  netCDF::NcVar id, size, time, lat, lon;
};

netCDF::NcVar DefineCoordinate(const netCDF::NcFile& file, const char* name,
                               const netCDF::NcDim& dimension,
                               const char* standard_name, const char* units) {
  const netCDF::NcVar variable = file.addVar(name, netCDF::ncDouble, dimension);
  variable.putAtt("standard_name", standard_name);
  variable.putAtt("units", units);
  return variable;
}

TrajectoryVariables DefineVariables(const netCDF::NcFile& file,
                                    const Ragged& all, std::size_t id_length) {
  const netCDF::NcDim obs = file.addDim("obs", all.time_s.size());
  const netCDF::NcDim agents = file.addDim("trajectory", all.ids.size());
  const netCDF::NcDim letters = file.addDim("id_length", id_length);
  TrajectoryVariables var;
  var.id = file.addVar("trajectory_id", netCDF::ncChar,
                       std::vector<netCDF::NcDim>{agents, letters});
  var.id.putAtt("cf_role", "trajectory_id");
  var.id.putAtt("long_name", "agent");
  var.size = file.addVar("row_size", netCDF::ncInt, agents);
  var.size.putAtt("long_name", "number of points of this trajectory");
  var.size.putAtt("sample_dimension", "obs");
  var.time = DefineCoordinate(file, "time", obs, "time",
                              "seconds since 1970-01-01 00:00:00 UTC");
  var.time.putAtt("calendar", "standard");
  var.time.putAtt("axis", "T");
  var.lat = DefineCoordinate(file, "lat", obs, "latitude", "degrees_north");
  var.lat.putAtt("axis", "Y");
  var.lon = DefineCoordinate(file, "lon", obs, "longitude", "degrees_east");
  var.lon.putAtt("axis", "X");
  return var;
}

void DescribeFile(const netCDF::NcFile& file, const PlanTracks& plan) {
  file.putAtt("Conventions", "CF-1.8");
  file.putAtt("featureType", "trajectory");
  file.putAtt("title", "planned tracks of mission " + plan.mission_name);
  file.putAtt("source", "kg/export");
  file.putAtt("plan_run", plan.run_iri);
  file.putAtt("world_version", std::to_string(plan.world_version));
}

void PutValues(const TrajectoryVariables& var, const Ragged& all,
               std::size_t id_length) {
  std::string ids;
  for (std::string id : all.ids) {
    id.resize(id_length, '\0');
    ids += id;
  }
  var.id.putVar(ids.data());
  var.size.putVar(all.sizes.data());
  var.time.putVar(all.time_s.data());
  var.lat.putVar(all.lat_deg.data());
  var.lon.putVar(all.lon_deg.data());
}

// Throws netCDF::exceptions::NcException.
void WriteFile(const PlanTracks& plan, const Ragged& all,
               const std::string& path) {
  std::size_t id_length = 1;
  for (const std::string& id : all.ids) {
    id_length = std::max(id_length, id.size());
  }
  netCDF::NcFile file(path, netCDF::NcFile::replace, netCDF::NcFile::classic);
  const TrajectoryVariables variables = DefineVariables(file, all, id_length);
  DescribeFile(file, plan);
  file.enddef();
  PutValues(variables, all, id_length);
  // The destructor would close it, too, but could not throw.
  file.close();
}

}  // namespace

void WriteCfTrajectory(const PlanTracks& plan, const std::string& path) {
  const Ragged all = Flatten(plan);
  if (all.ids.empty()) {
    throw kg_base::InputError(plan.run_iri + " holds no track");
  }
  try {
    WriteFile(plan, all, path);
  } catch (const netCDF::exceptions::NcException& error) {
    // The second line of the text names a line of netcdf-c++'s source.
    const std::string text = error.what();
    throw kg_base::InputError(
        path + ": cannot be written: " + text.substr(0, text.find('\n')));
  }
}

}  // namespace kg_engine
