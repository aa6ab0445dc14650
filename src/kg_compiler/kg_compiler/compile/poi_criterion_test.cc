// A criterion for points of interest over data, added only by facts: cells of a
// generated field become facts where they exceed a limit, a SPARQL rule turns
// those that meet its criterion into events, and the compiled tensors contain
// them. Compared with brute force over the field's cells.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "kg_base/common/join_strings.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/geo/geodesy.h"
#include "kg_base/raster/testing/test_raster_file.h"
#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/stage_vocabulary.h"

namespace kg_compiler {
namespace {

using kg_base::Cell;
using kg_base::Grid;
using kg_base::LonLat;
using kg_base::Raster;

constexpr double kRadius_m = 9000.0;
constexpr double kConfidence[] = {1.0, 0.5};

constexpr char kFacts[] = R"ttl(
ex:m a ex:Mission ; ex:name "poi" ; ex:hasWindow ex:w0 , ex:w1 ;
    ex:hasAgent ex:alpha .
ex:currents a ex:DataSource ; ex:file "flow.nc" ; ex:provides "current" .
ex:w0 a ex:TimeWindow ; ex:index 0 ; ex:confidence 1 ; ex:durationHours 24 ;
    time:hasBeginning "2026-06-02T00:00:00Z"^^xsd:dateTime .
ex:w1 a ex:TimeWindow ; ex:index 1 ; ex:confidence 0.5 ; ex:durationHours 24 ;
    time:hasBeginning "2026-06-03T00:00:00Z"^^xsd:dateTime .
ex:poi a ex:Policy ; ex:alpha_base 0 ; ex:beta_poi 1 .
ex:alpha a ex:Agent ; ex:id "alpha" ; ex:usesPolicy ex:poi ;
    ex:hasCapabilities ex:can .
ex:can a ex:AgentCapabilities ; ex:cruiseSpeedKts 1 ; ex:maxSpeedKts 2 ;
    ex:energyPerKm 2 ; ex:hotelLoadW 1 ; ex:energyBudget 5000 ;
    ex:sensorRadiusKm 8 .
ex:start a ex:AgentState ; ex:forAgent ex:alpha ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-93.5 26.2)"^^geo:wktLiteral ; ex:headingDeg 0 .
ex:plankton a ex:SampledField ; ex:gridRef "plankton.nc#density" ;
    ex:sampleAbove 0.5 .
)ttl";

// The criterion: above 0.8, and in the first window only. The value of a visit
// grows with the excess.
constexpr char kRule[] = R"ttl(
ex:blooms a ex:Rule ; rdfs:label "blooms" ;
    rdfs:comment "Cells of dense plankton are worth a visit in the first window." ;
    ex:construct """
CONSTRUCT {
  ?event a ex:Event ; ex:forWindow ?window ; geo:asWKT ?position ;
      ex:value ?reward ; ex:radiusKm 9 .
}
WHERE {
  ?cell a ex:CellSample ; ex:ingestedFrom ex:plankton ;
      geo:asWKT ?position ; ex:cellValue ?density .
  FILTER(?density > 0.8)
  ?window a ex:TimeWindow ; ex:index 0 .
  BIND(10 * (?density - 0.8) AS ?reward)
  BIND(IRI(CONCAT(STR(?cell), "/event")) AS ?event)
}""" .
)ttl";

Grid EvenGrid(double west_deg, double south_deg, double step_deg, int rows,
              int cols) {
  std::vector<double> lon_deg, lat_deg;
  for (int i = 0; i < cols; ++i) lon_deg.push_back(west_deg + step_deg * i);
  for (int i = 0; i < rows; ++i) lat_deg.push_back(south_deg + step_deg * i);
  return Grid(lon_deg, lat_deg);
}

// Two patches, with values from 0 to about 1.1.
double Density(LonLat at) {
  const auto patch = [&](double lon_deg, double lat_deg, double width_deg) {
    return std::exp(-(std::pow(at.lon_deg - lon_deg, 2) +
                      std::pow(at.lat_deg - lat_deg, 2)) /
                    (2 * width_deg * width_deg));
  };
  return patch(-93.6, 26.25, 0.12) + 0.9 * patch(-93.2, 26.5, 0.15);
}

class PoiCriterionTest : public testing::Test {
 protected:
  PoiCriterionTest() {
    const std::vector<Raster> flow(4, Raster(grid_.size(), 0.1f));
    kg_base::TestRasterFileWriter(
        folder_ / "flow.nc",
        {grid_,
         {12, 36, 60, 84},
         {{"u", "eastward_sea_water_velocity", "m/s", flow},
          {"v", "northward_sea_water_velocity", "m/s", flow}}});
    for (int row = 0; row < field_.rows(); ++row) {
      for (int col = 0; col < field_.cols(); ++col) {
        density_.push_back(
            static_cast<float>(Density(field_.Centre({row, col}))));
      }
    }
    density_[0] = std::nanf("");
    kg_base::TestRasterFileWriter(
        folder_ / "plankton.nc",
        {field_, {}, {{"density", "", "", {density_}, false}}});
    kg_core::Transaction transaction = store_.Begin();
    kg_mission::StageVocabulary("../kg_mission/ontology", transaction);
    transaction.Commit(kg_core::WorldChange::kYes);
  }

