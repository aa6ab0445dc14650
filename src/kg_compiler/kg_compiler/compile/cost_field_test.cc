// A cost field (wave height) from a NetCDF file and facts to the seams of an
// agent: read, weighted, summed, hashed and explained. With weight 0 all
// results stay bit-identical.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "kg_base/common/temporary_folder.h"
#include "kg_base/common/units.h"
#include "kg_base/raster/testing/test_raster_file.h"
#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/control_plane/nav_graph.h"
#include "kg_compiler/explain/explain_seam.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/stage_vocabulary.h"

namespace kg_compiler {
namespace {

constexpr char kFacts[] = R"ttl(
ex:m a ex:Mission ; ex:name "waves" ; ex:hasWindow ex:w0 , ex:w1 ;
    ex:hasAgent ex:alpha ; ex:waypointSpacingKm 8 .
ex:currents a ex:DataSource ; ex:file "sea.nc" ; ex:provides "current" .
ex:sst a ex:DataSource ; ex:file "sea.nc" ; ex:provides "temperature" ;
    ex:kind "sst" .
ex:w0 a ex:TimeWindow ; ex:index 0 ; ex:confidence 1 ; ex:durationHours 24 ;
    time:hasBeginning "2026-06-02T00:00:00Z"^^xsd:dateTime .
ex:w1 a ex:TimeWindow ; ex:index 1 ; ex:confidence 0.8 ; ex:durationHours 24 ;
    time:hasBeginning "2026-06-03T00:00:00Z"^^xsd:dateTime .
ex:policy a ex:Policy ; ex:alpha_base 1 ; ex:valueKind "sst" ;
    ex:lambda_time 0.1 .
ex:alpha a ex:Agent ; ex:id "alpha" ; ex:usesPolicy ex:policy ;
    ex:hasCapabilities ex:can .
ex:can a ex:AgentCapabilities ; ex:cruiseSpeedKts 0.7 ; ex:maxSpeedKts 1.5 ;
    ex:energyPerKm 2 ; ex:energyBudget 500 ; ex:sensorRadiusKm 8 .
ex:a0 a ex:AgentState ; ex:forAgent ex:alpha ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-97 22)" .
)ttl";
constexpr char kWaves[] =
    "ex:sea_state a ex:DataSource ; ex:file \"waves.nc\" ; "
    "ex:provides \"wave_height\" ; ex:resampling \"bilinear\" .";
constexpr char kPrice[] = "ex:policy ex:lambda_waveHeight 0.5 .";

// Linear, so that bilinear resampling reproduces it exactly.
double Waves(kg_base::LonLat at) {
  return 2.0 + 0.8 * (at.lon_deg + 97.0) + 0.5 * (at.lat_deg - 22.0);
}

kg_base::Grid GridOf(double west, double south, double step, int rows,
                     int cols) {
  std::vector<double> lon_deg, lat_deg;
  for (int i = 0; i < cols; ++i) lon_deg.push_back(west + step * i);
  for (int i = 0; i < rows; ++i) lat_deg.push_back(south + step * i);
  return {lon_deg, lat_deg};
}

class CostFieldTest : public testing::Test {
 protected:
  CostFieldTest() {
    const std::vector<double> hours = {12, 36, 60, 84};
    const kg_base::Grid grid = GridOf(-97.5, 21.5, 0.05, 22, 22);
    const kg_base::Raster still(grid.size(), 0.0f);
    kg_base::Raster warmth(grid.size());
    for (std::size_t i = 0; i < warmth.size(); ++i) {
      warmth[i] = 20.0f + std::sin(0.37f * static_cast<float>(i));
    }
    using Steps = std::vector<kg_base::Raster>;
    kg_base::TestRasterFileWriter(
        folder_ / "sea.nc",
        {grid,
         hours,
         {{"u", "eastward_sea_water_velocity", "m/s", Steps(4, still)},
          {"v", "northward_sea_water_velocity", "m/s", Steps(4, still)},
          {"t", "sea_surface_temperature", "degC", Steps(4, warmth)}}});
    // Heights on a coarser grid that covers the grid of the currents.
    const kg_base::Grid coarse = GridOf(-98, 21, 0.25, 9, 9);
    kg_base::Raster heights;
    for (int row = 0; row < coarse.rows(); ++row) {
      for (int col = 0; col < coarse.cols(); ++col) {
        heights.push_back(
            static_cast<float>(100.0 * Waves(coarse.Centre({row, col}))));
      }
    }
    kg_base::TestRasterFileWriter(
        folder_ / "waves.nc", {coarse,
                               hours,
                               {{"swh", "sea_surface_wave_significant_height",
                                 "cm", Steps(4, heights)}}});
    kg_core::Transaction transaction = store_.Begin();
    kg_mission::StageVocabulary("../kg_mission/ontology", transaction);
    transaction.Commit(kg_core::WorldChange::kYes);
    EXPECT_EQ(Add(kFacts), "");
  }

  std::string Add(const std::string& turtle) {
    kg_core::FactUpdate update;
    update.turtle = turtle;
    kg_core::Transaction transaction = store_.Begin();
    const kg_mission::StagedUpdate staged =
        StageUpdateWithFiles(update, files_, transaction);
    std::string lines;
    for (const std::string& line : staged.judgement.reasons) {
      lines += line + "\n";
    }
    if (lines.empty()) transaction.Commit(kg_core::WorldChange::kYes);
    return lines;
  }

  NavGraphs Graphs() {
    compilation_ = compiler_.Compile(kg_mission::ReadMission(*store_.Read()),
                                     ++version_, 0);
    std::vector<WindowWorld> worlds;
    for (std::size_t i = 0; i < compilation_->fields.size(); ++i) {
      worlds.push_back(
          {compilation_->tensors[i].get(), &compilation_->fields[i]->field});
    }
    return CompileNavGraphs(compilation_->rules[0], worlds, nullptr);
  }

