#include "kg_mission/mission/expiry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "kg_core/facts/terms.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/testing/mission_world.h"

namespace kg_mission {
namespace {

using kg_core::Ex;

constexpr double kBegin_s = 1780358400.0;  // 2026-06-02T00:00Z, ex:w0.
constexpr double kHour_s = 3600.0;

std::string Reef(const std::string& until, const std::string& more = "") {
  return "ex:reef a ex:Constraint ; ex:kind \"soft\" ; ex:attenuation 0.5 ; "
         "geo:asWKT \"POLYGON((-92 27, -91 27, -91 28, -92 27))\" ; "
         "ex:validUntil \"" +
         until + "\"^^xsd:dateTime . " + more;
}

const Constraint* Find(const Mission& mission, const char* name) {
  for (const Constraint& constraint : mission.constraints) {
    if (constraint.iri == Ex(name).text) return &constraint;
  }
  return nullptr;
}

std::vector<std::string> Removed(const ExpiredFacts& expiry) {
  std::vector<std::string> names;
  for (const kg_core::Fact& fact : expiry.update.remove) {
    names.push_back(fact.subject);
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(ExpiryTest, AppliesInWindowsThatBeginBefore) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Add(Reef("2026-06-03T00:00:01Z"))), "");
  EXPECT_EQ(Find(ReadMission(*world.store.Read()), "reef")->windows,
            (std::vector<int>{0, 1}));
  ASSERT_EQ(Joined(world.Set({"ex:reef", "ex:validUntil",
                              "\"2026-06-03T00:00:00Z\"^^xsd:dateTime"})),
            "");
  EXPECT_EQ(Find(ReadMission(*world.store.Read()), "reef")->windows,
            std::vector<int>{0});
}

TEST(ExpiryTest, AppliesNowhereRatherThanEverywhereOnceItIsOver) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Add(Reef("2026-06-02T00:00:00Z") +
                             "ex:corridor ex:validUntil "
                             "\"2026-06-01T00:00:00Z\"^^xsd:dateTime . "
                             "ex:seep ex:validUntil "
                             "\"2026-06-01T00:00:00Z\"^^xsd:dateTime .")),
            "");
  const Mission mission = ReadMission(*world.store.Read());
  EXPECT_EQ(Find(mission, "reef"), nullptr);
  EXPECT_TRUE(mission.priors.empty());
  EXPECT_TRUE(mission.events.at(0).windows.empty());
}

TEST(ExpiryTest, NamedWindowsAreLimitedToo) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Add(
                Reef("2026-06-02T12:00:00Z", "ex:reef ex:appliesIn ex:w1 ."))),
            "");
  EXPECT_EQ(Find(ReadMission(*world.store.Read()), "reef"), nullptr);
}

TEST(ExpiryTest, CoolingsEndWhenTheySay) {
  MissionWorld world;
  EXPECT_NE(Find(ReadMission(*world.store.Read()), "cool"), nullptr);
  ASSERT_EQ(Joined(world.Set({"ex:cool", "ex:expires",
                              "\"2026-06-03T00:00:00Z\"^^xsd:dateTime"})),
            "");
  EXPECT_EQ(Find(ReadMission(*world.store.Read()), "cool"), nullptr);
  const auto view = world.store.Read();
  EXPECT_EQ(Removed(FindExpired(*view, kBegin_s + 23 * kHour_s)), Names{});
  EXPECT_EQ(Removed(FindExpired(*view, kBegin_s + 24 * kHour_s)),
            Names{"ex:cool"});
}

TEST(ExpiryTest, TheNextEndIsTheEarliestAfterATime) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Add(Reef("2026-06-02T06:00:00Z"))), "");
  const auto view = world.store.Read();
  EXPECT_EQ(NextExpiry_s(*view, kBegin_s), kBegin_s + 6 * kHour_s);
  EXPECT_EQ(NextExpiry_s(*view, kBegin_s + 6 * kHour_s),
            kBegin_s + 48 * kHour_s);  // ex:cool.
  EXPECT_TRUE(std::isinf(NextExpiry_s(*view, kBegin_s + 48 * kHour_s)));
}

TEST(ExpiryTest, TakesBackEveryFactWithItsGeometry) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Add(Reef("2026-06-02T06:00:00Z"))), "");
  const ExpiredFacts expiry =
      FindExpired(*world.store.Read(), kBegin_s + 6 * kHour_s);
  EXPECT_EQ(expiry.update.author, "kg");
  EXPECT_TRUE(expiry.kept.empty());
  ASSERT_EQ(Joined(world.Commit(expiry.update)), "");
  const auto view = world.store.Read();
  EXPECT_FALSE(kg_core::FirstObject(*view, kg_core::kFactsGraph, Ex("reef"),
                                    kg_core::RdfType()));
  EXPECT_FALSE(kg_core::FirstObject(*view, kg_core::kFactsGraph,
                                    Ex("reef/geometry"), kg_core::RdfType()));
  EXPECT_EQ(Removed(FindExpired(*view, kBegin_s + 7 * kHour_s)), Names{});
}

TEST(ExpiryTest, WhatOthersReferToIsKeptAndSaid) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Add(Reef("2026-06-02T06:00:00Z",
                                  "ex:fast ex:softOverrides '{\"reef\": 0}' . "
                                  "ex:corridor ex:validUntil "
                                  "\"2026-06-01T00:00:00Z\"^^xsd:dateTime ."))),
            "");
  const ExpiredFacts expiry =
      FindExpired(*world.store.Read(), kBegin_s + 6 * kHour_s);
  EXPECT_TRUE(expiry.update.remove.empty());
  EXPECT_EQ(expiry.kept,
            (Names{"ex:corridor is kept: "
                   "<http://example.org/mission/safe/prior/corridor> ex:layer "
                   "refers to it",
                   "ex:reef is kept: "
                   "<http://example.org/mission/fast/soft_override/reef> "
                   "ex:constraint refers to it"}));
}

TEST(ExpiryTest, EventsThatExpireAfterATimeAreNotTakenBack) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Set(
                {"ex:seep", "ex:expiresAfter", "\"PT1H\"^^xsd:duration"})),
            "");
  EXPECT_EQ(Removed(FindExpired(*world.store.Read(), kBegin_s + 9 * kHour_s)),
            Names{});
}

TEST(ExpiryTest, OfTwoEndsOfAnEventTheEarlierCounts) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Add("ex:seep ex:expiresAfter \"P9D\"^^xsd:duration ; "
                             "ex:validUntil "
                             "\"2026-06-02T12:00:00Z\"^^xsd:dateTime .")),
            "");
  EXPECT_EQ(ReadMission(*world.store.Read()).events.at(0).windows,
            std::vector<int>{0});
}

}  // namespace
}  // namespace kg_mission
