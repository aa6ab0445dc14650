#include "kg_mission/mission/ingest.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <netcdf>
#include <set>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/sha256.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/data_quality.h"
#include "kg_mission/mission/ingested_facts.h"
#include "kg_mission/mission/layer_files.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/testing/mission_world.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

using kg_base::FieldQuantity;
using kg_base::VectorField;
using kg_core::Ex;
using kg_core::FactUpdate;
using kg_core::FirstObject;
using kg_core::Has;
using kg_core::Literal;
using kg_core::Prov;
using kg_core::RdfType;
using kg_core::Term;
using kg_core::Transaction;

namespace fs = std::filesystem;

constexpr int kDays = 4;  // Noons of 2026-06-01 to 04.
constexpr float kFill = 1e30f;

// Content of the test file: currents of (0.1 + t, -0.2) m/s, temperature 20 + t
// * t.
struct Ocean {
  int days = kDays;
  double first_lon_deg = -94.0;
  double lon_step_deg = 0.1;
  double first_lat_deg = 26.0;
  double lat_step_deg = 0.1;
  bool has_north = true;
  bool is_wind = false;
  bool is_land = false;
  int empty_day = -1;  // A day without data; -1 = none.
};

class OceanWriter {
 public:
  OceanWriter(const std::string& path, const Ocean& spec) : spec_(spec) {
    nc_.create(path, NC_CLOBBER);
    const netCDF::NcVar time =
        Axis("time", spec.days, "hours since 2026-06-01 12:00:00");
    const netCDF::NcVar lat = Axis("lat", kRows, "degrees_north");
    const netCDF::NcVar lon = Axis("lon", kCols, "degrees_east");
    const std::string medium = spec.is_wind ? "wind" : "sea_water_velocity";
    const netCDF::NcVar u = Variable("water_u", "eastward_" + medium, "m/s");
    netCDF::NcVar v;
    if (spec.has_north) v = Variable("water_v", "northward_" + medium, "m/s");
    const netCDF::NcVar t =
        Variable("water_temp", "sea_surface_temperature", "degC");
    nc_.enddef();
    Fill(time, spec.days, [](int i) { return 24.0 * i; });
    Fill(lat, kRows,
         [&](int i) { return spec_.first_lat_deg + spec_.lat_step_deg * i; });
    Fill(lon, kCols,
         [&](int i) { return spec_.first_lon_deg + spec_.lon_step_deg * i; });
    FillField(u, [](int day) { return 0.1 + day; });
    if (!v.isNull()) FillField(v, [](int) { return -0.2; });
    FillField(t, [](int day) { return 20.0 + day * day; });
    nc_.close();
  }

 private:
  static constexpr int kRows = 12, kCols = 10;

  netCDF::NcVar Axis(const char* name, int size, const std::string& units) {
    dims_.push_back(nc_.addDim(name, size));
    const netCDF::NcVar axis = nc_.addVar(name, netCDF::ncDouble, dims_.back());
    axis.putAtt("units", units);
    return axis;
  }
  netCDF::NcVar Variable(const char* name, const std::string& standard,
                         const std::string& units) {
    const netCDF::NcVar variable = nc_.addVar(name, netCDF::ncFloat, dims_);
    variable.putAtt("standard_name", standard);
    variable.putAtt("units", units);
    variable.putAtt("_FillValue", netCDF::ncFloat, kFill);
    return variable;
  }
  static void Fill(const netCDF::NcVar& axis, int size,
                   const std::function<double(int)>& value) {
    std::vector<double> values(size);
    for (int i = 0; i < size; ++i) values[i] = value(i);
    axis.putVar(values.data());
  }
  // The western column is land.
  void FillField(const netCDF::NcVar& field,
                 const std::function<double(int)>& value) {
    std::vector<float> values;
    for (int day = 0; day < spec_.days; ++day) {
      for (int cell = 0; cell < kRows * kCols; ++cell) {
        const bool is_land =
            spec_.is_land || day == spec_.empty_day || cell % kCols == 0;
        values.push_back(is_land ? kFill : static_cast<float>(value(day)));
      }
    }
    field.putVar(values.data());
  }

  const Ocean spec_;
  netCDF::NcFile nc_;
  std::vector<netCDF::NcDim> dims_;
};

constexpr char kSources[] = R"ttl(
ex:currents a ex:DataSource ; ex:file "ocean.nc" ; ex:provides "current" .
ex:sst a ex:DataSource ; ex:file "sst.nc" ; ex:provides "temperature" .
)ttl";

