#include "kg_core/facts/history.h"

#include <map>
#include <random>
#include <set>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/testing/mission_world.h"

namespace kg_mission {
namespace {

using kg_core::Ex;
using kg_core::FactUpdate;
using kg_core::FindDifferences;
using kg_core::Statement;
using kg_core::ToNTriples;

using Lines = std::set<std::string>;

std::string FormatLine(const Statement& s) {
  return ToNTriples(s.subject) + " " + ToNTriples(s.predicate) + " " +
         ToNTriples(s.object);
}

// The current facts, read directly.
Lines GetFacts(const kg_core::GraphView& view) {
  Lines lines;
  view.Match({}, [&](const kg_core::Quad& q) {
    if (view.Get(q.graph) != kg_core::Facts()) return true;
    lines.insert(FormatLine({view.Get(q.subject), view.Get(q.predicate),
                             view.Get(q.object), kg_core::Facts()}));
    return true;
  });
  return lines;
}

// A random update, which may be rejected.
FactUpdate RandomUpdate(std::mt19937& random) {
  const std::string number = std::to_string(random() % 4);
  const std::string area = "ex:area" + number;
  FactUpdate update;
  update.author = random() % 2 == 0 ? "operator" : "watch \"B\"\n";
  switch (random() % 7) {
    case 0:
      update.set = {{"ex:alpha", "ex:usesPolicy",
                     random() % 2 == 0 ? "ex:safe" : "ex:fast"}};
      break;
    case 1:
      update.set = {{"ex:seep", "ex:value", "1" + number + ".50"},
                    {"ex:seep", "ex:capacity", "1" + number}};
      break;
    case 2:
      update.turtle = area +
                      " a ex:Constraint ; ex:kind \"no_go\" ; ex:appliesIn "
                      "ex:w0, ex:w1 ; geo:asWKT \"POINT(-93 " +
                      number + ")\" .";
      break;
    case 3:
      update.remove = {{area, "", ""}};
      break;
    case 4:
      update.remove = {{area, "ex:appliesIn", "ex:w0"}};
      break;
    case 5:
      update.sparql =
          "DELETE { ?s ex:value ?v } INSERT { ?s ex:value ?w } "
          "WHERE { ?s ex:value ?v BIND(?v + 1 AS ?w) }";
      break;
    default:
      update.set = {
          {"ex:safe", "ex:priors", "'{\"corridor\": 0." + number + "}'"}};
      break;
  }
  return update;
}

// The facts at a version: its differences from the empty version 0.
Lines FactsAt(const kg_core::GraphView& view, std::uint64_t version) {
  Lines lines;
  for (const kg_core::FactDifference& difference :
       FindDifferences(view, 0, version)) {
    EXPECT_TRUE(difference.is_added);
    lines.insert(FormatLine(difference.statement));
  }
  return lines;
}

TEST(History, BringsBackTheFactsOfEveryVersion) {
  std::mt19937 random(7);
  for (int round = 0; round < 5; ++round) {
    MissionWorld world;
    std::map<std::uint64_t, Lines> saved;
    saved[world.store.world_version()] = GetFacts(*world.store.Read());
    for (int i = 0; i < 40; ++i) {
      world.Commit(RandomUpdate(random));
      saved[world.store.world_version()] = GetFacts(*world.store.Read());
    }
    ASSERT_GT(saved.size(), 15u);
    const auto view = world.store.Read();
    for (const auto& [version, facts] : saved) {
      ASSERT_EQ(FactsAt(*view, version), facts) << version;
    }
    EXPECT_TRUE(FactsAt(*view, 0).empty());
    EXPECT_TRUE(FactsAt(*view, 1).empty());  // Vocabulary only.
    for (int i = 0; i < 30; ++i) {
      const auto& before = *std::next(saved.begin(), random() % saved.size());
      const auto& after = *std::next(saved.begin(), random() % saved.size());
      Lines facts = before.second;
      for (const kg_core::FactDifference& difference :
           FindDifferences(*view, before.first, after.first)) {
        const std::string line = FormatLine(difference.statement);
        ASSERT_EQ(facts.count(line), difference.is_added ? 0u : 1u) << line;
        if (difference.is_added) facts.insert(line);
        if (!difference.is_added) facts.erase(line);
        ASSERT_GT(difference.world_version,
                  std::min(before.first, after.first));
        ASSERT_LE(difference.world_version,
                  std::max(before.first, after.first));
      }
      ASSERT_EQ(facts, after.second);
    }
  }
}

TEST(History, SaysWhoAndWhen) {
  MissionWorld world;
  const std::uint64_t before = world.store.world_version();
  FactUpdate update;
  update.id = "u7";
  update.author = "operator \"A\"";
  update.set = {{"ex:alpha", "ex:usesPolicy", "ex:fast"}};
  ASSERT_TRUE(world.Commit(update).empty());
  const auto view = world.store.Read();
  const std::vector<kg_core::LoggedUpdate> log = kg_core::ReadLog(*view);
  ASSERT_EQ(log.size(), 2u);
  EXPECT_EQ(log[0].author, "test");
  EXPECT_EQ(log[1].world_version, before + 1);
  EXPECT_EQ(log[1].id, "u7");
  EXPECT_EQ(log[1].author, "operator \"A\"");
  EXPECT_EQ(log[1].time, "2026-05-28T20:26:40Z");
  ASSERT_EQ(log[1].changes.size(), 1u);
  EXPECT_EQ(log[1].changes[0].subject, Ex("alpha"));
  EXPECT_EQ(log[1].changes[0].old_values,
            std::vector<kg_core::Term>{Ex("safe")});
  EXPECT_EQ(log[1].changes[0].new_values,
            std::vector<kg_core::Term>{Ex("fast")});
  const auto differences = FindDifferences(*view, before + 1, before);
  ASSERT_EQ(differences.size(), 2u);
  EXPECT_EQ(differences[0].statement.object, Ex("fast"));
  EXPECT_FALSE(differences[0].is_added);
  EXPECT_EQ(differences[1].statement.object, Ex("safe"));
  EXPECT_TRUE(differences[1].is_added);
  EXPECT_EQ(differences[1].author, "operator \"A\"");
}

TEST(History, RefusesAVersionThatDoesNotExistYet) {
  MissionWorld world;
  const auto view = world.store.Read();
  EXPECT_THROW(FindDifferences(*view, 0, view->world_version() + 1),
               kg_base::InputError);
  EXPECT_TRUE(
      FindDifferences(*view, view->world_version(), view->world_version())
          .empty());
}

}  // namespace
}  // namespace kg_mission
