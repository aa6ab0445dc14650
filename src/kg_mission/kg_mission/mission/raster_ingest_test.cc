// Rasters of priors and constraints, from ex:gridRef to values on a grid.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/sha256.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/raster/testing/test_raster_file.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/expiry.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/ingested_facts.h"
#include "kg_mission/mission/layer_files.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/testing/mission_world.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

using kg_base::Grid;
using kg_base::Raster;
using kg_base::Resampling;
using kg_core::Ex;
using kg_core::FactUpdate;
using kg_core::Has;
using kg_core::Prov;
using kg_core::RdfType;
using kg_core::Term;

const float kNan = std::nanf("");

Grid EvenGrid(double west_deg, int cols) {
  std::vector<double> lon_deg, lat_deg;
  for (int i = 0; i < cols; ++i) lon_deg.push_back(west_deg + 0.1 * i);
  for (int i = 0; i < 4; ++i) lat_deg.push_back(26 + 0.1 * i);
  return Grid(lon_deg, lat_deg);
}

const Grid kGrid = EvenGrid(-94, 5);  // Grid of the mission, 4 x 5.

constexpr char kFacts[] = R"ttl(
ex:currents a ex:DataSource ; ex:file "ocean.nc" ; ex:provides "current" .
ex:reefs a ex:PriorLayer ; ex:name "reefs" ; ex:gridRef "habitat.nc#reef@1" .
ex:farm a ex:Constraint ; ex:kind "no_go" ; ex:gridRef "habitat.nc#farm" .
)ttl";

class RasterIngestTest : public testing::Test {
 protected:
  RasterIngestTest() {
    const std::vector<Raster> flow(4, Raster(kGrid.size(), 0.1f));
    kg_base::TestRasterFileWriter(
        Path("ocean.nc"),
        {kGrid,
         {12, 36, 60, 84},
         {{"u", "eastward_sea_water_velocity", "m/s", flow},
          {"v", "northward_sea_water_velocity", "m/s", flow}}});
    WriteHabitat(kGrid);
  }

  std::string Path(const std::string& name) const { return folder_ / name; }

  // Values 10 * step + cell - 5, cell 3 without data; the mask is cells 1, 2.
  void WriteHabitat(const Grid& grid) const {
    std::vector<Raster> reef(2, Raster(grid.size()));
    for (std::size_t i = 0; i < grid.size(); ++i) {
      for (int step : {0, 1}) reef[step][i] = 10.0f * step + i - 5.0f;
    }
    reef[1][3] = kNan;
    Raster farm(grid.size(), 0.0f);
    farm[1] = 1.0f;
    farm[2] = -3.0f;
    farm[4] = kNan;
    const Raster nothing(grid.size(), kNan);
    kg_base::TestRasterFileWriter(Path("habitat.nc"),
                                  {grid,
                                   {0, 24},
                                   {{"reef", "", "", reef},
                                    {"farm", "", "", {farm}, false},
                                    {"empty", "", "", {nothing, nothing}}}});
  }

  std::vector<std::string> Ingest(const FactUpdate& update) {
    kg_core::Transaction transaction = world_.store.Begin();
    FileCache cache(folder_ / "", "");
    const StagedUpdate staged =
        StageUpdateWithFiles(update, cache, transaction);
    if (staged.judgement.reasons.empty()) {
      transaction.Commit(kg_core::WorldChange::kYes);
    }
    return staged.judgement.reasons;
  }
  std::vector<std::string> Ingest(const std::string& turtle) {
    FactUpdate update;
    update.turtle = turtle;
    return Ingest(update);
  }
  bool Says(const Term& subject, const Term& property,
            const Term& object) const {
    return Has(*world_.store.Read(), kg_core::kFactsGraph, subject, property,
               object);
  }

  kg_base::TemporaryFolder folder_;
  MissionWorld world_;
};

const PriorLayer& Reefs(const Mission& mission) {
  for (const PriorLayer& prior : mission.priors) {
    if (prior.name == "reefs") return prior;
  }
  throw std::logic_error("no reefs");
}

const Constraint& Farm(const Mission& mission) {
  for (const Constraint& constraint : mission.constraints) {
    if (constraint.mask) return constraint;
  }
  throw std::logic_error("no mask");
}