// All subjects with the property.
std::vector<Term> SubjectsWith(const kg_core::GraphView& view,
                               const char* graph, const Term& property) {
  std::set<Term> subjects;
  kg_core::Quad pattern;
  pattern.predicate = view.Find(property);
  pattern.graph = view.Find(kg_core::Iri(graph));
  if (pattern.predicate == kg_core::kNoTerm ||
      pattern.graph == kg_core::kNoTerm) {
    return {};
  }
  view.Match(pattern, [&](const kg_core::Quad& quad) {
    subjects.insert(view.Get(quad.subject));
    return true;
  });
  return {subjects.begin(), subjects.end()};
}

class IngestTest : public testing::Test {
 protected:
  IngestTest() {
    char name[] = "/tmp/ingest_test_XXXXXX";
    folder_ = mkdtemp(name);
    Write("ocean.nc", {});
    Write("sst.nc", {});
  }
  ~IngestTest() override { fs::remove_all(folder_); }

  std::string Path(const std::string& name) const {
    return folder_ + "/" + name;
  }
  void Write(const std::string& name, const Ocean& spec) const {
    OceanWriter(Path(name), spec);
  }

  // Stages facts and their ingest; commits if there are no reasons to reject
  // them.
  std::vector<std::string> Ingest(const std::string& turtle) {
    return IngestInto(&world_, turtle);
  }
  std::vector<std::string> IngestInto(MissionWorld* world,
                                      const std::string& turtle) {
    Transaction transaction = world->store.Begin();
    FactUpdate update;
    update.turtle = turtle;
    std::vector<std::string> reasons = StageUpdate(update, transaction);
    EXPECT_EQ(Joined(reasons), "");
    EXPECT_TRUE(IngestIsDue(transaction));
    FileCache cache(folder_, "");
    reasons = StageIngest(cache, transaction);
    if (reasons.empty()) transaction.Commit(kg_core::WorldChange::kYes);
    return reasons;
  }
  std::string Refusal() { return Joined(Ingest(kSources)); }

  MissionWorld world_;
  std::string folder_;
};

TEST_F(IngestTest, StatesLayersThatConformAndCanBeRead) {
  ASSERT_EQ(Refusal(), "");
  const auto view = world_.store.Read();
  const auto violations = Validate(*view);
  EXPECT_TRUE(violations.empty()) << violations[0].Line();
  const Mission mission = ReadMission(*view);
  ASSERT_EQ(mission.work_fields.size(), 2u);
  EXPECT_EQ(mission.work_fields[0].first_time_index, 0);  // Noon, day before.
  EXPECT_EQ(mission.work_fields[0].last_time_index, 2);
  ASSERT_EQ(mission.value_layers.size(), 2u);
  EXPECT_EQ(mission.value_layers[1].time_index, 2);
  EXPECT_EQ(mission.value_layers[1].previous_time_index, 1);
  EXPECT_EQ(mission.value_layers[1].time_s, 1780488000.0);  // 06-03, noon.
}

// Outer cells that reach beyond 180 degrees or a pole, and boxes of more than
// half a turn.
TEST_F(IngestTest, GridsUpToTheEdgesOfTheGlobeAreAMission) {
  struct Case {
    const char* name;
    double first_lon_deg, lon_step_deg, first_lat_deg, lat_step_deg;
  };
  for (const Case& c :
       {Case{"from 180 W", -180.0, 0.1, 26.0, 0.1},
        Case{"up to 180 E", 179.09, 0.1, 26.0, 0.1},
        Case{"globe", -180.0, 36.0, -82.5, 15.0},
        Case{"with both poles", -162.0, 36.0, -90.0, 180.0 / 11},
        Case{"wide", -135.0, 30.0, -55.0, 10.0},
        Case{"far north", 20.0, 0.1, 88.0, 0.1}}) {
    Ocean spec;
    spec.first_lon_deg = c.first_lon_deg;
    spec.lon_step_deg = c.lon_step_deg;
    spec.first_lat_deg = c.first_lat_deg;
    spec.lat_step_deg = c.lat_step_deg;
    Write("ocean.nc", spec);
    Write("sst.nc", spec);
    MissionWorld world;
    EXPECT_EQ(Joined(IngestInto(&world, kSources)), "") << c.name;
    const auto view = world.store.Read();
    EXPECT_TRUE(Validate(*view).empty()) << c.name;
    EXPECT_EQ(ReadMission(*view).work_fields.size(), 2u) << c.name;
  }
}

