// Exports of a planned mission, and edge cases of each format.

#include "kg_engine/export/export_server.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <netcdf>

#include "gtest/gtest.h"
#include "kg_base/common/date_time.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/common/text.h"
#include "kg_base/geo/geodesy.h"
#include "kg_base/text/json.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/syntax.h"
#include "kg_engine/export/atomic_file.h"
#include "kg_engine/export/cf_trajectory.h"
#include "kg_engine/export/plan_formats.h"
#include "kg_engine/export/plan_tracks.h"
#include "kg_engine/server/testing/test_mission.h"
#include "kg_engine/server/testing/test_team.h"
#include "kg_engine/simulation/track_position.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

namespace fs = std::filesystem;
using Json = kg_base::JsonValue;
using kg_base::ParseJson;

constexpr std::size_t kMaxBytes = 64u << 20;

// Eastward across the antimeridian within window 0.
PlanTracks Crossing() {
  PlanTracks plan;
  plan.run_iri = "http://example.org/mission/plan/1";
  plan.world_version = 3;
  plan.status = "ok";
  plan.mission_name = "a < b & \"c\"";
  PlannedAgent agent;
  agent.id = "alpha";
  PlannedStop stop;
  stop.status = "planned";
  stop.position = {-179.5, -10.25};
  stop.time_s = 200.0;
  agent.stops = {stop};
  agent.parts =
      CutAtAntimeridian({{{179.5, -10.0}, 100.0}, {{-179.5, -10.25}, 200.0}});
  plan.agents = {agent};
  return plan;
}

TEST(PlanFormats, GeoJsonCutsTracksAtTheAntimeridian) {
  const Json all = ParseJson(ToGeoJson(Crossing()));
  const Json& track = all.Find("features")->items.at(0);
  EXPECT_EQ(track.Find("geometry")->Find("type")->text, "MultiLineString");
  const Json& lines = *track.Find("geometry")->Find("coordinates");
  const Json& times = *track.Find("properties")->Find("coordTimes");
  ASSERT_EQ(lines.items.size(), 2u);
  ASSERT_EQ(times.items.size(), 2u);
  EXPECT_EQ(lines.items[0].items.back().items[0].text, "180.0");
  EXPECT_EQ(lines.items[1].items.front().items[0].text, "-180.0");
  EXPECT_EQ(times.items[1].items.front().text, "1970-01-01T00:02:30Z");
}

TEST(PlanFormats, GpxEscapesNamesAndKeepsLongitudesBelow180) {
  const std::string gpx = ToGpx(Crossing());
  EXPECT_NE(gpx.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_EQ(gpx.find("lon=\"180"), std::string::npos);
}

TEST(PlanFormats, MinutesAreCarriedIntoDegrees) {
  EXPECT_EQ(DegreesAndMinutes(-90.9), "-9054.0000");
  EXPECT_EQ(DegreesAndMinutes(25.70005), "2542.0030");
  EXPECT_EQ(DegreesAndMinutes(-69.99999999), "-7000.0000");
  EXPECT_EQ(DegreesAndMinutes(-0.5), "-030.0000");
  EXPECT_EQ(DegreesAndMinutes(0.05), "003.0000");
  EXPECT_EQ(DegreesAndMinutes(-1e-9), "000.0000");
}

TEST(PlanFormats, AGotoListHasTheStopsThatAreStillToBeMade) {
  PlanTracks plan = Crossing();
  PlannedStop past = plan.agents[0].stops[0];
  past.status = "executed";
  plan.agents[0].stops.push_back(past);
  const std::vector<std::string> lists = ToGotoLists(plan, plan.agents[0]);
  ASSERT_EQ(lists.size(), 1u);
  const std::string& list = lists[0];
  EXPECT_EQ(list.rfind("behavior_name=goto_list\n", 0), 0u);
  EXPECT_NE(list.find("num_waypoints(nodim) 1\n"), std::string::npos);
  EXPECT_NE(list.find("\n-17930.0000 -1015.0000  #"), std::string::npos);
  EXPECT_NE(list.find("list_when_wpt_dist(m) 10 "), std::string::npos);
}

TEST(PlanFormats, GotoListsHaveOneToEightWaypoints) {
  PlanTracks plan = Crossing();
  PlannedStop stop = plan.agents[0].stops[0];
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 16u, 17u}) {
    plan.agents[0].stops.assign(count, stop);
    for (std::size_t i = 0; i < count; ++i) {
      plan.agents[0].stops[i].window = static_cast<int>(i);
    }
    const auto lists = ToGotoLists(plan, plan.agents[0]);
    ASSERT_EQ(lists.size(), (count + 7) / 8) << count;
    std::size_t next = 0;
    for (const std::string& list : lists) {
      const std::size_t here = std::min<std::size_t>(8, count - next);
      EXPECT_NE(
          list.find("num_waypoints(nodim) " + std::to_string(here) + "\n"),
          std::string::npos)
          << list;
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(
            list.find("# w" + std::to_string(i) + " by") != std::string::npos,
            i >= next && i < next + here)
            << i << " of " << count;
      }
      next += here;
    }
  }
}

