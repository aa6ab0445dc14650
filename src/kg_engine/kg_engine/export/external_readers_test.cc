// Exported plans as programs of others read them: gpsbabel, GDAL's ogrinfo and
// netCDF's ncdump. Debian has no checker of the CF conventions; audit_test.py
// of package mission checks the attributes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "kg_base/common/temporary_folder.h"
#include "kg_engine/export/export_server.h"
#include "kg_engine/export/plan_tracks.h"
#include "kg_engine/server/testing/test_mission.h"
#include "kg_engine/server/testing/test_team.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

using testing::HasSubstr;

// Standard output; the test fails if the program does.
std::string RunProgram(const std::string& command) {
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  char block[4096];
  std::size_t count = 0;
  while ((count = std::fread(block, 1, sizeof block, pipe)) > 0) {
    output.append(block, count);
  }
  EXPECT_EQ(pclose(pipe), 0) << command << "\n" << output;
  return output;
}

class ExternalReadersTest : public testing::Test {
 protected:
  ExternalReadersTest() {
    MissionFolders folders;
    folders.mission = folder_ / "mission";
    folders.state = folder_ / "state";
    folders.ontology = "../kg_mission/ontology";
    WriteTestMission(folders.mission);
    MissionServer server(folders);
    MissionPlanning(&server).Plan();
    plan_ = ReadPlanTracks(*server.Read(), PlanGraph(1).text);
    for (const char* format : {"geojson", "gpx", "netcdf"}) {
      const auto answer =
          Export(*server.Read(), {format, {}, folder_ / format});
      EXPECT_TRUE(answer.ok) << answer.error;
    }
  }

  const PlannedAgent& agent() const { return plan_.agents.at(0); }
  std::size_t CountPoints() const {
    std::size_t count = 0;
    for (const Track& part : agent().parts) count += part.size();
    return count;
  }

  kg_base::TemporaryFolder folder_;
  PlanTracks plan_;
};

TEST_F(ExternalReadersTest, GpsbabelReadsStopsRouteAndTrack) {
  // As comma separated values: a line of names, then one per point.
  const auto count = [this](const std::string& kind) {
    const std::string lines = RunProgram("gpsbabel " + kind + " -i gpx -f " +
                                         (folder_ / "gpx") + " -o unicsv -F -");
    return std::count(lines.begin(), lines.end(), '\n') - 1;
  };
  const auto stops = static_cast<std::ptrdiff_t>(agent().stops.size());
  ASSERT_GT(stops, 0);
  EXPECT_EQ(count("-w"), stops);
  EXPECT_EQ(count("-r"), stops);
  EXPECT_EQ(count("-t"), static_cast<std::ptrdiff_t>(CountPoints()));
}

TEST_F(ExternalReadersTest, OgrReadsEveryFeature) {
  const std::string stops = std::to_string(agent().stops.size());
  const std::string ogrinfo = "ogrinfo -ro -so -al ";
  EXPECT_THAT(
      RunProgram(ogrinfo + (folder_ / "geojson")),
      HasSubstr("Feature Count: " + std::to_string(agent().stops.size() + 1)));
  const std::string gpx = "ogrinfo -ro -so " + (folder_ / "gpx");
  EXPECT_THAT(RunProgram(gpx + " waypoints"),
              HasSubstr("Feature Count: " + stops));
  EXPECT_THAT(RunProgram(gpx + " routes"), HasSubstr("Feature Count: 1"));
  EXPECT_THAT(RunProgram(gpx + " route_points"),
              HasSubstr("Feature Count: " + stops));
  EXPECT_THAT(RunProgram(gpx + " tracks"), HasSubstr("Feature Count: 1"));
}

TEST_F(ExternalReadersTest, NcdumpReadsTheTrajectory) {
  const std::string text =
      RunProgram("ncdump -t -v time " + (folder_ / "netcdf"));
  EXPECT_THAT(text, HasSubstr("obs = " + std::to_string(CountPoints()) + " ;"));
  EXPECT_THAT(text, HasSubstr(":featureType = \"trajectory\""));
  EXPECT_THAT(text, HasSubstr("row_size:sample_dimension = \"obs\""));
  // Times are dates, so their units and calendar are understood.
  EXPECT_THAT(text, HasSubstr("time = \"2"));
}

}  // namespace
}  // namespace kg_engine
