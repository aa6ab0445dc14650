#include "kg_compiler/explain/fact_warnings.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

using kg_mission::ConstraintKind;
using kg_mission::Mission;

// Cells of 0.05 degree from 9 to 11 E and 54 to 55 N, its four western columns
// land.
kg_base::Grid TestGrid() { return EvenGrid(9.025, 54.025, 0.05, 20, 40); }

struct WarningWorld {
  WarningWorld() {
    mission.files["ex:file"] = {"ex:file", "/file.nc", "sha"};
    for (int t = 0; t < 2; ++t) {
      mission.windows.push_back(TestWindow(t, 1.0));
      mission.work_fields.push_back(
          {"ex:field" + std::to_string(t), t, "ex:file", t, t + 1});
    }
    mission.agents = {TestAgent("alpha")};
    mission.agents[0].start = {10.0, 54.5};
    mission.agents[0].policy.alpha_base = 0.0;
    mission.agents[0].policy.beta_poi = 1.0;
    mission.coordination.waypoint_spacing_m = 5000.0;
  }

  std::vector<std::string> Warnings() const {
    return Lines(FindWarnings(*Compile()));
  }
  std::shared_ptr<const Compilation> Compile() const {
    RasterReaders readers;
    const int columns = land_columns;
    readers.field = [columns](const Mission&, const kg_mission::WorkFieldRef&) {
      kg_base::VectorField flow = UniformFlow(TestGrid(), 0.1, 0.0);
      for (int row = 0; row < 20; ++row) {
        for (int col = 0; col < columns; ++col) {
          flow.slices[0].east_mps[flow.grid.Index({row, col})] = kGap;
          flow.slices[0].north_mps[flow.grid.Index({row, col})] = kGap;
        }
      }
      return flow;
    };
    return MissionCompiler(readers).Compile(mission, 1, 0);
  }
  kg_mission::Constraint& AddArea(ConstraintKind kind,
                                  const kg_base::Geometry& area) {
    mission.constraints.push_back(AreaConstraint("ex:zone", kind, area));
    mission.constraints.back().attenuation = 0.5;
    return mission.constraints.back();
  }
  void AddEvent(kg_base::LonLat position, double radius_m) {
    mission.events.push_back({"ex:seep", position, 1.0, 1, radius_m, {1}});
  }

  Mission mission;
  int land_columns = 4;
};

// Exactly one line, which contains every part.
void ExpectOne(const std::vector<std::string>& lines,
               const std::vector<std::string>& parts) {
  ASSERT_EQ(lines.size(), 1u) << (lines.empty() ? "" : lines.back());
  for (const std::string& part : parts) {
    EXPECT_NE(lines[0].find(part), std::string::npos) << lines[0];
  }
}

TEST(FactWarnings, FactsThatMeetOpenCellsGiveNone) {
  WarningWorld world;
  for (const ConstraintKind kind :
       {ConstraintKind::kNoGo, ConstraintKind::kSoft}) {
    world.AddArea(kind, Box(9.5, 54.1, 9.8, 54.3));
  }
  // Thinner than a cell, but a no_go area closes what it touches.
  world.AddArea(ConstraintKind::kNoGo, Box(9.501, 54.1, 9.502, 54.3));
  kg_mission::Constraint land;
  land.iri = "ex:land";
  land.is_land = true;
  world.mission.constraints.push_back(land);
  world.mission.priors.push_back(
      {"ex:p", "p", Box(10.1, 54.1, 10.4, 54.4), 3000.0, {}, {}});
  world.AddEvent({10.2, 54.6}, 3000.0);
  world.AddEvent({9.19, 54.6}, 3000.0);   // On land, its radius reaches out.
  world.AddEvent({11.02, 54.6}, 3000.0);  // Off the grid, likewise.
  EXPECT_EQ(world.Warnings(), std::vector<std::string>());
}

TEST(FactWarnings, AreasOffTheGridAreNamedWithWhatMayBeMeant) {
  for (const ConstraintKind kind :
       {ConstraintKind::kNoGo, ConstraintKind::kSoft}) {
    WarningWorld far;
    far.AddArea(kind, Box(19.5, 54.1, 19.8, 54.3));
    ExpectOne(far.Warnings(), {"<ex:zone> has no effect", "off the grid",
                               "check its coordinates"});
    WarningWorld swapped;
    swapped.AddArea(kind, Box(54.1, 9.5, 54.3, 9.8));
    ExpectOne(swapped.Warnings(), {"<ex:zone> has no effect", "did you mean",
                                   "the other way round"});
  }
}