TEST_F(RasterIngestTest, StatesTheFilesThatConformAndCanBeRead) {
  ASSERT_EQ(Joined(Ingest(kFacts)), "");
  const auto view = world_.store.Read();
  const auto violations = Validate(*view);
  EXPECT_TRUE(violations.empty()) << violations[0].Line();
  const Mission mission = ReadMission(*view);
  const PriorLayer& reefs = Reefs(mission);
  ASSERT_TRUE(reefs.raster);
  EXPECT_FALSE(reefs.area);
  EXPECT_EQ(reefs.raster->variable, "reef");
  EXPECT_EQ(reefs.raster->time_index, 1);
  const kg_core::SourceFile& file = mission.files.at(reefs.raster->file_iri);
  EXPECT_EQ(file.path, Path("habitat.nc"));
  EXPECT_EQ(file.sha256, kg_base::Sha256HexOfFile(Path("habitat.nc")));
  const Constraint& farm = Farm(mission);
  EXPECT_FALSE(farm.area || farm.is_land);
  EXPECT_EQ(farm.mask->time_index, 0);
}

TEST_F(RasterIngestTest, ReadsPriorsAsTheyAreAndMasksAsInsideOrNot) {
  ASSERT_EQ(Joined(Ingest(kFacts)), "");
  const Mission mission = ReadMission(*world_.store.Read());
  FileCache cache(folder_ / "", "");
  const GriddedRaster reefs =
      LoadRaster(cache, mission, *Reefs(mission).raster);
  EXPECT_TRUE(reefs.grid.AlmostEquals(kGrid));
  EXPECT_EQ(reefs.values[0], 5.0f);
  EXPECT_EQ(reefs.values[19], 24.0f);
  EXPECT_TRUE(std::isnan(reefs.values[3]));
  const kg_base::Mask farm =
      MakeMask(LoadRaster(cache, mission, *Farm(mission).mask).values);
  EXPECT_EQ(farm[0] + 10 * farm[1] + 100 * farm[2] + 1000 * farm[3], 110);
  EXPECT_EQ(farm[4], 0);  // No data.
}

TEST_F(RasterIngestTest, LeavesProvenanceFromFileToActivity) {
  ASSERT_EQ(Joined(Ingest(kFacts)), "");
  const auto view = world_.store.Read();
  EXPECT_TRUE(Says(Ex("reefs/file"), Ex("ingestedFrom"), Ex("reefs")));
  EXPECT_TRUE(Says(Ex("farm/file"), Ex("ingestedFrom"), Ex("farm")));
  bool is_used = false;
  for (const Term& activity : kg_core::Subjects(
           *view, kg_core::kProvGraph, Prov("used"), Ex("reefs/file"))) {
    is_used |=
        Has(*view, kg_core::kProvGraph, activity, RdfType(), Ex("Ingest")) &&
        Has(*view, kg_core::kProvGraph, activity, Prov("used"), Ex("reefs"));
  }
  EXPECT_TRUE(is_used);
}

TEST_F(RasterIngestTest, IsDueWhenARasterIsNamedChangedOrTakenBack) {
  ASSERT_EQ(Joined(Ingest(kFacts)), "");
  FactUpdate changed;
  changed.set = {{"ex:reefs", "ex:gridRef", "\"habitat.nc#reef@0\""}};
  ASSERT_EQ(Joined(Ingest(changed)), "");
  EXPECT_EQ(Reefs(ReadMission(*world_.store.Read())).raster->time_index, 0);
  FactUpdate drawn;  // Replaces the raster by an area.
  drawn.remove = {{"ex:reefs", "ex:gridRef", ""}};
  drawn.turtle =
      "ex:reefs geo:asWKT \"POLYGON((-94 26, -93 26, -93 27, -94 26))\" .";
  ASSERT_EQ(Joined(Ingest(drawn)), "");
  EXPECT_FALSE(Says(Ex("reefs/file"), RdfType(), Ex("SourceFile")));
  FactUpdate gone;
  gone.remove = {{"ex:farm", "", ""}};
  ASSERT_EQ(Joined(Ingest(gone)), "");
  EXPECT_FALSE(Says(Ex("farm/file"), RdfType(), Ex("SourceFile")));
  EXPECT_TRUE(Says(Ex("currents/file"), RdfType(), Ex("SourceFile")));
}

TEST_F(RasterIngestTest, IsNotDueForLandOrOtherFacts) {
  kg_core::Transaction transaction = world_.store.Begin();
  FactUpdate update;
  update.set = {{"ex:land", "ex:bufferCells", "3"},
                {"ex:land", "ex:resampling", "\"nearest\""},
                {"ex:sanctuary", "ex:attenuation", "0.2"}};
  update.turtle =
      "ex:coast a ex:Constraint ; ex:kind \"no_go\" ; ex:gridRef \"land\" .";
  ASSERT_EQ(Joined(StageUpdate(update, transaction)), "");
  EXPECT_FALSE(IngestIsDue(transaction));
}