TEST_F(IngestTest, StatesTheQualityOfEachVariableItReads) {
  Ocean spec;
  spec.empty_day = 3;  // Needed by no window.
  Write("sst.nc", spec);
  ASSERT_EQ(Refusal(), "");
  const auto view = world_.store.Read();
  const auto value = [&](const char* report, const char* property) {
    const auto found =
        FirstObject(*view, kg_core::kFactsGraph, Ex(report), Ex(property));
    return found ? found->text : "none";
  };
  EXPECT_TRUE(Has(*view, kg_core::kFactsGraph, Ex("sst/quality/0"),
                  Prov("wasDerivedFrom"), Ex("sst/file")));
  EXPECT_EQ(value("currents/quality/1", "quantity"), "northward velocity");
  EXPECT_EQ(value("sst/quality/0", "variable"), "water_temp");
  EXPECT_EQ(value("sst/quality/0", "timeCount"), "4");
  EXPECT_EQ(value("sst/quality/0", "firstTime"), "2026-06-01T12:00:00Z");
  EXPECT_EQ(value("sst/quality/0", "lastTime"), "2026-06-04T12:00:00Z");
  EXPECT_EQ(std::stod(value("sst/quality/0", "usualStepHours")), 24.0);
  EXPECT_EQ(value("sst/quality/0", "missingTimes"), "0");
  EXPECT_EQ(value("sst/quality/0", "cellCount"), "120");
  EXPECT_EQ(value("sst/quality/0", "cellsWithoutData"), "12");
  EXPECT_EQ(value("sst/quality/0", "outliers"), "0");
  EXPECT_EQ(value("sst/quality/0", "impossibleValues"), "0");
  // The data reach 60 h beyond the mission's begin, 2026-06-02T00:00Z.
  EXPECT_EQ(std::stod(value("sst/quality/0", "stalenessHours")), -60.0);
  EXPECT_NE(value("sst/quality/0", "warning")
                .find("no value in any cell at 1 of 4 times"),
            std::string::npos);
  EXPECT_EQ(value("currents/quality/0", "warning"), "none");

  const std::vector<DataSummary> data = SummarizeData(*view);
  ASSERT_EQ(data.size(), 3u);
  EXPECT_EQ(data[2].what, "ex:sst: temperature");
  EXPECT_EQ(data[2].text,
            "water_temp of " + Path("sst.nc") +
                "; unit degC; 4 times, 2026-06-01T12:00:00Z to "
                "2026-06-04T12:00:00Z, every 24 h, 0 missing; 120 cells, 10 % "
                "without data");
  const std::vector<std::string> warnings = DataWarnings(*view);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].rfind("ex:sst: water_temp: no value in any cell", 0),
            0u);
}

// A new ingest replaces the reports of the one before.
TEST_F(IngestTest, DropsReportsOfSourcesThatAreGone) {
  ASSERT_EQ(Refusal(), "");
  Transaction transaction = world_.store.Begin();
  FactUpdate update;
  update.remove = {{"ex:sst", "", ""}};
  FileCache cache(folder_, "");
  const StagedUpdate staged = StageUpdateWithFiles(update, cache, transaction);
  ASSERT_EQ(Joined(staged.judgement.reasons), "");
  EXPECT_EQ(SummarizeData(transaction.view()).size(), 2u);
}

TEST_F(IngestTest, LeavesProvenanceFromLayerToFileToActivity) {
  ASSERT_EQ(Refusal(), "");
  const auto view = world_.store.Read();
  const Term file = Ex("sst/file");
  EXPECT_TRUE(Has(*view, kg_core::kFactsGraph, Ex("sst/w1"),
                  Prov("wasDerivedFrom"), file));
  EXPECT_TRUE(Has(*view, kg_core::kFactsGraph, file, Ex("sha256"),
                  Literal(kg_base::Sha256HexOfFile(Path("sst.nc")))));
  EXPECT_TRUE(Has(*view, kg_core::kFactsGraph, Ex("sst/w1"), Ex("gridRef"),
                  Literal(Path("sst.nc") + "#water_temp@2,1")));
  const auto activity = FirstObject(*view, kg_core::kProvGraph, Ex("sst/w1"),
                                    Prov("wasGeneratedBy"));
  ASSERT_TRUE(activity);
  EXPECT_TRUE(Has(*view, kg_core::kProvGraph, *activity, Prov("used"), file));
  EXPECT_TRUE(Has(*view, kg_core::kProvGraph, *activity, Prov("generated"),
                  Ex("sst/w1")));
}