TEST(FactWarnings, ABufferThatReachesTheGridIsAnEffect) {
  WarningWorld world;
  kg_mission::Constraint& zone =
      world.AddArea(ConstraintKind::kNoGo, Box(11.06, 54.1, 11.5, 54.3));
  EXPECT_EQ(world.Warnings().size(), 1u);
  zone.buffer_cells = 3.0;
  EXPECT_EQ(world.Warnings().size(), 0u);
}

TEST(FactWarnings, AreasOnLandAndThinSoftOnesAreNamed) {
  WarningWorld on_land;
  on_land.AddArea(ConstraintKind::kNoGo, Box(9.01, 54.1, 9.1, 54.3));
  ExpectOne(on_land.Warnings(), {"<ex:zone> has no effect", "land only"});
  WarningWorld thin;
  thin.AddArea(ConstraintKind::kSoft, Box(9.501, 54.1, 9.51, 54.3));
  ExpectOne(thin.Warnings(), {"<ex:zone> has no effect", "no cell's centre"});
  WarningWorld prior;
  prior.mission.priors.push_back(
      {"ex:reef", "reef", Box(10.101, 54.1, 10.11, 54.4), 0.0, {}, {}});
  ExpectOne(prior.Warnings(), {"<ex:reef> has no effect", "no cell's centre"});
}

TEST(FactWarnings, LandThatNoCellIsIsNamedWithTheRemedy) {
  WarningWorld world;
  world.land_columns = 0;
  kg_mission::Constraint land;
  land.iri = "ex:land";
  land.is_land = true;
  world.mission.constraints.push_back(land);
  ExpectOne(world.Warnings(),
            {"<ex:land> has no effect", "every cell", "_FillValue"});
}

TEST(FactWarnings, EventsThatNobodyCanReachAreNamedWithTheCause) {
  WarningWorld on_land;
  on_land.AddEvent({9.05, 54.5}, 3000.0);
  ExpectOne(on_land.Warnings(), {"<ex:seep> has no effect", "on land"});
  WarningWorld far;
  far.AddEvent({54.5, 10.0}, 3000.0);
  ExpectOne(far.Warnings(),
            {"<ex:seep> has no effect", "off the grid", "did you mean"});
  WarningWorld closed;
  closed.AddArea(ConstraintKind::kNoGo, Box(10.3, 54.3, 10.7, 54.7));
  closed.AddEvent({10.5, 54.5}, 2000.0);
  ExpectOne(closed.Warnings(), {"<ex:seep> has no effect", "ex:zone"});
  // Not in the windows of the plan: no word.
  WarningWorld over;
  over.AddEvent({9.05, 54.5}, 3000.0);
  over.mission.events[0].windows = {};
  EXPECT_TRUE(over.Warnings().empty());
}

TEST(FactWarnings, AClosedStartIsNamedWithItsConstraint) {
  WarningWorld world;
  EXPECT_TRUE(FindClosedStarts(*world.Compile()).empty());
  world.mission.agents[0].start = {9.05, 54.5};
  ExpectOne(FindClosedStarts(*world.Compile()), {"agent alpha", "on land"});
  world.mission.agents[0].start = {12.0, 54.5};
  ExpectOne(FindClosedStarts(*world.Compile()), {"alpha", "off the grid"});
  world.mission.agents[0].start = {10.0, 54.5};
  kg_mission::Constraint& zone =
      world.AddArea(ConstraintKind::kNoGo, Box(9.9, 54.4, 10.1, 54.6));
  ExpectOne(FindClosedStarts(*world.Compile()), {"alpha", "in <ex:zone>"});
  zone.windows = {1};
  EXPECT_TRUE(FindClosedStarts(*world.Compile()).empty());
}

TEST(FactWarnings, SayWhereTheyLieForAMap) {
  WarningWorld world;
  world.AddArea(ConstraintKind::kNoGo, Box(54.4, 9.6, 55.0, 10.0));
  const std::vector<FactWarning> found = FindWarnings(*world.Compile());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].label.find("zone> has no effect"), std::string::npos);
  ASSERT_TRUE(found[0].place);
  EXPECT_NEAR(found[0].place->lon_deg, 54.7, 1e-9);
  EXPECT_NEAR(found[0].place->lat_deg, 9.8, 1e-9);
}

}  // namespace
}  // namespace kg_compiler
