#include "kg_mission/mission/time_forms.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "kg_core/facts/terms.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/testing/mission_world.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

using kg_core::Ex;
using kg_core::Fact;
using kg_core::Objects;
using kg_core::RdfType;
using kg_core::Subjects;
using kg_core::Term;
using kg_core::TimeTerm;

constexpr char kStamp[] =
    "\"2026-06-02T06:00:00+06:00\"^^xsd:dateTimeStamp";  // 00:00 UTC.

Term Node(const std::string& local) { return Ex(local); }

// The time stamps reached from a window by the OWL-Time path.
std::vector<std::string> Stamps(const MissionWorld& world, const char* window,
                                const char* property) {
  const auto view = world.store.Read();
  std::vector<std::string> stamps;
  for (const Term& interval :
       Objects(*view, kg_core::kFactsGraph, Ex(window), TimeTerm("hasTime"))) {
    for (const Term& instant :
         Objects(*view, kg_core::kFactsGraph, interval, TimeTerm(property))) {
      for (const Term& stamp : Objects(*view, kg_core::kFactsGraph, instant,
                                       TimeTerm("inXSDDateTimeStamp"))) {
        stamps.push_back(stamp.text);
      }
    }
  }
  return stamps;
}

std::vector<Term> ShortForm(const MissionWorld& world, const char* window,
                            const char* property) {
  return Objects(*world.store.Read(), kg_core::kFactsGraph, Ex(window),
                 TimeTerm(property));
}

using Texts = std::vector<std::string>;

TEST(TimeFormsTest, WindowsHaveInstantsWithStamps) {
  const MissionWorld world;
  EXPECT_EQ(Stamps(world, "w1", "hasBeginning"), Texts{"2026-06-03T00:00:00Z"});
  EXPECT_EQ(Stamps(world, "w1", "hasEnd"), Texts{"2026-06-04T00:00:00Z"});
  // The window states no end.
  EXPECT_EQ(Stamps(world, "w0", "hasEnd"), Texts{});
  EXPECT_EQ(ShortForm(world, "w1", "hasBeginning").size(), 1u);
}

TEST(TimeFormsTest, InstantsFollowTheShortForm) {
  MissionWorld world;
  EXPECT_EQ(Joined(world.Set({"ex:w1", "ex:durationHours", "12"})), "");
  EXPECT_EQ(Stamps(world, "w1", "hasEnd"), Texts{"2026-06-03T12:00:00Z"});
  EXPECT_EQ(Joined(world.Set({"ex:w1", "time:hasBeginning",
                              "\"2026-06-03T01:00:00Z\"^^xsd:dateTime"})),
            "");
  EXPECT_EQ(Stamps(world, "w1", "hasBeginning"), Texts{"2026-06-03T01:00:00Z"});
  EXPECT_EQ(Stamps(world, "w1", "hasEnd"), Texts{"2026-06-03T13:00:00Z"});
}

TEST(TimeFormsTest, AnInstantInPlaceOfADateTimeIsTaken) {
  MissionWorld world(
      "ex:w a ex:TimeWindow ; ex:index 0 ; ex:confidence 1 ; "
      "time:hasBeginning [ a time:Instant ; time:inXSDDateTimeStamp " +
      std::string(kStamp) +
      " ] ; time:hasEnd ex:noon . ex:noon a time:Instant ; "
      "time:inXSDDateTimeStamp \"2026-06-02T12:00:00Z\"^^xsd:dateTimeStamp .");
  EXPECT_EQ(ShortForm(world, "w", "hasBeginning"),
            std::vector<Term>{
                kg_core::Literal("2026-06-02T06:00:00+06:00",
                                 std::string(kg_core::kXsd) + "dateTime")});
  EXPECT_EQ(Stamps(world, "w", "hasBeginning"), Texts{"2026-06-02T00:00:00Z"});
  EXPECT_EQ(Stamps(world, "w", "hasEnd"), Texts{"2026-06-02T12:00:00Z"});
  EXPECT_EQ(Subjects(*world.store.Read(), kg_core::kFactsGraph, RdfType(),
                     TimeTerm("Instant"))
                .size(),
            2u);  // Given nodes are replaced.
}