TEST(PlanFormats, AGpxRouteHasTheStopsThatAreStillToBeMade) {
  PlanTracks plan = Crossing();
  const std::string gpx = ToGpx(plan);
  EXPECT_NE(gpx.find("<rte>\n    <name>alpha</name>\n    <rtept lat="),
            std::string::npos);
  EXPECT_LT(gpx.find("</rte>"), gpx.find("<trk>"));
  plan.agents[0].stops[0].status = "executed";
  EXPECT_EQ(ToGpx(plan).find("<rte"), std::string::npos);
}

TEST(CfTrajectory, RefusesAPlanWithoutATrackAndLeavesNoFile) {
  const kg_base::TemporaryFolder folder;
  PlanTracks plan = Crossing();
  plan.agents[0].parts.clear();
  EXPECT_THROW(WriteCfTrajectory(plan, folder / "a.nc"), kg_base::InputError);
  EXPECT_FALSE(fs::exists(folder / "a.nc"));
}

TEST(CfTrajectory, AtTheAntimeridianATrackGoesOn) {
  const kg_base::TemporaryFolder folder;
  WriteCfTrajectory(Crossing(), folder / "a.nc");
  const netCDF::NcFile file(folder / "a.nc", netCDF::NcFile::read);
  int size = 0;
  file.getVar("row_size").getVar(&size);
  ASSERT_EQ(size, 3);  // Begin, cut, end.
  double time_s[3] = {};
  file.getVar("time").getVar(time_s);
  EXPECT_EQ(time_s[1], 150.0);
}

TEST(AtomicFile, IsThereWholeOrNotAtAll) {
  const kg_base::TemporaryFolder folder;
  const std::string path = folder / "a.txt";
  WriteAtomically(path, "one");
  EXPECT_THROW(WriteAtomically(path,
                               [](const std::string& temporary) {
                                 std::ofstream(temporary) << "half";
                                 throw kg_base::InputError("no more");
                               }),
               kg_base::InputError);
  EXPECT_EQ(kg_base::ReadFile(path, 100), "one");
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(path).parent_path()),
                          fs::directory_iterator()),
            1);
}

TEST(AtomicFile, RefusesInOneLineWhatCannotBeWritten) {
  const kg_base::TemporaryFolder folder;
  for (const std::string& path :
       {std::string("relative.txt"), folder / "no" + "/such/folder.txt",
        std::string(folder / ""), std::string("/proc/nothing")}) {
    try {
      WriteAtomically(path, "text");
      ADD_FAILURE() << path;
    } catch (const kg_base::InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
    }
  }
}

class ExportServerTest : public testing::Test {
 protected:
  ExportServerTest() {
    folders_.mission = folder_ / "mission";
    folders_.state = folder_ / "state";
    folders_.ontology = "../kg_mission/ontology";
    WriteTestMission(folders_.mission);
  }

  static ExportAnswer Export(const MissionServer& server,
                             const std::string& format,
                             const std::vector<std::string>& graphs = {},
                             const std::string& path = "") {
    return kg_engine::Export(*server.Read(), {format, graphs, path});
  }

  kg_base::TemporaryFolder folder_;
  MissionFolders folders_;
};

TEST_F(ExportServerTest, FactsReadBackAsWhatTheyWere) {
  MissionServer server(folders_);
  for (const char* format : {"turtle", "trig", "ntriples", "nquads"}) {
    const auto answer = Export(server, format, {"graph:facts", "graph:prov"});
    ASSERT_TRUE(answer.ok) << answer.error;
    EXPECT_EQ(answer.world_version, server.world_version());
    const auto* syntax = kg_core::SyntaxNamed(format);
    const auto read =
        kg_core::ParseRdf(answer.data, syntax->syntax,
                          {"export", kg_core::Iri(kg_core::kFactsGraph)});
    std::size_t count = 0;
    kg_core::Quad all;
    for (const char* graph : {kg_core::kFactsGraph, kg_core::kProvGraph}) {
      all.graph = server.Read()->Find(kg_core::Iri(graph));
      server.Read()->Match(all, [&](const kg_core::Quad&) {
        ++count;
        return true;
      });
    }
    EXPECT_EQ(read.size(), count) << format;
  }
  EXPECT_EQ(Export(server, "turtle").data,
            Export(server, "turtle", {kg_core::kFactsGraph}).data);
}

