#include "kg_engine/export/cf_trajectory.h"

#include <netcdf.h>

#include <algorithm>
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

// Both sides of the antimeridian are one place: a cut is one point.
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

// An open file; closed, and if it is not Finish()ed, given up.
class NetcdfWriter {
 public:
  explicit NetcdfWriter(std::string path) : path_(std::move(path)) {
    Check(nc_create(path_.c_str(), NC_CLOBBER, &file_));
    is_open_ = true;
  }
  ~NetcdfWriter() {
    if (is_open_) nc_abort(file_);
  }
  NetcdfWriter(const NetcdfWriter&) = delete;
  NetcdfWriter& operator=(const NetcdfWriter&) = delete;

  void Check(int status) const {
    if (status == NC_NOERR) return;
    throw kg_base::InputError(path_ +
                              ": cannot be written: " + nc_strerror(status));
  }
  int Dimension(const char* name, std::size_t size) const {
    int id = 0;
    Check(nc_def_dim(file_, name, size, &id));
    return id;
  }
  int Variable(const char* name, nc_type type,
               const std::vector<int>& dimensions) const {
    int id = 0;
    Check(nc_def_var(file_, name, type, static_cast<int>(dimensions.size()),
                     dimensions.data(), &id));
    return id;
  }
  void Text(int variable, const char* name, const std::string& text) const {
    Check(nc_put_att_text(file_, variable, name, text.size(), text.c_str()));
  }
  void EndDefinitions() const { Check(nc_enddef(file_)); }
  int file() const { return file_; }
  void Finish() {
    is_open_ = false;
    Check(nc_close(file_));
  }

 private:
  std::string path_;
  int file_ = 0;
  bool is_open_ = false;
};

struct Variables {
  int id = 0;
  int size = 0;
  int time = 0;
  int lon = 0;
  int lat = 0;
};

int Coordinate(const NetcdfWriter& file, const char* name, int dimension,
               const char* standard_name, const char* units) {
  const int variable = file.Variable(name, NC_DOUBLE, {dimension});
  file.Text(variable, "standard_name", standard_name);
  file.Text(variable, "units", units);
  return variable;
}

Variables Define(const NetcdfWriter& file, const Ragged& all,
                 std::size_t id_length) {
  const int obs = file.Dimension("obs", all.time_s.size());
  const int agents = file.Dimension("trajectory", all.ids.size());
  const int letters = file.Dimension("id_length", id_length);
  Variables var;
  var.id = file.Variable("trajectory_id", NC_CHAR, {agents, letters});
  file.Text(var.id, "cf_role", "trajectory_id");
  file.Text(var.id, "long_name", "agent");
  var.size = file.Variable("row_size", NC_INT, {agents});
  file.Text(var.size, "long_name", "number of points of this trajectory");
  file.Text(var.size, "sample_dimension", "obs");
  var.time = Coordinate(file, "time", obs, "time",
                        "seconds since 1970-01-01 00:00:00 UTC");
  file.Text(var.time, "calendar", "standard");
  file.Text(var.time, "axis", "T");
  var.lat = Coordinate(file, "lat", obs, "latitude", "degrees_north");
  file.Text(var.lat, "axis", "Y");
  var.lon = Coordinate(file, "lon", obs, "longitude", "degrees_east");
  file.Text(var.lon, "axis", "X");
  return var;
}

void DescribeFile(const NetcdfWriter& file, const PlanTracks& plan) {
  file.Text(NC_GLOBAL, "Conventions", "CF-1.8");
  file.Text(NC_GLOBAL, "featureType", "trajectory");
  file.Text(NC_GLOBAL, "title",
            "planned tracks of mission " + plan.mission_name);
  file.Text(NC_GLOBAL, "source", "kg/export");
  file.Text(NC_GLOBAL, "plan_run", plan.run_iri);
  file.Text(NC_GLOBAL, "world_version", std::to_string(plan.world_version));
}

void PutValues(const NetcdfWriter& file, const Variables& var,
               const Ragged& all, std::size_t id_length) {
  std::string ids;
  for (std::string id : all.ids) {
    id.resize(id_length, '\0');
    ids += id;
  }
  file.Check(nc_put_var_text(file.file(), var.id, ids.data()));
  file.Check(nc_put_var_int(file.file(), var.size, all.sizes.data()));
  file.Check(nc_put_var_double(file.file(), var.time, all.time_s.data()));
  file.Check(nc_put_var_double(file.file(), var.lat, all.lat_deg.data()));
  file.Check(nc_put_var_double(file.file(), var.lon, all.lon_deg.data()));
}

}  // namespace

void WriteCfTrajectory(const PlanTracks& plan, const std::string& path) {
  const Ragged all = Flatten(plan);
  if (all.ids.empty()) {
    throw kg_base::InputError(plan.run_iri + " holds no track");
  }
  std::size_t id_length = 1;
  for (const std::string& id : all.ids) {
    id_length = std::max(id_length, id.size());
  }
  NetcdfWriter file(path);
  const Variables variables = Define(file, all, id_length);
  DescribeFile(file, plan);
  file.EndDefinitions();
  PutValues(file, variables, all, id_length);
  file.Finish();
}

}  // namespace kg_engine