  kg_base::TemporaryFolder folder_;
  kg_core::Store store_{""};
  kg_mission::FileCache files_{folder_ / "", ""};
  MissionCompiler compiler_{&files_};
  std::shared_ptr<const Compilation> compilation_;
  std::uint64_t version_ = 0;
};

// Closed form of X for a linear field and straight legs.
double ClosedForm(const FlownPath& flight) {
  double sum = 0.0;
  for (std::size_t i = 1; i < flight.track.size(); ++i) {
    const TimedPoint &a = flight.track[i - 1], &b = flight.track[i];
    if (a.position == b.position) continue;
    sum +=
        0.5 * (Waves(a.position) + Waves(b.position)) * (b.time_s - a.time_s);
  }
  return sum;
}

TEST_F(CostFieldTest, CostsItsIntegralAlongTheFlightTimesItsPrice) {
  const NavGraphs before = Graphs();
  ASSERT_EQ(Add(std::string(kWaves) + kPrice), "");
  const NavGraphs after = Graphs();
  ASSERT_EQ(before.size(), after.size());
  int dearer = 0;
  for (std::size_t t = 0; t < before.size(); ++t) {
    ASSERT_EQ(before[t].edges.size(), after[t].edges.size());
    EXPECT_NE(before[t].hash, after[t].hash);
    for (std::size_t e = 0; e < after[t].edges.size(); ++e) {
      const TraverseEdge& edge = after[t].edges[e];
      ASSERT_EQ(edge.exposures.size(), 1u);
      const double exposure = ClosedForm(edge.flight);
      EXPECT_NEAR(edge.exposures[0], exposure, 1e-4 * exposure);
      EXPECT_EQ(edge.seam_cost,
                before[t].edges[e].seam_cost +
                    0.5 / kg_base::kSecondsPerHour * edge.exposures[0]);
      dearer += edge.seam_cost > before[t].edges[e].seam_cost;
    }
  }
  EXPECT_GT(dearer, 20);
  EXPECT_NE(SeamRulesHash(compilation_->rules[0]), "");
}

TEST_F(CostFieldTest, ChangesNoBitWithoutAPriceAndPricesNothingWithoutAField) {
  const NavGraphs plain = Graphs();
  const std::string rules = SeamRulesHash(compilation_->rules[0]);
  ASSERT_EQ(Add(kWaves), "");
  const NavGraphs unpriced = Graphs();
  EXPECT_EQ(SeamRulesHash(compilation_->rules[0]), rules);
  for (std::size_t t = 0; t < plain.size(); ++t) {
    ASSERT_EQ(plain[t].edges.size(), unpriced[t].edges.size());
    for (std::size_t e = 0; e < plain[t].edges.size(); ++e) {
      EXPECT_EQ(plain[t].edges[e].seam_cost, unpriced[t].edges[e].seam_cost);
    }
  }
}

TEST_F(CostFieldTest, IsNotMetWhereThereIsOnlyAPrice) {
  const NavGraphs plain = Graphs();
  const std::string rules = SeamRulesHash(compilation_->rules[0]);
  ASSERT_EQ(Add(kPrice), "");
  const NavGraphs priced = Graphs();
  EXPECT_NE(SeamRulesHash(compilation_->rules[0]), rules);
  for (std::size_t t = 0; t < plain.size(); ++t) {
    for (std::size_t e = 0; e < plain[t].edges.size(); ++e) {
      EXPECT_EQ(plain[t].edges[e].seam_cost, priced[t].edges[e].seam_cost);
    }
  }
}

TEST_F(CostFieldTest, IsExplainedWithItsPriceItsLayerAndItsFile) {
  ASSERT_EQ(Add(std::string(kWaves) + kPrice), "");
  const NavGraphs graphs = Graphs();
  const auto view = store_.Read();
  const CitedFacts facts(*view);
  const kg_mission::Agent& agent = compilation_->mission.agents[0];
  const SeamContext context =
      FindSeamContext(*compilation_, agent, compilation_->rules[0], 1);
  // Some edges stay in place and have no exposure: take the largest.
  const TraverseEdge& edge =
      *std::max_element(graphs[1].edges.begin(), graphs[1].edges.end(),
                        [](const TraverseEdge& a, const TraverseEdge& b) {
                          return a.exposures[0] < b.exposures[0];
                        });
  const Explanation explanation = ExplainSeam(context, edge, facts);
  double sum = 0.0;
  std::string cited;
  for (const Contribution& part : explanation.parts) {
    sum += part.value;
    if (part.term != "lambda_waveHeight * X") continue;
    EXPECT_GT(part.value, 0.0);
    for (const std::string& fact : part.facts) cited += fact + "\n";
  }
  EXPECT_NEAR(sum, edge.seam_cost, 1e-12);
  EXPECT_NE(cited.find("lambda_waveHeight"), std::string::npos) << cited;
  EXPECT_NE(cited.find("sea_state/w1"), std::string::npos) << cited;
  EXPECT_NE(cited.find("sha256"), std::string::npos) << cited;
}

TEST_F(CostFieldTest, IsRefusedOnAnotherGridUnlessResamplingIsDeclared) {
  const std::string said =
      Add("ex:sea_state a ex:DataSource ; ex:file \"waves.nc\" ; "
          "ex:provides \"wave_height\" .");
  EXPECT_NE(said.find("ex:resampling"), std::string::npos) << said;
}

}  // namespace
}  // namespace kg_compiler
