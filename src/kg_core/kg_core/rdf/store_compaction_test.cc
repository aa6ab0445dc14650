// Terms that no quad uses are removed from memory and record while the store is
// open, without any other visible effect.

#include <set>

#include "gtest/gtest.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_core/rdf/sqlite.h"
#include "kg_core/rdf/testing/store_model.h"

namespace kg_core {
namespace {

using kg_base::TemporaryFolder;

constexpr StoreOptions kOften{/*compact_after=*/1};

TEST(StoreCompaction, BehavesLikeASetInMemory) {
  for (int seed = 0; seed < 20; ++seed) {
    RunAgainstModel("", RandomFacts(seed, 1 + seed), kOften);
  }
}

TEST(StoreCompaction, BehavesLikeASetOnDisk) {
  for (int seed = 0; seed < 4; ++seed) {
    const TemporaryFolder folder;
    RunAgainstModel(folder / "store.db", RandomFacts(seed, 10 * seed + 1),
                    kOften);
  }
}

constexpr int kPlanQuads = 100;

// Writes the plan of a run and drops the previous one: 201 new terms.
void Replan(Store* store, int run) {
  Transaction change = store->Begin();
  const auto graph = [](int n) { return Ex("plan/" + std::to_string(n)); };
  change.RemoveMatching(nullptr, nullptr, nullptr, graph(run - 1));
  for (int i = 0; i < kPlanQuads; ++i) {
    const std::string name = std::to_string(run) + "/" + std::to_string(i);
    change.Add({Ex("node" + name), Ex("cost"), Literal("cost of " + name),
                graph(run)});
  }
  change.Commit(WorldChange::kNo);
}

TermId FindLargestId(const GraphView& view) {
  TermId largest = 0;
  view.Match({}, [&](const Quad& q) {
    largest = std::max({largest, q.subject, q.object, q.graph});
    return true;
  });
  return largest;
}

// After 1,000 rounds, memory and record are bounded by the size of a few plans.
void ExpectBounded(const Store& store) {
  EXPECT_EQ(store.quad_count(), kPlanQuads + 1u);
  EXPECT_LE(store.term_count(), 6 * kPlanQuads + 10u);
  EXPECT_LE(FindLargestId(*store.Read()), 12 * kPlanQuads);
}

TEST(StoreCompaction, AThousandPlansLeaveTheTermsOfOneInMemory) {
  Store store("", {/*compact_after=*/kPlanQuads});
  Transaction first = store.Begin();
  first.Add(Fact("always", "is", Literal("there")));
  first.Commit(WorldChange::kYes);
  const auto early = store.Read();
  const TermId always = early->Find(Ex("always"));
  std::vector<std::pair<std::shared_ptr<const GraphView>, Model>> held;
  for (int run = 1; run <= 1000; ++run) {
    Replan(&store, run);
    if (run % 100 == 0) {
      held.emplace_back(store.Read(), GetContent(*store.Read()));
    }
  }
  ExpectBounded(store);
  EXPECT_EQ(store.Read()->Find(Ex("node1/0")), kNoTerm);
  EXPECT_EQ(store.Read()->Find(Ex("always")), always);
  EXPECT_EQ(GetContent(*early).size(), 1u);
  for (const auto& [view, was] : held) EXPECT_EQ(GetContent(*view), was);
}

std::int64_t CollectRows(const std::string& path) {
  SqliteDatabase database(path, false);
  SqliteQuery count = database.Prepare("SELECT count(*) FROM term");
  count.Step();
  return count.Integer(0);
}

TEST(StoreCompaction, AThousandPlansLeaveTheTermsOfAFewOnDisk) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  Model content;
  {
    Store store(path, {/*compact_after=*/kPlanQuads});
    Transaction first = store.Begin();
    first.Add(Fact("always", "is", Literal("there")));
    first.Commit(WorldChange::kYes);
    for (int run = 1; run <= 1000; ++run) Replan(&store, run);
    ExpectBounded(store);
    content = GetContent(*store.Read());
  }
  EXPECT_LE(CollectRows(path), 8 * kPlanQuads);
  Store again(path);
  EXPECT_EQ(GetContent(*again.Read()), content);
  ExpectBounded(again);
  for (int run = 1001; run <= 1010; ++run) Replan(&again, run);
  EXPECT_EQ(again.quad_count(), kPlanQuads + 1u);
}

// Rows of terms that were already unused when the store was opened are removed
// by small commits.
TEST(StoreCompaction, RowsLeaveWithLaterCommitsAlsoAfterReopening) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  {
    Store store(path);
    Replan(&store, 1);
    Replan(&store, 2);
  }
  EXPECT_GT(CollectRows(path), 4 * kPlanQuads);
  {
    Store store(path);
    for (int i = 0; i < 12; ++i) {
      Transaction change = store.Begin();
      change.Add(Fact("a", "b", IntegerLiteral(i)));
      change.Commit(WorldChange::kYes);
    }
  }
  EXPECT_EQ(CollectRows(path), 2 * kPlanQuads + 2 + 12 + 3);
  EXPECT_EQ(Store(path).quad_count(), kPlanQuads + 12u);
}

TEST(StoreCompaction, AForkKeepsTheTermsItBeganWith) {
  Store store("", kOften);
  Replan(&store, 1);
  const auto fork = Store::Fork(store.Read());
  const Model before = GetContent(*fork->Read());
  for (int run = 2; run < 20; ++run) Replan(&store, run);
  EXPECT_EQ(GetContent(*fork->Read()), before);
  Replan(fork.get(), 2);
  const auto fork_of_fork = Store::Fork(fork->Read());
  for (int run = 3; run < 20; ++run) Replan(fork_of_fork.get(), run);
  EXPECT_EQ(GetContent(*fork_of_fork->Read()), GetContent(*store.Read()));
}

TEST(StoreCompaction, AForkOfACompactedStoreDoesNotMixTerms) {
  Store store("", kOften);
  for (int run = 1; run < 10; ++run) Replan(&store, run);
  const auto world = store.Read();
  const auto fork = Store::Fork(world);
  Replan(&store, 10);  // Reuses freed ids, which must not affect the fork.
  Replan(fork.get(), 10);
  EXPECT_EQ(GetContent(*fork->Read()), GetContent(*store.Read()));
  EXPECT_EQ(world->Find(Ex("node10/0")), kNoTerm);
}

}  // namespace
}  // namespace kg_core