TEST_F(ExportServerTest, APlanIsExportedFromTheStoreAloneAfterARestart) {
  std::string before;
  {
    MissionServer server(folders_);
    EXPECT_FALSE(Export(server, "geojson").ok);
    EXPECT_EQ(Export(server, "geojson").error, "there is no plan yet");
    MissionPlanning(&server).Plan();
    before = Export(server, "geojson").data;
  }
  MissionServer server(folders_);
  const auto answer = Export(server, "geojson");
  ASSERT_TRUE(answer.ok) << answer.error;
  EXPECT_EQ(answer.data, before);
  const Json all = ParseJson(answer.data);
  EXPECT_EQ(all.Find("features")->items.size(), 3u);  // A track, two stops.
  EXPECT_EQ(Export(server, "gpx", {"graph:plan/9"}).error,
            "graph 'graph:plan/9' is not in the store");
  EXPECT_TRUE(Export(server, "gpx", {PlanGraph(1).text}).ok);
}

// The plan with bent tracks, as under currents: between two points half an hour
// or more apart a turning point 2 km beside the straight line.
kg_selector::CommittedPlan Bent(kg_selector::CommittedPlan plan) {
  for (kg_selector::PathAssignment& assignment : plan.assignments) {
    Track bent;
    for (const kg_compiler::TimedPoint& point : assignment.pathlet.track) {
      if (!bent.empty() && point.time_s - bent.back().time_s >= 1800) {
        kg_compiler::TimedPoint turn = point;
        turn.position.lat_deg += bent.size() % 4 == 1 ? 0.02 : -0.02;
        turn.time_s = 0.5 * (bent.back().time_s + point.time_s);
        bent.push_back(turn);
      }
      bent.push_back(point);
    }
    assignment.pathlet.track = bent;
  }
  return plan;
}

Track TrackOfGeoJson(const std::string& text) {
  const Json all = ParseJson(text);
  const Json& feature = all.Find("features")->items.at(0);
  const auto& lines = feature.Find("geometry")->Find("coordinates")->items;
  const auto& times = feature.Find("properties")->Find("coordTimes")->items;
  Track track;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    track.push_back(
        {{std::stod(lines[i].items[0].text), std::stod(lines[i].items[1].text)},
         kg_base::ParseDateTime(times.at(i).text)});
  }
  return track;
}

Track TrackOfGpx(const std::string& text) {
  Track track;
  for (std::size_t at = text.find("<trkpt"); at != std::string::npos;
       at = text.find("<trkpt", at + 1)) {
    double lat = 0.0, lon = 0.0;
    char time[40] = {};
    EXPECT_EQ(3, std::sscanf(text.c_str() + at,
                             "<trkpt lat=\"%lf\" lon=\"%lf\"><time>%39[^<]",
                             &lat, &lon, time));
    track.push_back({{lon, lat}, kg_base::ParseDateTime(time)});
  }
  return track;
}

Track TrackOfNetCdf(const std::string& path) {
  const netCDF::NcFile file(path, netCDF::NcFile::read);
  const std::size_t size = file.getDim("obs").getSize();
  const auto read = [&](const char* name) {
    std::vector<double> values(size);
    file.getVar(name).getVar(values.data());
    return values;
  };
  const std::vector<double> lon = read("lon"), lat = read("lat");
  const std::vector<double> time_s = read("time");
  Track track;
  for (std::size_t i = 0; i < size; ++i) {
    track.push_back({{lon[i], lat[i]}, time_s[i]});
  }
  return track;
}

// Tolerances: track simplification in facts (10 m), one second and one
// centimetre.
void ExpectSameWay(const Track& committed, const Track& exported) {
  ASSERT_GE(exported.size(), 2u);
  for (const auto& point : committed) {
    EXPECT_LT(
        kg_base::Distance_m(PositionAt(exported, point.time_s), point.position),
        12.0);
  }
}