TEST_F(IngestTest, LayersFieldsAndGridLeadToTheirFileAndIngest) {
  ASSERT_EQ(Refusal(), "");
  const auto view = world_.store.Read();
  const std::vector<Term> stated =
      SubjectsWith(*view, kg_core::kFactsGraph, Ex("ingestedFrom"));
  EXPECT_GE(stated.size(), 7u);  // Two windows' layers and fields, grid, files.
  for (const Term& entity : stated) {
    const bool is_file =
        Has(*view, kg_core::kFactsGraph, entity, RdfType(), Ex("SourceFile"));
    const auto file = FirstObject(*view, kg_core::kFactsGraph, entity,
                                  Prov("wasDerivedFrom"));
    const auto activity =
        FirstObject(*view, kg_core::kProvGraph, entity, Prov("wasGeneratedBy"));
    EXPECT_EQ(file.has_value(), !is_file) << entity;
    EXPECT_EQ(activity.has_value(), !is_file) << entity;
    if (is_file) continue;
    EXPECT_TRUE(FirstObject(*view, kg_core::kFactsGraph, *file, Ex("sha256")))
        << entity;
    EXPECT_TRUE(Has(*view, kg_core::kProvGraph, *activity, Prov("used"), *file))
        << entity;
    EXPECT_TRUE(
        Has(*view, kg_core::kProvGraph, *activity, RdfType(), Ex("Ingest")));
  }
}

TEST_F(IngestTest, LoadsWhatItStated) {
  ASSERT_EQ(Refusal(), "");
  const Mission mission = ReadMission(*world_.store.Read());
  FileCache cache(folder_, "");
  const VectorField field =
      LoadWorkField(cache, mission, mission.work_fields[1]);
  ASSERT_EQ(field.slices.size(), 3u);
  EXPECT_NEAR(field.slices[0].east_mps[1], 1.1, 1e-6);
  EXPECT_NEAR(field.slices[0].north_mps[1], -0.2, 1e-6);
  EXPECT_TRUE(std::isnan(field.slices[0].east_mps[0]));
  const GriddedRaster delta =
      LoadValueLayer(cache, mission, mission.value_layers[1]);
  EXPECT_TRUE(delta.grid == field.grid);
  EXPECT_NEAR(delta.values[1], 3.0, 1e-5);  // |4 - 1|
  EXPECT_TRUE(std::isnan(delta.values[0]));
}

TEST_F(IngestTest, OtherKindsAreOfTheFieldItself) {
  for (const std::string kind : {"sst", "frontness"}) {
    MissionWorld world;
    ASSERT_EQ(Joined(IngestInto(
                  &world, kSources + ("ex:sst ex:kind \"" + kind + "\" ."))),
              "");
    const Mission mission = ReadMission(*world.store.Read());
    FileCache cache(folder_, "");
    const ValueLayer& layer = mission.value_layers[1];
    EXPECT_EQ(layer.kind, kind);
    EXPECT_EQ(layer.previous_time_index, layer.time_index);
    EXPECT_NEAR(LoadValueLayer(cache, mission, layer).values[1], 24.0, 1e-5);
  }
}

TEST_F(IngestTest, TheWindIsAWorkFieldAndNoCurrent) {
  Ocean windy;
  windy.is_wind = true;
  Write("ocean.nc", windy);
  EXPECT_NE(Refusal().find("expected eastward_wind where ex:provides is "
                           "\"wind\", and only there"),
            std::string::npos);
  ASSERT_EQ(Joined(Ingest("ex:breeze a ex:DataSource ; ex:file \"ocean.nc\" ; "
                          "ex:provides \"wind\" .")),
            "");
  const auto view = world_.store.Read();
  EXPECT_TRUE(Validate(*view).empty());
  const Term field = Ex("breeze/w1");
  EXPECT_TRUE(
      Has(*view, kg_core::kFactsGraph, field, RdfType(), Ex("WorkField")));
  EXPECT_FALSE(
      Has(*view, kg_core::kFactsGraph, field, RdfType(), Ex("CurrentField")));
  EXPECT_TRUE(
      Has(*view, kg_core::kFactsGraph, field,
          kg_core::Iri(std::string(kg_core::kSosa) + "observedProperty"),
          Ex("windVelocity")));
  const Mission mission = ReadMission(*view);
  ASSERT_EQ(mission.work_fields.size(), 2u);
  FileCache cache(folder_, "");
  const VectorField loaded =
      LoadWorkField(cache, mission, mission.work_fields[1]);
  EXPECT_NEAR(loaded.slices[0].east_mps[1], 1.1, 1e-6);
}

