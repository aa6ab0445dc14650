#include "kg_core/watch/watch_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/same_state.h"
#include "kg_core/rdf/store.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/watch/watch_facts.h"

namespace kg_core {
namespace {

using kg_base::InputError;

using testing::HasSubstr;

constexpr char kSpeeds[] = "SELECT ?a ?v { ?a ex:speed ?v }";

class WatchListTest : public testing::Test {
 protected:
  void Add(const std::string& turtle) {
    Transaction change = store_.Begin();
    for (const Statement& s : ParseTurtle(turtle, "test", Iri(kFactsGraph))) {
      change.Add(s);
    }
    change.Commit(WorldChange::kYes);
  }
  void Remove(const std::string& turtle) {
    Transaction change = store_.Begin();
    for (const Statement& s : ParseTurtle(turtle, "test", Iri(kFactsGraph))) {
      change.Remove(s);
    }
    change.Commit(WorldChange::kYes);
  }
  WatchedAnswer Watch(const std::string& id, const std::string& query) {
    return watches_.Watch({id, query}, *store_.Read(), dataset_);
  }
  std::optional<WatchedAnswer> Look(const std::string& id) {
    return watches_.Look(id, *store_.Read(), dataset_);
  }

  Store store_{""};
  const Dataset dataset_ = DefaultDataset(std::nullopt);
  WatchList watches_;
};

TEST_F(WatchListTest, ReportsWhatCameAndWhatWent) {
  Add("ex:a ex:speed 1 . ex:b ex:speed 2 .");
  const WatchedAnswer first = Watch("speeds", kSpeeds);
  EXPECT_TRUE(first.is_first);
  EXPECT_EQ(first.added.size(), 2u);
  EXPECT_EQ(first.answer.rows.size(), 2u);
  EXPECT_FALSE(Look("speeds"));

  Remove("ex:a ex:speed 1 .");
  Add("ex:a ex:speed 3 .");
  const auto news = Look("speeds");
  ASSERT_TRUE(news);
  EXPECT_FALSE(news->is_first);
  EXPECT_EQ(news->id, "speeds");
  EXPECT_EQ(news->world_version, store_.world_version());
  ASSERT_EQ(news->added.size(), 1u);
  EXPECT_EQ(news->added[0][1]->text, "3");
  ASSERT_EQ(news->removed.size(), 1u);
  EXPECT_EQ(news->removed[0][1]->text, "1");
  EXPECT_FALSE(Look("speeds"));
}

TEST_F(WatchListTest, IgnoresChangesThatCancelOrAreUnrelated) {
  Watch("speeds", kSpeeds);
  Add("ex:a ex:speed 1 .");
  Remove("ex:a ex:speed 1 .");
  EXPECT_FALSE(Look("speeds"));
  Add("ex:a ex:mass 1 .");
  EXPECT_FALSE(Look("speeds"));
}

TEST_F(WatchListTest, CountsRowsButNotTheirOrder) {
  Add("ex:a ex:speed 1 . ex:b ex:speed 1 .");
  Watch("values", "SELECT ?v { ?a ex:speed ?v }");
  Add("ex:c ex:speed 1 .");
  const auto news = Look("values");
  ASSERT_TRUE(news);
  EXPECT_EQ(news->added.size(), 1u);  // A third row equal to the other two.
  EXPECT_TRUE(news->removed.empty());

  Watch("sorted",
        "SELECT ?a { ?a ex:speed [] OPTIONAL { ?a ex:rank ?r } } "
        "ORDER BY ?r ?a");
  Add("ex:a ex:rank 9 .");
  EXPECT_FALSE(Look("sorted"));
}

// Applying all reports gives the current answer, even if states were skipped.
TEST_F(WatchListTest, TheSumOfTheReportsIsTheAnswer) {
  std::mt19937 random(7);
  const auto pick = [&random](int n) {
    return std::to_string(std::uniform_int_distribution<int>(1, n)(random));
  };
  const char* const queries[] = {
      kSpeeds, "SELECT ?v { ?a ex:speed ?v }",
      "SELECT ?v (COUNT(?a) AS ?n) { ?a ex:speed ?v } GROUP BY ?v",
      "SELECT ?a ?b { ?a ex:speed ?v OPTIONAL { ?b ex:speed ?v "
      "FILTER(?a != ?b) } }"};
  std::vector<Rows> held;
  for (std::size_t i = 0; i < std::size(queries); ++i) {
    held.push_back(Watch("q" + std::to_string(i), queries[i]).added);
  }
  int reports = 0;
  for (int step = 0; step < 300; ++step) {
    const std::string fact = "ex:a" + pick(6) + " ex:speed " + pick(3) + " .";
    if (pick(2) == "1") {
      Add(fact);
    } else {
      Remove(fact);
    }
    for (std::size_t i = 0; i < std::size(queries); ++i) {
      if (pick(3) != "1") continue;  // Not evaluated in this step.
      const auto news = Look("q" + std::to_string(i));
      if (news) {
        ++reports;
        EXPECT_FALSE(news->added.empty() && news->removed.empty());
        for (const auto& row : news->removed) {
          const auto at = std::find(held[i].begin(), held[i].end(), row);
          ASSERT_NE(at, held[i].end());
          held[i].erase(at);
        }
        held[i].insert(held[i].end(), news->added.begin(), news->added.end());
      }
      Rows now = RunQuery(*store_.Read(), queries[i], dataset_, {}).rows;
      std::sort(now.begin(), now.end());
      std::sort(held[i].begin(), held[i].end());
      ASSERT_EQ(held[i], now) << queries[i];
    }
  }
  EXPECT_GT(reports, 100);
}

TEST_F(WatchListTest, ReportsAFailureOnceAndWhenItIsOver) {
  WatchLimits limits;
  limits.query.rows = 2;
  WatchList watches(limits);
  const auto look = [&] {
    return watches.Look("speeds", *store_.Read(), dataset_);
  };
  Add("ex:a ex:speed 1 .");
  watches.Watch({"speeds", kSpeeds}, *store_.Read(), dataset_);
  Add("ex:b ex:speed 1 . ex:c ex:speed 1 .");
  const auto failed = look();
  ASSERT_TRUE(failed);
  EXPECT_THAT(failed->error, HasSubstr("more rows than the limit of 2"));
  EXPECT_EQ(failed->answer.rows.size(), 1u);
  EXPECT_TRUE(failed->added.empty());
  EXPECT_FALSE(look());
  Remove("ex:c ex:speed 1 .");
  const auto well = look();
  ASSERT_TRUE(well);
  EXPECT_EQ(well->error, "");
  EXPECT_EQ(well->added.size(), 1u);
  EXPECT_TRUE(well->removed.empty());
}

TEST_F(WatchListTest, RefusesWhatCannotBeWatched) {
  EXPECT_THROW(Watch("x", "ASK { ?a ?b ?c }"), InputError);
  EXPECT_THROW(Watch("x", "SELECT ?a"), InputError);
  EXPECT_THROW(Watch("no spaces", kSpeeds), InputError);
  EXPECT_THROW(Watch(std::string(65, 'x'), kSpeeds), InputError);
  EXPECT_THROW(Watch("x", std::string(20000, ' ') + kSpeeds), InputError);
  EXPECT_TRUE(watches_.ids().empty());
  for (int i = 0; i < 64; ++i) Watch("", kSpeeds);
  EXPECT_THROW(Watch("", kSpeeds), InputError);
  EXPECT_NO_THROW(Watch("watch7", kSpeeds));
  EXPECT_TRUE(watches_.Cancel("watch7"));
  EXPECT_FALSE(watches_.Cancel("watch7"));
  EXPECT_EQ(Watch("", kSpeeds).id, "watch7");
}

TEST_F(WatchListTest, GivesASecondClientTheLastAnswer) {
  Watch("speeds", kSpeeds);
  Add("ex:a ex:speed 1 .");
  const WatchedAnswer again = Watch("speeds", kSpeeds);
  EXPECT_EQ(again.answer.rows.size(), 0u);
  EXPECT_FALSE(again.is_first);
  const auto news = Look("speeds");  // Both watches report it.
  ASSERT_TRUE(news);
  EXPECT_EQ(news->added.size(), 1u);
  const WatchedAnswer other = Watch("speeds", "SELECT ?v { ?a ex:speed ?v }");
  EXPECT_TRUE(other.is_first);
  EXPECT_EQ(other.answer.rows.size(), 1u);
}

TEST_F(WatchListTest, OutlivesAProcessAsFacts) {
  Watch("speeds", kSpeeds);
  Watch("b-2", "SELECT * { ?a ex:text \"\"\"x\ny\"\"\" }");
  {
    Transaction change = store_.Begin();
    StageWatches(watches_.definitions(), change);
    change.Commit(WorldChange::kNo);
  }
  const std::vector<WatchDefinition> kept = ReadWatches(*store_.Read());
  EXPECT_EQ(kept, watches_.definitions());
  WatchList later;
  for (const WatchDefinition& watch : kept) later.Keep(watch);
  Add("ex:a ex:speed 1 .");
  const auto first = later.Look("speeds", *store_.Read(), dataset_);
  ASSERT_TRUE(first);
  EXPECT_TRUE(first->is_first);
  EXPECT_EQ(first->added.size(), 1u);
  EXPECT_TRUE(
      // Empty, but the first answer.
      later.Look("b-2", *store_.Read(), dataset_));
  EXPECT_FALSE(later.Look("b-2", *store_.Read(), dataset_));
}

TEST_F(WatchListTest, KnowsWhetherASnapshotIsOld) {
  const auto view = store_.Read();
  EXPECT_TRUE(IsSameState(*view, *store_.Read()));
  Transaction change = store_.Begin();
  change.Add({Iri("ex:a"), Iri("ex:b"), Iri("ex:c"), Iri(kStateGraph)});
  EXPECT_TRUE(IsSameState(*view, *store_.Read()));
  change.Commit(WorldChange::kNo);
  EXPECT_FALSE(IsSameState(*view, *store_.Read()));
  EXPECT_TRUE(IsSameState(*store_.Read(), *store_.Read()));
}

}  // namespace
}  // namespace kg_core