  // Adds facts; returns the reasons for rejection, "" = accepted.
  std::string Add(const std::string& turtle) {
    kg_core::FactUpdate update;
    update.turtle = turtle;
    return Apply(update);
  }
  std::string Apply(const kg_core::FactUpdate& update) {
    kg_core::Transaction transaction = store_.Begin();
    const kg_mission::StagedUpdate staged =
        StageUpdateWithFiles(update, files_, transaction);
    if (staged.judgement.reasons.empty()) {
      transaction.Commit(kg_core::WorldChange::kYes);
    }
    return kg_base::JoinStrings(staged.judgement.reasons, "\n");
  }

  struct Bump {
    LonLat at;
    double value;
  };
  // The events expected from the criterion, cell by cell.
  std::vector<Bump> Expected(double limit) const {
    std::vector<Bump> bumps;
    for (std::size_t i = 0; i < density_.size(); ++i) {
      if (!(density_[i] > limit)) continue;
      const int row = static_cast<int>(i) / field_.cols();
      const int col = static_cast<int>(i) % field_.cols();
      bumps.push_back(
          {field_.Centre({row, col}), 10 * (double{density_[i]} - limit)});
    }
    return bumps;
  }

  // U from its definition: sums of bumps, divided by the largest, times w_t.
  std::vector<double> Utility(const std::vector<Bump>& bumps,
                              double confidence) const {
    std::vector<double> sums(grid_.size(), 0.0);
    for (int row = 0; row < grid_.rows(); ++row) {
      for (int col = 0; col < grid_.cols(); ++col) {
        for (const Bump& bump : bumps) {
          const double d_m =
              kg_base::Distance_m(grid_.Centre({row, col}), bump.at);
          sums[grid_.Index({row, col})] +=
              bump.value * std::exp(-d_m * d_m / (2 * kRadius_m * kRadius_m));
        }
      }
    }
    const double largest = *std::max_element(sums.begin(), sums.end());
    for (double& sum : sums) {
      sum = largest > 0.0 ? confidence * sum / largest : 0.0;
    }
    return sums;
  }

  void ExpectTensors(const std::vector<Bump>& bumps) {
    const kg_mission::Mission mission = kg_mission::ReadMission(*store_.Read());
    EXPECT_EQ(mission.events.size(), bumps.size());
    const auto compilation = compiler_.Compile(mission, ++version_, 0);
    ASSERT_EQ(compilation->tensors.size(), 2u);
    for (const auto& tensor : compilation->tensors) {
      const int window = tensor->window;
      // Outside its window an event gives no reward.
      const std::vector<double> expected = Utility(
          window == 0 ? bumps : std::vector<Bump>(), kConfidence[window]);
      const Raster utility = tensor->Get(Layer::kFused);
      ASSERT_EQ(utility.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_NEAR(utility[i], expected[i], 1e-4) << window << " " << i;
      }
    }
  }

  const Grid grid_ = EvenGrid(-94.0, 26.0, 0.05, 14, 22);
  // Grid of the data, different from the mission's.
  const Grid field_ = EvenGrid(-93.97, 26.04, 0.08, 8, 12);
  Raster density_;
  kg_base::TemporaryFolder folder_;
  kg_core::Store store_{""};
  kg_mission::FileCache files_{folder_ / "", ""};
  MissionCompiler compiler_{&files_};
  std::uint64_t version_ = 0;
};

TEST_F(PoiCriterionTest, CellsThatExceedALimitBecomeEventsOfTheTensors) {
  ASSERT_EQ(Add(kFacts), "");
  ExpectTensors({});  // Data alone have no value.
  ASSERT_EQ(Add(kRule), "");
  const std::vector<Bump> bumps = Expected(0.8);
  ASSERT_GT(bumps.size(), 3u);
  ASSERT_LT(bumps.size(), Expected(0.5).size());
  ExpectTensors(bumps);
}

TEST_F(PoiCriterionTest, FollowsTheRuleAndTheData) {
  ASSERT_EQ(Add(std::string(kFacts) + kRule), "");
  kg_core::FactUpdate off;
  off.set = {{"ex:blooms", "ex:enabled", "false"}};
  ASSERT_EQ(Apply(off), "");
  ExpectTensors({});
  off.set = {{"ex:blooms", "ex:enabled", "true"}};
  ASSERT_EQ(Apply(off), "");
  ExpectTensors(Expected(0.8));
  // A limit for facts above the rule's limit leaves fewer candidate cells.
  kg_core::FactUpdate higher;
  higher.set = {{"ex:plankton", "ex:sampleAbove", "0.95"}};
  ASSERT_EQ(Apply(higher), "");
  std::vector<Bump> left;
  for (const Bump& bump : Expected(0.8)) {
    if (bump.value / 10 + 0.8 > 0.95) left.push_back(bump);
  }
  ASSERT_LT(left.size(), Expected(0.8).size());
  ExpectTensors(left);
}

TEST_F(PoiCriterionTest, ATensorCitesItsEvents) {
  ASSERT_EQ(Add(std::string(kFacts) + kRule), "");
  const auto compilation =
      compiler_.Compile(kg_mission::ReadMission(*store_.Read()), ++version_, 0);
  const auto& sources = compilation->tensors.front()->derived_from;
  const auto is_event = [](const std::string& iri) {
    return iri.find("plankton/cell/") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(sources.begin(), sources.end(), is_event),
            static_cast<std::ptrdiff_t>(Expected(0.8).size()));
}

}  // namespace
}  // namespace kg_compiler
