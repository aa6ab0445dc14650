// Many readers concurrent with one writer: every reader sees only whole
// transactions, in order, and a snapshot does not change while held.

#include <atomic>
#include <thread>
#include <vector>

#include "gtest/gtest.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/store.h"

namespace kg_core {
namespace {

constexpr int kSubjects = 10;
constexpr int kReaders = 3;

Term Subject(int i) { return Iri(kEx + ("s" + std::to_string(i))); }
const Term kValue = Iri(kEx + std::string("value"));

// Every subject gets the number of the transaction as its only value.
void CommitNumber(Store* store, long long n) {
  Transaction change = store->Begin();
  for (int i = 0; i < kSubjects; ++i) {
    const Term subject = Subject(i);
    change.RemoveMatching(&subject, &kValue, nullptr, Iri(kFactsGraph));
    change.Add({subject, kValue, IntegerLiteral(n), Iri(kFactsGraph)});
  }
  if (n % 7 == 0) {  // A discarded transaction must never be visible.
    change.Add({Subject(0), kValue, Literal("never"), Iri(kFactsGraph)});
    return;
  }
  change.Commit(WorldChange::kYes);
}

// The value shared by all subjects; nullopt unless each has exactly one value,
// the same for all.
std::optional<std::string> OnlyValue(const GraphView& view) {
  std::optional<std::string> only;
  for (int i = 0; i < kSubjects; ++i) {
    const auto values = Objects(view, kFactsGraph, Subject(i), kValue);
    if (values.size() != 1) return std::nullopt;
    if (only && *only != values[0].text) return std::nullopt;
    only = values[0].text;
  }
  return only;
}

struct Tally {
  std::atomic<int> reads{0};
  std::atomic<int> torn{0};
  std::atomic<int> backwards{0};
  std::atomic<int> changed{0};
};

void ReadUntil(const Store& store, const std::atomic<bool>& done,
               Tally* tally) {
  std::uint64_t last = 0;
  auto held = store.Read();
  const auto held_value = OnlyValue(*held);
  while (!done) {
    const auto view = store.Read();
    tally->torn += !OnlyValue(*view);
    tally->backwards += view->world_version() < last;
    last = view->world_version();
    tally->changed += OnlyValue(*held) != held_value;
    ++tally->reads;
  }
}

void RunReadersBesideAWriter(const std::string& path, int transactions) {
  Store store(path);
  CommitNumber(&store, 1);
  Tally tally;
  std::atomic<bool> done{false};
  std::vector<std::thread> readers;
  for (int i = 0; i < kReaders; ++i) {
    readers.emplace_back([&] { ReadUntil(store, done, &tally); });
  }
  for (int n = 2; n <= transactions; ++n) CommitNumber(&store, n);
  while (tally.reads < 100) std::this_thread::yield();
  done = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(tally.torn, 0);
  EXPECT_EQ(tally.backwards, 0);
  EXPECT_EQ(tally.changed, 0);
  EXPECT_EQ(store.world_version(), transactions - transactions / 7u);
}

TEST(StoreConcurrency, ReadersSeeWholeTransactionsInMemory) {
  RunReadersBesideAWriter("", 3000);
}

TEST(StoreConcurrency, ReadersSeeWholeTransactionsOnDisk) {
  const kg_base::TemporaryFolder folder;
  RunReadersBesideAWriter(folder / "store.db", 300);
}

TEST(StoreConcurrency, WritersTakeTurns) {
  Store store("");
  std::vector<std::thread> writers;
  for (int writer = 0; writer < 4; ++writer) {
    writers.emplace_back([&store, writer] {
      for (int i = 0; i < 200; ++i) {
        Transaction change = store.Begin();
        change.Add(
            {Subject(writer), kValue, IntegerLiteral(i), Iri(kFactsGraph)});
        change.Commit(WorldChange::kYes);
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(store.quad_count(), 800u);
  EXPECT_EQ(store.world_version(), 800u);
}

TEST(StoreConcurrency, OneSnapshotServesManyThreads) {
  Store store("");
  CommitNumber(&store, 1);
  const auto view = store.Read();
  std::atomic<int> wrong{0};
  std::vector<std::thread> readers;
  for (int i = 0; i < kReaders; ++i) {
    readers.emplace_back([&] {
      for (int k = 0; k < 500; ++k) wrong += OnlyValue(*view) != "1";
    });
  }
  for (int n = 2; n < 500; ++n) CommitNumber(&store, n);
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace kg_core
