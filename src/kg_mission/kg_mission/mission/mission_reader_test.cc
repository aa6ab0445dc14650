#include "kg_mission/mission/mission_reader.h"

#include <gtest/gtest.h>

#include <string>

#include "kg_base/common/input_error.h"
#include "kg_base/common/units.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/turtle.h"
#include "kg_mission/mission/testing/mission_world.h"

namespace kg_mission {
namespace {

using kg_core::Ex;

Mission ReadWith(const std::string& more = "") {
  return ReadMission(
      *MissionWorld(std::string(kTestFacts) + more).store.Read());
}

// The error of the reader for facts that have not been validated by shapes.
std::string GetRefusal(const std::string& turtle) {
  kg_core::Store store("");
  kg_core::Transaction transaction = store.Begin();
  for (const char* file : {"ontology/mission.ttl"}) {
    for (const kg_core::Statement& s :
         kg_core::ParseTurtleFile(file, kg_core::Iri(kg_core::kVocabGraph))) {
      transaction.Add(s);
    }
  }
  for (const auto& s : kg_core::ParseTurtle(turtle, "t", kg_core::Facts())) {
    transaction.Add(s);
  }
  try {
    ReadMission(transaction.view());
  } catch (const kg_base::InputError& error) {
    return error.what();
  }
  return "";
}

std::string Replace(std::string text, const std::string& what,
                    const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("no " + what);
  return text.replace(at, what.size(), by);
}

TEST(MissionReaderTest, UnitsOfFactsBecomeSi) {
  const Mission mission = ReadWith();
  const Capabilities& can = mission.agents.at(0).capabilities;
  EXPECT_DOUBLE_EQ(can.cruise_mps, 1852.0 / 3600.0);
  EXPECT_DOUBLE_EQ(can.max_mps, 1.5 * 1852.0 / 3600.0);
  EXPECT_DOUBLE_EQ(can.energy_per_m_j, 7.2);  // 2 Wh/km.
  EXPECT_DOUBLE_EQ(can.energy_budget_j, 500 * 3600.0);
  EXPECT_DOUBLE_EQ(can.sensor_radius_m, 12000.0);
  EXPECT_FALSE(can.base_travel_m);
  const Policy& safe = mission.agents.at(0).policy;
  EXPECT_DOUBLE_EQ(safe.lambda_time_per_s, 0.001);
  EXPECT_DOUBLE_EQ(safe.lambda_energy_per_j, 0.0001);
  EXPECT_DOUBLE_EQ(mission.agents[0].start_heading_rad, kg_base::kPi / 2);
  EXPECT_DOUBLE_EQ(mission.coordination.separation_m, 5000.0);
  EXPECT_DOUBLE_EQ(mission.priors.at(0).edge_m, 2000.0);
}

TEST(MissionReaderTest, AgentsCarryTheirPolicyByIri) {
  const Mission mission = ReadWith();
  ASSERT_EQ(mission.agents.size(), 2u);
  const Agent& alpha = mission.agents[0];
  EXPECT_EQ(alpha.id, "alpha");
  EXPECT_EQ(alpha.policy.iri, Ex("safe").text);
  EXPECT_EQ(alpha.policy.name, "safe");
  EXPECT_EQ(alpha.policy.beta.at(Ex("corridor").text), 0.8);
  EXPECT_EQ(alpha.policy.soft_overrides.at(Ex("sanctuary").text), 0.1);
  for (const char* name : {"corridor", "sanctuary"}) {
    EXPECT_NE(alpha.policy.weight_iris.at(Ex(name).text).find(name),
              std::string::npos);
  }
  EXPECT_EQ(alpha.start, (kg_base::LonLat{-93.5, 26.5}));
  EXPECT_EQ(alpha.start_iri, Ex("alpha_start").text);
  EXPECT_EQ(mission.FindAgent(Ex("bravo").text), &mission.agents[1]);
  EXPECT_EQ(mission.FindAgent("nobody"), nullptr);
}

TEST(MissionReaderTest, WindowsEndWithDurationOrTheNextBegin) {
  const Mission mission = ReadWith();
  ASSERT_EQ(mission.windows.size(), 2u);
  EXPECT_EQ(mission.windows[0].end_s, mission.windows[1].begin_s);
  EXPECT_EQ(mission.windows[1].duration_s(), 86400.0);
  EXPECT_EQ(mission.windows[0].begin_s, 1780358400.0);  // 2026-06-02T00:00Z.
}

TEST(MissionReaderTest, ConstraintsAreAreasOrLand) {
  const Mission mission = ReadWith();
  ASSERT_EQ(mission.constraints.size(), 3u);
  const Constraint& cool = mission.constraints[0];
  EXPECT_TRUE(cool.AppliesTo(Ex("bravo").text, 1));
  EXPECT_FALSE(cool.AppliesTo(Ex("bravo").text, 0));
  EXPECT_FALSE(cool.AppliesTo(Ex("alpha").text, 1));
  const Constraint& land = mission.constraints[1];
  EXPECT_TRUE(land.is_land);
  EXPECT_EQ(land.kind, ConstraintKind::kNoGo);
  EXPECT_EQ(land.buffer_cells, 5.0);
  const Constraint& sanctuary = mission.constraints[2];
  EXPECT_TRUE(sanctuary.area.has_value());
  EXPECT_EQ(sanctuary.attenuation, 0.4);
  EXPECT_TRUE(sanctuary.AppliesTo("anybody", 1));
}

TEST(MissionReaderTest, EventsLiveFromTheirFirstWindowToTheirExpiry) {
  const auto windows = [](const std::string& more) {
    return ReadWith(more).events.at(0).windows;
  };
  EXPECT_EQ(windows(""), std::vector<int>{0});
  EXPECT_EQ(windows("ex:seep ex:expiresAfter \"P2D\"^^xsd:duration ."),
            (std::vector<int>{0, 1}));
  EXPECT_EQ(windows("ex:seep ex:expiresAfter \"PT24H\"^^xsd:duration ."),
            std::vector<int>{0});
  EXPECT_EQ(windows("ex:seep ex:expiresAfter "
                    "\"2026-06-01T00:00:00Z\"^^xsd:dateTime ."),
            std::vector<int>{});
}

TEST(MissionReaderTest, AHorizonLeavesOutLaterWindows) {
  const Mission mission = ReadWith(
      "ex:m ex:horizon 1 . ex:late a ex:Event ; ex:forWindow ex:w1 ; ex:value "
      "1 ; geo:asWKT \"POINT(-93 27)\" .");
  EXPECT_EQ(mission.windows.size(), 1u);
  EXPECT_EQ(mission.events.at(0).iri, Ex("late").text);
  EXPECT_TRUE(mission.events[0].windows.empty());
}

TEST(MissionReaderTest, AgentsStartFromTheirEarliestState) {
  const Mission mission = ReadWith(
      "ex:later a ex:AgentState ; ex:forAgent ex:alpha ; ex:forWindow ex:w1 ; "
      "geo:asWKT \"POINT(-93 26)\" .");
  EXPECT_EQ(mission.agents[0].start_iri, Ex("alpha_start").text);
}

TEST(MissionReaderTest, LayersAndFilesKeepTheirReferences) {
  const Mission mission = ReadWith(kTestArtifacts);
  ASSERT_EQ(mission.work_fields.size(), 1u);
  EXPECT_EQ(mission.work_fields[0].file_iri, Ex("file1").text);
  EXPECT_EQ(mission.work_fields[0].last_time_index, 1);
  ASSERT_EQ(mission.value_layers.size(), 1u);  // Stated as ex:BaseLayer.
  EXPECT_EQ(mission.value_layers[0].kind, "delta_sst");
  EXPECT_EQ(mission.value_layers[0].previous_time_index, 0);
  EXPECT_EQ(mission.files.at(Ex("file1").text).path, "/data/x.nc");
}

TEST(MissionReaderTest, OrderDoesNotDependOnTheOrderOfTheFacts) {
  const Mission a = ReadWith(
      "ex:a1 a ex:PriorLayer ; ex:name \"a\" ; "
      "geo:asWKT \"POLYGON((0 0, 1 0, 1 1, 0 0))\" .");
  const Mission b = ReadMission(
      *MissionWorld("ex:a1 a ex:PriorLayer ; ex:name \"a\" ; "
                    "geo:asWKT \"POLYGON((0 0, 1 0, 1 1, 0 0))\" ." +
                    std::string(kTestFacts))
           .store.Read());
  ASSERT_EQ(a.priors.size(), 2u);
  EXPECT_EQ(a.priors[0].iri, b.priors[0].iri);
  EXPECT_EQ(a.priors[0].iri, Ex("a1").text);
  EXPECT_EQ(a.priors[1].iri, b.priors[1].iri);
}

TEST(MissionReaderTest, PoliciesSayHowEquationOneIsDone) {
  const Policy plain = ReadWith().agents.at(0).policy;
  EXPECT_EQ(plain.front_operator, FrontOperator::kSobel);
  EXPECT_EQ(plain.layer_scale, LayerScale::kWindow);
  EXPECT_EQ(plain.soft_overlap, SoftOverlap::kProduct);
  EXPECT_FALSE(plain.paper_literal);
  EXPECT_EQ(plain.hazard_range_m, Policy().hazard_range_m);
  EXPECT_EQ(plain.isolation_weight, Policy().isolation_weight);
  const Policy said =
      ReadWith(
          "ex:safe ex:frontOperator \"central\" ; ex:layerScale \"fixed\" ; "
          "ex:softOverlap \"min\" ; ex:paperLiteral true ; "
          "ex:hazardRangeKm 4.5 ; ex:isolationWeight 0 .")
          .agents.at(0)
          .policy;
  EXPECT_EQ(said.front_operator, FrontOperator::kCentral);
  EXPECT_EQ(said.layer_scale, LayerScale::kFixed);
  EXPECT_EQ(said.soft_overlap, SoftOverlap::kMin);
  EXPECT_TRUE(said.paper_literal);
  EXPECT_DOUBLE_EQ(said.hazard_range_m, 4500.0);
  EXPECT_EQ(said.isolation_weight, 0.0);
  EXPECT_EQ(ReadWith("ex:safe ex:layerScale \"none\" .")
                .agents.at(0)
                .policy.layer_scale,
            LayerScale::kNone);
}

TEST(MissionReaderTest, AgentsSayHowTheyMoveAndWhatEnergyIsLeft) {
  const Agent plain = ReadWith().agents.at(0);
  EXPECT_EQ(plain.mobility, Mobility::kGlider);
  EXPECT_FALSE(plain.start_energy_j);
  const Agent said = ReadWith(
                         "ex:alpha ex:mobility \"hover\" . "
                         "ex:alpha_start ex:energyRemaining 20 .")
                         .agents.at(0);
  EXPECT_EQ(said.mobility, Mobility::kHover);
  EXPECT_DOUBLE_EQ(said.start_energy_j.value(), 20 * 3600.0);
}

TEST(MissionReaderTest, PoliciesPriceFieldsThatCost) {
  EXPECT_TRUE(ReadWith().agents.at(0).policy.lambda_fields.empty());
  const Policy said =
      ReadWith("ex:safe ex:lambda_waveHeight 7.2 .").agents.at(0).policy;
  EXPECT_DOUBLE_EQ(said.lambda_fields.at("wave_height"), 0.002);
}

TEST(MissionReaderTest, PoliciesPriceTheTurnFromTheStartHeading) {
  EXPECT_EQ(ReadWith().agents.at(0).policy.lambda_turn_per_rad, 0.0);
  const Agent said = ReadWith("ex:safe ex:lambda_turn 0.5 .").agents.at(0);
  EXPECT_EQ(said.policy.lambda_turn_per_rad, 0.5);
  EXPECT_DOUBLE_EQ(said.start_heading_rad, kg_base::kPi / 2.0);
}

TEST(MissionReaderTest, PoliciesSayWhichPathsAreOffered) {
  const Policy plain = ReadWith().agents.at(0).policy;
  EXPECT_FALSE(plain.hazard_budget_s);
  EXPECT_FALSE(plain.diverse_paths);
  EXPECT_EQ(plain.minimum_difference, 1);
  EXPECT_EQ(plain.churn_weight, 0.0);
  const Policy said =
      ReadWith(
          "ex:safe ex:riskBudgetHours 1.5 ; ex:pathChoice \"diverse\" ; "
          "ex:minimumDifference 3 ; ex:churnWeight 0.25 .")
          .agents.at(0)
          .policy;
  EXPECT_EQ(said.hazard_budget_s, 5400.0);
  EXPECT_TRUE(said.diverse_paths);
  EXPECT_EQ(said.minimum_difference, 3);
  EXPECT_EQ(said.churn_weight, 0.25);
}

TEST(MissionReaderTest, TheMissionSaysHowTheTeamIsChosen) {
  const CoordinationFacts plain = ReadWith().coordination;
  EXPECT_EQ(plain.mode, "greedy");
  EXPECT_EQ(plain.gap_goal, CoordinationFacts().gap_goal);
  EXPECT_EQ(plain.auction_epsilon, CoordinationFacts().auction_epsilon);
  EXPECT_EQ(plain.select_limit_s, CoordinationFacts().select_limit_s);
  EXPECT_EQ(plain.fairness, "scarcity");
  EXPECT_EQ(plain.fairness_weight, 0.0);
  const CoordinationFacts said =
      ReadWith(
          "ex:m ex:teamMode \"priced\" ; ex:gapGoal 0.002 ; "
          "ex:auctionEpsilon 0.5 ; ex:selectTimeLimitS 7 ; "
          "ex:fairness \"balance\" ; ex:fairnessWeight 1.5 .")
          .coordination;
  EXPECT_EQ(said.mode, "priced");
  EXPECT_EQ(said.gap_goal, 0.002);
  EXPECT_EQ(said.auction_epsilon, 0.5);
  EXPECT_EQ(said.select_limit_s, 7.0);
  EXPECT_EQ(said.fairness, "balance");
  EXPECT_EQ(said.fairness_weight, 1.5);
  for (const char* mode : {"auction", "exact"}) {
    EXPECT_EQ(ReadWith("ex:m ex:teamMode \"" + std::string(mode) + "\" .")
                  .coordination.mode,
              mode);
  }
}

TEST(MissionReaderTest, TheMissionSaysHowAgentsMoveAndBuffersAreMeasured) {
  EXPECT_EQ(ReadWith().coordination.movement_mode, "hops");
  EXPECT_EQ(
      ReadWith("ex:m ex:movementMode \"edges\" .").coordination.movement_mode,
      "edges");
  EXPECT_EQ(ReadWith().constraints.at(1).buffer_metric,
            BufferMetric::kEuclidean);
  EXPECT_EQ(ReadWith("ex:land ex:bufferMetric \"chebyshev\" .")
                .constraints.at(1)
                .buffer_metric,
            BufferMetric::kChebyshev);
}

// kTestFacts with one change, and the reader's error for it.
struct Refused {
  const char* what;
  const char* by;
  const char* said;
};
const Refused kRefused[] = {
    {"ex:m a ex:Mission", "ex:m a ex:Event", "exactly one ex:Mission, not 0"},
    {"ex:index 1", "ex:index 0", "ex:w1 ex:index: expected 1"},
    {"ex:durationHours 24", "rdfs:label \"x\"", "ex:w1 time:hasEnd: expected"},
    {"ex:id \"bravo\"", "ex:id \"alpha\"", "a unique id"},
    {"ex:bravo_start a ex:AgentState", "ex:bravo_start a ex:Event",
     "ex:AgentState with ex:forAgent ex:bravo"},
    {"time:hasBeginning \"2026-06-03T00",
     "time:hasEnd "
     "\"2026-06-04T00:00:00Z\"^^xsd:dateTime ; time:hasBeginning "
     "\"2026-06-01T00",
     "ex:w0 time:hasEnd: expected an end after the begin"},
    {"ex:forWindow ex:w0 ; ex:value", "ex:forWindow ex:w7 ; ex:value",
     "a window of the mission, not ex:w7"},
    {"ex:kind \"soft\"", "ex:kind \"hard\"", "one of no_go, soft, not"},
    {"POINT(-90 26)", "POINT(-90)", "ex:bravo_start geo:asWKT: expected"},
    {"ex:alpha_base 1 ;", "", "ex:safe ex:alpha_base: expected a number"},
    {"ex:m a ex:Mission", "ex:m ex:teamMode \"lottery\" ; a ex:Mission",
     "ex:m ex:teamMode: expected one of greedy, auction, priced, exact"},
    {"ex:m a ex:Mission", "ex:m ex:fairness \"none\" ; a ex:Mission",
     "ex:m ex:fairness: expected one of scarcity, balance, max_min"},
    {"ex:m a ex:Mission", "ex:m ex:gapGoal \"small\" ; a ex:Mission",
     "ex:m ex:gapGoal: expected a finite number"},
    {"ex:alpha_base 1 ;", "ex:alpha_base 1 ; ex:pathChoice \"any\" ;",
     "ex:safe ex:pathChoice: expected one of best, diverse"},
    {"ex:alpha_base 1 ;", "ex:alpha_base 1 ; ex:minimumDifference 1.5 ;",
     "ex:safe ex:minimumDifference: expected an integer"},
    {"ex:id \"alpha\"", "ex:id \"alpha\" ; ex:mobility \"balloon\"",
     "ex:alpha ex:mobility: expected one of glider, fixed_wing, hover, not"},
    {"ex:gridRef \"land\"", "ex:gridRef \"x.nc\"", "\"file#variable@step\""},
    {"ex:gridRef \"land\"", "ex:gridRef \"x.nc#m@-1\"", "a time step behind @"},
    {"geo:asWKT \"POLYGON((-90", "ex:gridRef \"x.nc#m\" ; rdfs:label \"((-90",
     "ex:corridor ex:edgeKm: expected none"},
};

TEST(MissionReaderTest, RefusesInOneLineWithSubjectAndProperty) {
  EXPECT_EQ(GetRefusal(kTestFacts), "");
  for (const Refused& refused : kRefused) {
    const std::string said =
        GetRefusal(Replace(kTestFacts, refused.what, refused.by));
    EXPECT_NE(said.find(refused.said), std::string::npos)
        << refused.by << ": " << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

TEST(MissionReaderTest, RefusesLayersThatCannotBeDerived) {
  const auto said = [](const char* what, const char* by) {
    return GetRefusal(kTestFacts + Replace(kTestArtifacts, what, by));
  };
  EXPECT_NE(said("\"delta_sst\"", "\"salt\"")
                .find("one of delta_sst, sst, frontness, not \"salt\""),
            std::string::npos);
  EXPECT_NE(said("ex:previousTimeIndex 0 ;", "")
                .find("ex:layer1 ex:previousTimeIndex: expected another step"),
            std::string::npos);
}

TEST(MissionReaderTest, RefusesWindowsThatOverlap) {
  const std::string said = GetRefusal(Replace(
      kTestFacts, "ex:index 0 ;", "ex:index 0 ; ex:durationHours 25 ;"));
  EXPECT_NE(said.find("by the next window's begin, 2026-06-03T00:00:00Z"),
            std::string::npos)
      << said;
}

TEST(MissionReaderTest, RefusesTwoWeightsForOneLayer) {
  const std::string said =
      GetRefusal(std::string(kTestFacts) +
                 "ex:safe ex:hasPriorWeight ex:a , ex:b . "
                 "ex:a a ex:PriorWeight ; ex:layer ex:corridor ; ex:beta 1 . "
                 "ex:b a ex:PriorWeight ; ex:layer ex:corridor ; ex:beta 2 .");
  EXPECT_NE(said.find("one weight for ex:corridor"), std::string::npos) << said;
}

TEST(MissionReaderTest, RefusesAGridWhoseNumbersDisagree) {
  const std::string said =
      GetRefusal(std::string(kTestFacts) +
                 Replace(kTestArtifacts, "ex:rows 25", "ex:rows 50"));
  EXPECT_NE(said.find("ex:grid ex:pixelSizeKm"), std::string::npos) << said;
}

TEST(MissionReaderTest, AGridMayHaveCellsOfAnotherShapeButNotOfAny) {
  const auto said = [](const char* cols) {
    return GetRefusal(std::string(kTestFacts) +
                      Replace(kTestArtifacts, "ex:cols 50", cols));
  };
  for (const char* cols : {"ex:cols 25", "ex:cols 45", "ex:cols 100"}) {
    EXPECT_EQ(said(cols), "") << cols;
  }
  for (const char* cols : {"ex:cols 5", "ex:cols 500"}) {
    EXPECT_NE(said(cols).find("ex:grid ex:cols: expected"), std::string::npos)
        << cols;
  }
}

// Rows of 0.1 degree, 11.13 km, far north: columns of equal degrees are narrow.
TEST(MissionReaderTest, CellsMayBeNarrowBecauseOfTheLatitude) {
  const auto said = [](const std::string& cols, const std::string& box) {
    return GetRefusal(std::string(kTestFacts) +
                      "ex:polar a ex:GridSpec ; ex:rows 20 ; ex:pixelSizeKm "
                      "11.13 ; ex:cols " +
                      cols + " ; geo:asWKT \"POLYGON((" + box + "))\" .");
  };
  for (const char* box : {"10 80, 13 80, 13 82, 10 82, 10 80",
                          "10 87.9, 13 87.9, 13 89.9, 10 89.9, 10 87.9",
                          "10 -82, 13 -82, 13 -80, 10 -80, 10 -82"}) {
    EXPECT_EQ(said("30", box), "") << box;
    EXPECT_NE(said("300", box).find("ex:polar ex:cols: expected"),
              std::string::npos)
        << box;
  }
}

TEST(MissionReaderTest, GapsBetweenWindowsAreSaid) {
  EXPECT_TRUE(WindowGaps(ReadWith()).empty());
  const Mission mission = ReadWith("ex:w0 ex:durationHours 23 .");
  EXPECT_EQ(WindowGaps(mission),
            std::vector<std::string>{"ex:w1 begins 3600 s after ex:w0 ends: "
                                     "nothing is planned in between"});
}

}  // namespace
}  // namespace kg_mission
