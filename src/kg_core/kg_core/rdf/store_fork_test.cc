// A fork behaves like a full copy of the snapshot it started from; neither it
// nor its origin sees later changes of the other.

#include <atomic>
#include <memory>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "gtest/gtest.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_core/rdf/quad_index.h"
#include "kg_core/rdf/testing/store_model.h"

namespace kg_core {
namespace {

using Stores = std::vector<const Store*>;

std::unique_ptr<Store> FullCopy(const GraphView& view) {
  auto copy = std::make_unique<Store>("");
  Transaction change = copy->Begin();
  for (const auto& [s, p, o, g] : GetContent(view)) change.Add({s, p, o, g});
  change.Commit(WorldChange::kNo);
  return copy;
}

// A store and its expected content.
struct Branch {
  std::unique_ptr<Store> store;
  std::unique_ptr<Store> copy;  // Gets the same changes, own dictionary.
  Model model;
  std::uint64_t world_version = 0;
};

void ExpectRight(const Branch& branch) {
  const auto view = branch.store->Read();
  ASSERT_EQ(GetContent(*view), branch.model);
  ASSERT_EQ(GetContent(*branch.copy->Read()), branch.model);
  ASSERT_EQ(branch.store->quad_count(), branch.model.size());
  ASSERT_EQ(view->world_version(), branch.world_version);
}

// For all 16 patterns of a statement's terms, store and copy match the same
// multiset of quads.
void ExpectSameMatches(const Branch& branch, const Statement& s) {
  const auto matches = [&](const GraphView& view, int bits) {
    const auto id = [&](int bit, const Term& term) {
      return bits & bit ? view.Find(term) : kNoTerm;
    };
    std::multiset<Key> found;
    const Quad pattern{id(8, s.subject), id(4, s.predicate), id(2, s.object),
                       id(1, s.graph)};
    if (BoundPlaces(pattern) != bits) return found;  // An unknown term.
    view.Match(pattern, [&](const Quad& q) {
      found.emplace(view.Get(q.subject), view.Get(q.predicate),
                    view.Get(q.object), view.Get(q.graph));
      return true;
    });
    return found;
  };
  const auto forked = branch.store->Read();
  const auto copied = branch.copy->Read();
  for (int bits = 0; bits < 16; ++bits) {
    ASSERT_EQ(matches(*forked, bits), matches(*copied, bits)) << bits;
  }
}

void ChangeBoth(RandomFacts* facts, Branch* branch) {
  Transaction change = branch->store->Begin();
  Transaction same = branch->copy->Begin();
  const Model before = branch->model;
  for (int i = facts->Pick(30); i > 0; --i) {
    RandomFacts twin = *facts;
    Model twin_model = branch->model;
    ChangeAtRandom(&twin, &same, &twin_model);
    ChangeAtRandom(facts, &change, &branch->model);
  }
  ASSERT_EQ(GetContent(change.view()), branch->model);
  if (facts->Pick(4) == 0) {
    branch->model = before;
    return;
  }
  if (branch->model != before) ++branch->world_version;
  ASSERT_EQ(change.Commit(WorldChange::kYes), branch->world_version);
  same.Commit(WorldChange::kNo);
}

Branch MakeFork(const Branch& origin) {
  return {Store::Fork(origin.store->Read()), FullCopy(*origin.store->Read()),
          origin.model, origin.world_version};
}

// A tree of forks (including forks of forks), each changed at random in turn
// with terms known only to itself, its origin or its siblings; some are
// destroyed early.
void RunForks(const std::string& path, int seed) {
  RandomFacts facts(seed);
  std::vector<Branch> branches;
  branches.push_back(
      {std::make_unique<Store>(path), FullCopy(*Store("").Read()), Model{}, 0});
  std::vector<std::pair<std::shared_ptr<const GraphView>, Model>> held;
  for (int round = 0; round < 150; ++round) {
    Branch& branch = branches[facts.Pick(branches.size())];
    ASSERT_NO_FATAL_FAILURE(ChangeBoth(&facts, &branch));
    ExpectSameMatches(branch, facts.Next());
    held.emplace_back(branch.store->Read(), branch.model);
    for (const Branch& b : branches) ASSERT_NO_FATAL_FAILURE(ExpectRight(b));
    if (facts.Pick(8) == 0) branches.push_back(MakeFork(branch));
    if (branches.size() > 5) {
      branches.erase(branches.begin() + facts.Pick(branches.size()));
    }
    const auto& [view, was] = held[facts.Pick(held.size())];
    ASSERT_EQ(GetContent(*view), was);
  }
}

TEST(StoreFork, BehavesLikeAFullCopyInMemory) {
  for (int seed = 0; seed < 10; ++seed) RunForks("", seed);
}

TEST(StoreFork, BehavesLikeAFullCopyOfADurableStore) {
  for (int seed = 0; seed < 3; ++seed) {
    const kg_base::TemporaryFolder folder;
    RunForks(folder / "store.db", seed);
  }
}

void AddFact(Store* store, const std::string& name) {
  Transaction change = store->Begin();
  change.Add(Fact(name, "is", Literal(name)));
  change.Commit(WorldChange::kYes);
}

TEST(StoreFork, NewTermsAreInvisibleToTheOther) {
  Store origin("");
  AddFact(&origin, "common");
  const auto world = origin.Read();
  const std::unique_ptr<Store> fork = Store::Fork(world);
  AddFact(&origin, "first");
  AddFact(fork.get(), "second");
  AddFact(&origin, "third");
  AddFact(fork.get(), "third");  // The same term, interned separately in each.
  EXPECT_EQ(origin.Read()->Find(Ex("second")), kNoTerm);
  EXPECT_EQ(fork->Read()->Find(Ex("first")), kNoTerm);
  EXPECT_EQ(world->Find(Ex("third")), kNoTerm);
  for (const Store* store : Stores{&origin, fork.get()}) {
    const auto view = store->Read();
    EXPECT_EQ(view->Get(view->Find(Ex("third"))), Ex("third"));
    EXPECT_EQ(view->Find(Ex("common")), world->Find(Ex("common")));
    EXPECT_TRUE(
        Has(*view, kFactsGraph, Ex("third"), Ex("is"), Literal("third")));
    EXPECT_EQ(view->world_version(), 3u);
  }
  EXPECT_EQ(world->world_version(), 1u);
}

TEST(StoreFork, OutlivesItsOrigin) {
  const kg_base::TemporaryFolder folder;
  auto origin = std::make_unique<Store>(folder / "store.db");
  AddFact(origin.get(), "a");
  auto fork = Store::Fork(origin->Read());
  auto fork_of_fork = Store::Fork(fork->Read());
  const Model before = GetContent(*origin->Read());
  AddFact(origin.get(), "b");
  origin.reset();
  AddFact(fork.get(), "c");
  fork.reset();
  EXPECT_EQ(GetContent(*fork_of_fork->Read()), before);
  AddFact(fork_of_fork.get(), "d");
  EXPECT_EQ(fork_of_fork->quad_count(), 2u);
  const Store again(folder / "store.db");
  EXPECT_EQ(again.quad_count(), 2u);  // "a" and "b".
  EXPECT_EQ(again.world_version(), 2u);
}

TEST(StoreFork, WritesBesideATransactionOfItsOrigin) {
  Store origin("");
  AddFact(&origin, "a");
  Transaction change = origin.Begin();
  change.Add(Fact("b", "is", Literal("b")));
  const auto fork = Store::Fork(origin.Read());
  AddFact(fork.get(), "c");
  change.Commit(WorldChange::kYes);
  EXPECT_EQ(origin.quad_count(), 2u);
  EXPECT_EQ(fork->Read()->Find(Ex("b")), kNoTerm);
}

TEST(StoreFork, OnlyASnapshotCanBeForked) {
  Store store("");
  const Transaction change = store.Begin();
  const std::shared_ptr<const GraphView> view(&change.view(),
                                              [](const GraphView*) {});
  EXPECT_THROW(Store::Fork(view), std::invalid_argument);
  EXPECT_THROW(Store::Fork(nullptr), std::invalid_argument);
}

// Each branch commits terms, some shared with the others, while readers check
// that their snapshots are unchanged.
TEST(StoreFork, BranchesWriteAndReadAtTheSameTime) {
  Store origin("");
  for (int i = 0; i < 50; ++i) AddFact(&origin, "common" + std::to_string(i));
  const auto world = origin.Read();
  const Model before = GetContent(*world);
  std::vector<std::unique_ptr<Store>> forks;
  for (int i = 0; i < 2; ++i) forks.push_back(Store::Fork(world));
  const auto write = [](Store* store, const std::string& name) {
    for (int i = 0; i < 300; ++i) {
      AddFact(store, (i % 2 ? "shared" : name) + std::to_string(i));
    }
  };
  std::atomic<bool> done{false};
  std::atomic<int> wrong{0};
  std::vector<std::thread> readers;
  for (const Store* store : Stores{&origin, forks[0].get(), forks[1].get()}) {
    readers.emplace_back([&, store] {
      while (!done) {
        wrong += GetContent(*world) != before;
        const auto view = store->Read();
        const Model now = GetContent(*view);
        wrong += Minus(before, now) != Model{};
        for (const auto& [s, p, o, g] : now) {
          wrong += !Has(*view, kFactsGraph, s, p, o);
        }
      }
    });
  }
  std::vector<std::thread> writers;
  writers.emplace_back([&] { write(&origin, "origin"); });
  writers.emplace_back([&] { write(forks[0].get(), "left"); });
  writers.emplace_back([&] { write(forks[1].get(), "right"); });
  for (std::thread& writer : writers) writer.join();
  done = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(origin.quad_count(), 350u);
  EXPECT_EQ(origin.Read()->Find(Ex("left0")), kNoTerm);
  EXPECT_EQ(forks[0]->Read()->Find(Ex("right0")), kNoTerm);
  EXPECT_NE(forks[1]->Read()->Find(Ex("right0")), kNoTerm);
}

}  // namespace
}  // namespace kg_core