TEST_F(IngestTest, CurrentsAreNoWind) {
  EXPECT_NE(Joined(Ingest("ex:breeze a ex:DataSource ; ex:file \"ocean.nc\" ; "
                          "ex:provides \"wind\" ."))
                .find("variable water_u has standard_name"),
            std::string::npos);
}

TEST_F(IngestTest, WindowsShareTheTimeStepsOfAFile) {
  ASSERT_EQ(Refusal(), "");
  const Mission mission = ReadMission(*world_.store.Read());
  FileCache cache(folder_, "");
  const VectorField a = LoadWorkField(cache, mission, mission.work_fields[0]);
  const VectorField b = LoadWorkField(cache, mission, mission.work_fields[1]);
  int shared = 0;
  for (const kg_base::FieldSlice& early : a.slices) {
    for (const kg_base::FieldSlice& late : b.slices) {
      if (early.time_s != late.time_s) continue;
      ++shared;
      EXPECT_EQ(early.east_mps.data(), late.east_mps.data());
      EXPECT_EQ(early.north_mps.data(), late.north_mps.data());
    }
  }
  EXPECT_EQ(shared, 2);
}

TEST_F(IngestTest, WhatASourceSaysOfItsLayersIsSaidOfEach) {
  ASSERT_EQ(Joined(Ingest(std::string(kSources) +
                          "ex:sst ex:fullScale 2.5 ; ex:frontFullScale 0.1 ; "
                          "ex:resampling \"nearest\" .")),
            "");
  const auto view = world_.store.Read();
  EXPECT_TRUE(Validate(*view).empty());
  const Mission mission = ReadMission(*view);
  ASSERT_EQ(mission.value_layers.size(), 2u);
  for (const ValueLayer& layer : mission.value_layers) {
    EXPECT_EQ(layer.full_scale, 2.5);
    EXPECT_EQ(layer.front_full_scale, 0.1);
    EXPECT_EQ(layer.resampling, kg_base::Resampling::kNearest);
  }
  Transaction change = world_.store.Begin();
  FactUpdate update;
  update.set = {{"ex:sst", "ex:fullScale", "3"}};
  ASSERT_EQ(Joined(StageUpdate(update, change)), "");
  EXPECT_TRUE(IngestIsDue(change));
}

TEST_F(IngestTest, AnotherGridIsRefusedUnlessItIsDeclared) {
  Ocean shifted;
  shifted.first_lon_deg = -94.05;
  Write("sst.nc", shifted);
  EXPECT_EQ(Refusal(),
            "ex:sst: " + Path("sst.nc") +
                ": ex:sst ex:resampling: expected \"nearest\", or "
                "\"bilinear\" unless it is a mask, because its grid (12 x 10 "
                "cells, -94.1 to -93.1 E, 25.95 to 27.15 N) is not the "
                "mission's, that of the work fields (12 x 10 cells, -94.05 to "
                "-93.05 E, 25.95 to 27.15 N)\n");
  shifted.first_lon_deg = -60.0;
  Write("sst.nc", shifted);
  const std::string far = Joined(
      Ingest(std::string(kSources) + "ex:sst ex:resampling \"nearest\" ."));
  EXPECT_NE(far.find("no place in common"), std::string::npos) << far;
}

TEST_F(IngestTest, AnotherGridIsResampledAsDeclared) {
  Ocean shifted;
  shifted.first_lon_deg = -94.05;
  Write("sst.nc", shifted);
  ASSERT_EQ(Joined(Ingest(std::string(kSources) +
                          "ex:sst ex:resampling \"bilinear\" .")),
            "");
  const auto view = world_.store.Read();
  EXPECT_TRUE(Has(*view, kg_core::kFactsGraph, Ex("sst/w0"), Ex("onGrid"),
                  Ex("sst/grid")));
  EXPECT_TRUE(Has(*view, kg_core::kFactsGraph, Ex("sst/w0"), Ex("resampling"),
                  Literal("bilinear")));
  const Mission mission = ReadMission(*view);
  FileCache cache(folder_, "");
  const kg_base::Grid grid =
      LoadWorkField(cache, mission, mission.work_fields[0]).grid;
  const ValueLayer& layer = mission.value_layers[1];
  const kg_base::SharedRaster delta = OnGrid(
      layer.iri, LoadValueLayer(cache, mission, layer), grid, layer.resampling);
  EXPECT_EQ(delta.size(), grid.size());
  EXPECT_NEAR(delta[5], 3.0, 1e-4);
}