TEST_F(ExportServerTest, TracksAreExportedWithTheirTurningPoints) {
  MissionServer server(folders_);
  MissionPlanning team(&server);
  const kg_selector::CommittedPlan straight = team.Plan();
  PlanRecord record;
  record.plan = Bent(straight);
  ++record.plan.run;
  server.RecordPlan(record);
  const Track committed = record.plan.assignments.at(0).pathlet.track;
  const auto& before = straight.assignments.at(0).pathlet.track;
  ASSERT_GE(committed.size(), before.size() + 2);
  ExpectSameWay(committed, TrackOfGeoJson(Export(server, "geojson").data));
  ExpectSameWay(committed, TrackOfGpx(Export(server, "gpx").data));
  const std::string path = folder_ / "plan.nc";
  ASSERT_TRUE(Export(server, "netcdf", {}, path).ok);
  ExpectSameWay(committed, TrackOfNetCdf(path));
}

TEST_F(ExportServerTest, FilesEqualTheAnswer) {
  MissionServer server(folders_);
  MissionPlanning(&server).Plan();
  for (const char* format : {"turtle", "geojson", "gpx"}) {
    const std::string path = folder_ / format;
    const auto answer = Export(server, format, {}, path);
    ASSERT_TRUE(answer.ok) << answer.error;
    EXPECT_TRUE(answer.data.empty());
    EXPECT_EQ(kg_base::ReadFile(path, kMaxBytes), Export(server, format).data);
  }
  ASSERT_TRUE(Export(server, "goto", {}, folder_ / "goto").ok);
  EXPECT_NE(Export(server, "goto")
                .data.find(kg_base::ReadFile(folder_ / "goto/alpha/goto_l10.ma",
                                             kMaxBytes)),
            std::string::npos);
}

TEST_F(ExportServerTest, LeavesNoGotoListThatIsNotOfThePlan) {
  MissionServer server(folders_);
  MissionPlanning(&server).Plan();
  const std::string list = folder_ / "goto/alpha/goto_l10.ma";
  const std::string old = folder_ / "goto/alpha/goto_l11.ma";
  const std::string others = folder_ / "goto/alpha/goto_l12.ma";
  ASSERT_TRUE(Export(server, "goto", {}, folder_ / "goto").ok);
  fs::copy_file(list, old);  // As of a longer plan.
  WriteAtomically(others, "behavior_name=goto_list\n# By hand\n");
  ASSERT_TRUE(Export(server, "goto", {}, folder_ / "goto").ok);
  EXPECT_TRUE(fs::exists(list));
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(others));
}

TEST_F(ExportServerTest, WritesNoGotoListIfAllIsFlown) {
  MissionServer server(folders_);
  MissionPlanning team(&server);
  team.Plan();
  const std::string list = folder_ / "goto/alpha/goto_l10.ma";
  ASSERT_TRUE(Export(server, "goto", {}, folder_ / "goto").ok);
  EXPECT_TRUE(fs::exists(list));
  server.RecordEnd();
  for (const std::string& path : {std::string(), folder_ / "goto"}) {
    const auto answer = Export(server, "goto", {}, path);
    EXPECT_FALSE(answer.ok);
    EXPECT_NE(answer.error.find("no stop left to fly"), std::string::npos)
        << answer.error;
  }
  EXPECT_FALSE(fs::exists(list));
}

TEST_F(ExportServerTest, RefusesInOneLineWhatItCannotDo) {
  MissionServer server(folders_);
  MissionPlanning(&server).Plan();
  const struct {
    const char* format;
    std::vector<std::string> graphs;
    std::string path;
    const char* why;
  } kCases[] = {
      {"pdf", {}, "", "format 'pdf' is not known; expected turtle"},
      {"netcdf", {}, "", "expected a path"},
      {"turtle", {"graph:fact"}, "", "is not in the store"},
      {"gpx", {"graph:facts"}, "", "holds no plan"},
      {"gpx", {"graph:facts", "graph:prov"}, "", "one plan"},
      {"gpx", {}, "plan.gpx", "absolute path"},
      {"gpx", {}, "/proc/plan.gpx", "/proc/plan.gpx: cannot be written"},
      {"goto", {}, "/proc/goto", "/proc/goto/alpha: cannot be made"},
      {"netcdf", {}, "/proc/plan.nc", "/proc/plan.nc"},
  };
  for (const auto& one : kCases) {
    const auto answer = Export(server, one.format, one.graphs, one.path);
    EXPECT_FALSE(answer.ok) << one.why;
    EXPECT_NE(answer.error.find(one.why), std::string::npos) << answer.error;
    EXPECT_EQ(answer.error.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace kg_engine