TEST_F(RasterIngestTest, AFileOfARasterDoesNotKeepItAlive) {
  ASSERT_EQ(Joined(Ingest(std::string(kFacts) +
                          "ex:farm ex:validUntil "
                          "\"2026-06-02T12:00:00Z\"^^xsd:dateTime .")),
            "");
  const ExpiredFacts expiry = FindExpired(*world_.store.Read(), 1.9e9);
  EXPECT_EQ(Joined(expiry.kept).find("ex:farm"), std::string::npos)
      << Joined(expiry.kept);
  ASSERT_EQ(Joined(Ingest(expiry.update)), "");
  EXPECT_FALSE(Says(Ex("farm/file"), RdfType(), Ex("SourceFile")));
}

struct Wrong {
  const char* what;  // In kFacts,
  const char* by;
  const char* said;
};
const Wrong kWrong[] = {
    {"habitat.nc#reef", "nowhere.nc#reef", "file \"nowhere.nc\" not found"},
    {"#reef@1", "#coral@1",
     "no variable \"coral\", expected one of reef, farm, empty"},
    {"#reef@1", "#reef@2", "has 2 time steps, none with index 2"},
    {"#reef@1", "#empty@1", "variable empty has no data in step 1"},
    {"#farm", "#lat", "expected a latitude and a longitude"},
    {"ocean.nc", "habitat.nc", "no variable for eastward velocity"},
};

TEST_F(RasterIngestTest, RefusesWhatIsNotThereInOneLine) {
  for (const Wrong& wrong : kWrong) {
    std::string facts = kFacts;
    facts.replace(facts.find(wrong.what), std::string(wrong.what).size(),
                  wrong.by);
    const std::vector<std::string> said = Ingest(facts);
    ASSERT_EQ(said.size(), 1u) << wrong.by << ": " << Joined(said);
    EXPECT_NE(said[0].find(wrong.said), std::string::npos) << said[0];
    EXPECT_EQ(said[0].find('\n'), std::string::npos);
  }
}

TEST_F(RasterIngestTest, AnotherGridNeedsAWordAndIsResampledByIt) {
  const Grid shifted = EvenGrid(-93.95, 8);  // Half a cell to the east.
  WriteHabitat(shifted);
  const std::string refused = Joined(Ingest(kFacts));
  EXPECT_NE(refused.find("ex:reefs ex:resampling: expected"),
            std::string::npos);
  EXPECT_NE(refused.find("ex:farm ex:resampling: expected"), std::string::npos)
      << refused;
  EXPECT_NE(refused.find(shifted.Text()), std::string::npos) << refused;
  EXPECT_NE(refused.find(kGrid.Text()), std::string::npos) << refused;
  ASSERT_EQ(Joined(Ingest(std::string(kFacts) +
                          "ex:reefs ex:resampling \"bilinear\" . "
                          "ex:farm ex:resampling \"nearest\" .")),
            "");
  const Mission mission = ReadMission(*world_.store.Read());
  EXPECT_TRUE(Says(Ex("reefs/grid"), RdfType(), Ex("GridSpec")));
  EXPECT_TRUE(Says(Ex("reefs/grid"), Prov("wasDerivedFrom"), Ex("reefs/file")));
  FileCache cache(folder_ / "", "");
  const PriorLayer& reefs = Reefs(mission);
  EXPECT_EQ(reefs.raster->resampling, Resampling::kBilinear);
  const kg_base::SharedRaster values =
      OnGrid(reefs.iri, LoadRaster(cache, mission, *reefs.raster), kGrid,
             reefs.raster->resampling);
  EXPECT_EQ(values.size(), kGrid.size());
  EXPECT_NEAR(values[1], 5.5, 1e-4);  // Between 5 and 6.
  EXPECT_NEAR(values[0], 5.0, 1e-4);  // Within half a cell of the edge.
  FactUpdate silent;
  silent.remove = {{"ex:reefs", "ex:resampling", ""}};
  EXPECT_NE(Joined(Ingest(silent)), "");
}

TEST_F(RasterIngestTest, WhatLiesOutsideOfItsGridIsNoData) {
  const GriddedRaster part{EvenGrid(-93.8, 2), Raster(8, 7.0f)};
  const kg_base::SharedRaster values =
      OnGrid(Ex("reefs").text, part, kGrid, Resampling::kNearest);
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_EQ(values[2], 7.0f);
  EXPECT_TRUE(std::isnan(values[4]));
  EXPECT_THROW(OnGrid(Ex("reefs").text, part, kGrid, Resampling::kNone),
               kg_base::InputError);
}

TEST_F(RasterIngestTest, AFileThatChangedSinceIsRefused) {
  ASSERT_EQ(Joined(Ingest(kFacts)), "");
  const Mission mission = ReadMission(*world_.store.Read());
  WriteHabitat(EvenGrid(-94, 6));
  FileCache cache(folder_ / "", "");
  EXPECT_THROW(LoadRaster(cache, mission, *Farm(mission).mask),
               kg_base::InputError);
}

}  // namespace
}  // namespace kg_mission