TEST_F(IngestTest, RefusesTooFewDaysAndSaysWhatIsThere) {
  Ocean brief;
  brief.days = 1;
  Write("sst.nc", brief);
  const std::string said = Refusal();
  EXPECT_NE(said.find("ex:sst: " + Path("sst.nc") +
                      ": too few days: has 1 steps from 2026-06-01T12:00:00Z"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("window 0"), std::string::npos) << said;
}

TEST_F(IngestTest, RefusesAllLandMissingVariablesAndMissingFiles) {
  Ocean land;
  land.is_land = true;
  Write("ocean.nc", land);
  EXPECT_NE(Refusal().find("ex:currents: "), std::string::npos) << Refusal();
  Ocean no_north;
  no_north.has_north = false;
  Write("ocean.nc", no_north);
  EXPECT_NE(Refusal().find("northward"), std::string::npos) << Refusal();
  fs::remove(Path("ocean.nc"));
  EXPECT_NE(Refusal().find("looked for " + Path("ocean.nc")), std::string::npos)
      << Refusal();
}

TEST_F(IngestTest, RefusesOnlyTheEmptyTimesThatAWindowNeeds) {
  Ocean ocean;
  ocean.days = 6;
  for (const char* name : {"ocean.nc", "sst.nc"}) {
    for (const int needed : {0, 1, 2, 3}) {
      if (name[0] == 's' && needed == 3) continue;  // Window 1 needs days 1, 2.
      ocean.empty_day = needed;
      Write(name, ocean);
      const std::string said = Refusal();
      EXPECT_NE(said.find("no value in any cell at 2026-06-0" +
                          std::to_string(1 + needed) + "T12:00:00Z"),
                std::string::npos)
          << name << needed << said;
    }
    ocean.empty_day = -1;
    Write(name, ocean);
  }
  ocean.empty_day = 5;
  Write("ocean.nc", ocean);
  Write("sst.nc", ocean);
  EXPECT_EQ(Refusal(), "");
}

TEST_F(IngestTest, ARefusedIngestLeavesNothingBehind) {
  fs::remove(Path("sst.nc"));
  const auto quads = world_.store.quad_count();
  EXPECT_NE(Refusal(), "");
  EXPECT_EQ(world_.store.quad_count(), quads);
}

TEST_F(IngestTest, ASecondIngestReplacesTheFirst) {
  ASSERT_EQ(Refusal(), "");
  Transaction transaction = world_.store.Begin();
  FileCache cache(folder_, "");
  ASSERT_EQ(Joined(StageIngest(cache, transaction)), "");
  for (const kg_core::Statement& statement : transaction.added()) {
    EXPECT_NE(statement.graph, kg_core::Facts())
        << kg_core::ToTurtle(statement.subject);
  }
  EXPECT_TRUE(transaction.removed().empty());
}

TEST_F(IngestTest, AWindowThatGoesTakesItsLayersWithIt) {
  ASSERT_EQ(Refusal(), "");
  Transaction transaction = world_.store.Begin();
  FactUpdate update;
  update.remove = {{"ex:m", "ex:hasWindow", "ex:w1"},
                   {"ex:w1", "", ""},
                   {"ex:cool", "", ""}};
  update.set = {{"ex:w0", "ex:durationHours", "24"}};
  ASSERT_EQ(Joined(StageUpdate(update, transaction)), "");
  FileCache cache(folder_, "");
  ASSERT_EQ(Joined(StageIngest(cache, transaction)), "");
  EXPECT_EQ(ReadMission(transaction.view()).value_layers.size(), 1u);
}

TEST_F(IngestTest, RefusesAFileThatChangedSinceItWasIngested) {
  ASSERT_EQ(Refusal(), "");
  const Mission mission = ReadMission(*world_.store.Read());
  Ocean other;
  other.days = kDays + 1;
  Write("ocean.nc", other);
  FileCache cache(folder_, "");
  EXPECT_THROW(LoadWorkField(cache, mission, mission.work_fields[0]),
               kg_base::InputError);
}

TEST_F(IngestTest, TheDataFolderComesFirst) {
  fs::create_directory(Path("data"));
  fs::copy(Path("ocean.nc"), Path("data/ocean.nc"));
  const FileCache cache(folder_, Path("data"));
  EXPECT_EQ(cache.Resolve("ocean.nc"), Path("data/ocean.nc"));
  EXPECT_EQ(cache.Resolve("sst.nc"), Path("sst.nc"));
  EXPECT_EQ(cache.Resolve(Path("sst.nc")), Path("sst.nc"));
  EXPECT_THROW(cache.Resolve("none.nc"), kg_base::InputError);
}

TEST_F(IngestTest, AFileIsReadOnce) {
  FileCache cache(folder_, "");
  const auto first = cache.Read(Path("sst.nc"), {FieldQuantity::kTemperature});
  EXPECT_EQ(first, cache.Read(Path("sst.nc"), {FieldQuantity::kTemperature}));
}

TEST_F(IngestTest, AFileWrittenAnewTakesThePlaceOfTheOldOne) {
  FileCache cache(folder_, "");
  auto first = cache.Read(Path("sst.nc"), {FieldQuantity::kTemperature});
  const std::weak_ptr<const kg_base::FieldFile> old = first;
  Ocean longer;
  longer.days = kDays + 1;
  Write("sst.nc", longer);
  const auto second = cache.Read(Path("sst.nc"), {FieldQuantity::kTemperature});
  EXPECT_EQ(second->time_s.size(), first->time_s.size() + 1);
  first.reset();
  EXPECT_TRUE(old.expired());
}

double GetBuffer(const Mission& mission) {
  for (const Constraint& constraint : mission.constraints) {
    if (constraint.is_land) return constraint.buffer_cells;
  }
  return 0.0;
}

// Distance in cells from `position` to the nearest cell without data, by full
// search.
double CellsToLand(const VectorField& field, kg_base::LonLat position) {
  const auto cell = field.grid.CellAt(position);
  if (!cell) return -1.0;
  const kg_base::Mask land = field.NoData();
  double nearest = 1e9;
  for (int row = 0; row < field.grid.rows(); ++row) {
    for (int col = 0; col < field.grid.cols(); ++col) {
      if (land[field.grid.Index({row, col})] == 0) continue;
      nearest = std::min(nearest, std::hypot(row - cell->row, col - cell->col));
    }
  }
  return nearest;
}

// The shipped missions with their own data, if the data is present.
TEST(ShippedIngestTest, MissionsIngestTheirData) {
  const char* data = std::getenv("KG_DATA");
  const std::string gom = data ? data : "../../../shared/data/gom_2020";
  const std::vector<std::pair<std::string, std::string>> missions = {
      {"gulf", "../../config/missions/gulf/gulf_ocean.nc"},
      {"wildfire", "../../config/missions/wildfire/wildfire_weather.nc"},
      {"tampico", gom + "/currents_hycom_gomu_2020-11-01-15_5h.nc4"}};
  int count = 0;
  for (const auto& [name, file] : missions) {
    if (!fs::exists(file)) continue;
    ++count;
    MissionWorld world("");
    const std::string folder = "../../config/missions/" + name;
    Transaction transaction = world.store.Begin();
    ASSERT_EQ(Joined(StageFactsFile(folder + "/mission.ttl", transaction)), "");
    FileCache cache(folder, gom);
    ASSERT_EQ(Joined(StageIngest(cache, transaction)), "") << name;
    EXPECT_TRUE(Validate(transaction.view()).empty());
    const Mission mission = ReadMission(transaction.view());
    EXPECT_EQ(mission.work_fields.size(), mission.windows.size());
    EXPECT_EQ(mission.value_layers.size(), mission.windows.size());
    EXPECT_GE(mission.windows.size(), 6u);
    const VectorField field =
        LoadWorkField(cache, mission, mission.work_fields[0]);
    for (const Agent& agent : mission.agents) {
      EXPECT_GT(CellsToLand(field, agent.start), GetBuffer(mission))
          << name << " " << agent.id;
    }
  }
  if (count == 0) GTEST_SKIP() << "no ocean data beside the missions";
}

}  // namespace
}  // namespace kg_mission