TEST(TimeFormsTest, TheLongFormAloneGivesTheShortOne) {
  MissionWorld world(
      "ex:w a ex:TimeWindow ; ex:index 0 ; ex:confidence 1 ; "
      "time:hasTime ex:span . ex:span a time:ProperInterval ; "
      "time:hasBeginning ex:dawn ; time:hasEnd ex:noon . "
      "ex:dawn a time:Instant ; time:inXSDDateTimeStamp " +
      std::string(kStamp) +
      " . ex:noon a time:Instant ; time:inXSDDateTimeStamp "
      "\"2026-06-02T12:00:00Z\"^^xsd:dateTimeStamp .");
  ASSERT_EQ(ShortForm(world, "w", "hasBeginning").size(), 1u);
  EXPECT_EQ(ShortForm(world, "w", "hasEnd")[0].text, "2026-06-02T12:00:00Z");
  EXPECT_EQ(Stamps(world, "w", "hasBeginning"), Texts{"2026-06-02T00:00:00Z"});
  EXPECT_FALSE(kg_core::FirstObject(*world.store.Read(), kg_core::kFactsGraph,
                                    Node("span"), RdfType()));
}

TEST(TimeFormsTest, ChangingAnInstantMovesTheWindow) {
  MissionWorld world;
  EXPECT_EQ(Joined(world.Set({"<http://example.org/mission/w1/time/begin>",
                              "time:inXSDDateTimeStamp",
                              "\"2026-06-03T02:00:00Z\"^^xsd:dateTimeStamp"})),
            "");
  EXPECT_EQ(ShortForm(world, "w1", "hasBeginning")[0].text,
            "2026-06-03T02:00:00Z");
  EXPECT_EQ(ReadMission(*world.store.Read()).windows[1].begin_s,
            1780358400.0 + 26 * 3600.0);
}

TEST(TimeFormsTest, AWindowTakesItsInstantsWithIt) {
  MissionWorld world(
      "ex:w a ex:TimeWindow ; ex:index 0 ; ex:confidence 1 ; "
      "time:hasBeginning \"2026-06-02T00:00:00Z\"^^xsd:dateTime ; "
      "ex:durationHours 1 .");
  ASSERT_EQ(Joined(world.Remove({"ex:w", "", ""})), "");
  const auto view = world.store.Read();
  EXPECT_TRUE(
      Subjects(*view, kg_core::kFactsGraph, RdfType(), TimeTerm("Instant"))
          .empty());
  EXPECT_TRUE(Subjects(*view, kg_core::kFactsGraph, RdfType(),
                       TimeTerm("ProperInterval"))
                  .empty());
}

TEST(TimeFormsTest, ALinkToSomethingElseIsRefusedAndHarmsNothing) {
  MissionWorld world;
  EXPECT_NE(Joined(world.Add("ex:w1 time:hasTime ex:w0 ."))
                .find("ex:w1 time:hasTime: expected at most one"),
            std::string::npos);
  EXPECT_NE(Joined(world.Set({"ex:w1", "time:hasBeginning", "ex:nothing"}))
                .find("ex:w1 time:hasBeginning: expected exactly one "
                      "xsd:dateTime"),
            std::string::npos);
}

TEST(TimeFormsTest, ATimeThatNoStampCanHoldHasNoInstant) {
  MissionWorld world;
  EXPECT_EQ(Joined(world.Set({"ex:w0", "time:hasBeginning",
                              "\"-0001-01-01T00:00:00Z\"^^xsd:dateTime"})),
            "");
  EXPECT_NE(Joined(world.Set({"ex:w1", "ex:durationHours", "1e300"})), "");
  EXPECT_EQ(Stamps(world, "w1", "hasEnd"), Texts{"2026-06-04T00:00:00Z"});
}

TEST(TimeFormsTest, AWindowWithoutABeginIsRefusedNotGivenItsOldOne) {
  MissionWorld world;
  EXPECT_NE(Joined(world.Remove({"ex:w1", "time:hasBeginning", ""}))
                .find("ex:w1 time:hasBeginning: expected exactly one"),
            std::string::npos);
}

TEST(TimeFormsTest, BothFormsAreKeptByEveryUpdateThatChangesOne) {
  MissionWorld world;
  for (int hour = 1; hour < 24; ++hour) {
    const std::string time = "2026-06-03T" + std::string(hour < 10 ? "0" : "") +
                             std::to_string(hour) + ":00:00Z";
    const bool is_long = hour % 2 == 0;
    const Fact fact = is_long
                          ? Fact{"<http://example.org/mission/w1/time/begin>",
                                 "time:inXSDDateTimeStamp",
                                 "\"" + time + "\"^^xsd:dateTimeStamp"}
                          : Fact{"ex:w1", "time:hasBeginning",
                                 "\"" + time + "\"^^xsd:dateTime"};
    ASSERT_EQ(Joined(world.Set(fact)), "") << time;
    EXPECT_EQ(Stamps(world, "w1", "hasBeginning"), Texts{time});
    ASSERT_EQ(ShortForm(world, "w1", "hasBeginning").size(), 1u);
    EXPECT_EQ(ShortForm(world, "w1", "hasBeginning")[0].text, time);
    EXPECT_TRUE(Validate(*world.store.Read()).empty());
  }
}

}  // namespace
}  // namespace kg_mission
