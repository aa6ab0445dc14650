// Guarantees of the record: an acknowledged transaction survives a SIGKILL,
// whole and in order; a damaged, foreign or locked file is rejected or falls
// back to an earlier state, without spurious facts; a full disk fails the
// transaction and keeps the state.

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <set>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/sqlite.h"
#include "kg_core/rdf/store.h"

namespace kg_core {
namespace {

using kg_base::TemporaryFolder;

namespace fs = std::filesystem;

// Transaction n leaves the facts of n, n - 1, ... n - kKept + 1 and a marker:
// any other set of facts is a partial, lost or spurious transaction.
constexpr std::uint64_t kKept = 40;
constexpr int kParts = 5;

Statement Part(std::uint64_t n, int part) {
  const std::string name = "part " + std::to_string(part);
  return {Iri(kEx + ("t" + std::to_string(n))), Iri(kEx + std::string("has")),
          Literal(name + " of " + std::to_string(n)), Iri(kFactsGraph)};
}

Statement Marker(std::uint64_t n) {
  return {Iri(kEx + std::string("marker")), Iri(kEx + std::string("is")),
          IntegerLiteral(static_cast<long long>(n)), Iri(kVocabGraph)};
}

std::uint64_t CommitNext(Store* store) {
  const std::uint64_t n = store->world_version() + 1;
  Transaction change = store->Begin();
  change.Remove(Marker(n - 1));
  change.Add(Marker(n));
  for (int part = 0; part < kParts; ++part) {
    if (n > kKept) change.Remove(Part(n - kKept, part));
    change.Add(Part(n, part));
  }
  return change.Commit(WorldChange::kYes);
}

std::string FormatLine(const Term& s, const Term& p, const Term& o,
                       const Term& g) {
  return ToNTriples(s) + ToNTriples(p) + ToNTriples(o) + ToNTriples(g);
}
std::string FormatLine(const Statement& s) {
  return FormatLine(s.subject, s.predicate, s.object, s.graph);
}

std::set<std::string> GetContent(const GraphView& view) {
  std::set<std::string> lines;
  view.Match({}, [&](const Quad& q) {
    lines.insert(FormatLine(view.Get(q.subject), view.Get(q.predicate),
                            view.Get(q.object), view.Get(q.graph)));
    return true;
  });
  return lines;
}

std::set<std::string> ContentAfter(std::uint64_t n) {
  std::set<std::string> lines;
  if (n > 0) lines.insert(FormatLine(Marker(n)));
  for (std::uint64_t i = n > kKept ? n - kKept + 1 : 1; i <= n; ++i) {
    for (int part = 0; part < kParts; ++part) {
      lines.insert(FormatLine(Part(i, part)));
    }
  }
  return lines;
}

// True if the content is exactly that of the store's world version.
bool IsWhole(const Store& store) {
  return GetContent(*store.Read()) == ContentAfter(store.world_version());
}

std::string GetError(const std::string& path) {
  try {
    Store store(path);
  } catch (const kg_base::InputError& error) {
    return error.what();
  }
  return "opened";
}

void WriteFile(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

std::string Bytes(const std::string& path) {
  return kg_base::ReadFile(path, 1u << 30);
}

int EnvironmentNumber(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoi(text);
}

// Runs `work` in a child process, which exits with its result.
template <typename Work>
pid_t Fork(const Work& work) {
  const pid_t child = fork();
  if (child != 0) return child;
  int result = 99;
  try {
    result = work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "child: %s\n", error.what());
  }
  _exit(result);
}

int GetExitCode(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Commits in an endless loop and writes each acknowledged version to the pipe.
// The dictionary is compacted as often as possible.
int CommitAndAcknowledge(const std::string& path, int pipe_end) {
  Store store(path, {/*compact_after=*/1});
  while (true) {
    const std::uint64_t version = CommitNext(&store);
    if (write(pipe_end, &version, sizeof(version)) != sizeof(version)) return 1;
  }
}

// Kills a committing child at a random moment; returns the last version it
// acknowledged, or 0.
std::uint64_t CommitUntilKilled(const std::string& path,
                                std::mt19937_64* random) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = Fork([&] { return CommitAndAcknowledge(path, ends[1]); });
  close(ends[1]);
  std::uint64_t version = 0;
  std::uint64_t wanted = (*random)() % 30;
  while (wanted > 0 && read(ends[0], &version, sizeof(version)) > 0) --wanted;
  for (volatile std::uint64_t spin = (*random)() % 3000000; spin > 0;) {
    spin = spin - 1;
  }
  kill(child, SIGKILL);
  while (read(ends[0], &version, sizeof(version)) > 0) {
  }
  close(ends[0]);
  EXPECT_EQ(GetExitCode(child), -1);  // Killed, not exited normally.
  return version;
}

TEST(StoreDurability, KeepsEveryAcknowledgedTransactionThroughSigkill) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  const int rounds = EnvironmentNumber("KG_CRASH_ROUNDS", 25);
  std::mt19937_64 random(17);
  std::uint64_t before = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::uint64_t acknowledged = CommitUntilKilled(path, &random);
    const Store store(path);
    const std::uint64_t version = store.world_version();
    ASSERT_GE(version, std::max(before, acknowledged))
        << "lost, round " << round;
    if (acknowledged > 0) {
      ASSERT_LE(version, acknowledged + 1);
    }
    ASSERT_TRUE(IsWhole(store)) << "round " << round;
    before = version;
  }
  EXPECT_GT(before, static_cast<std::uint64_t>(rounds));
}

// Creates a store of a few pages and closes it.
std::string MakeStore(const std::string& path, int transactions) {
  Store store(path);
  for (int i = 0; i < transactions; ++i) CommitNext(&store);
  return path;
}

TEST(StoreDurability, RefusesEveryTruncation) {
  const TemporaryFolder folder;
  const std::string good = Bytes(MakeStore(folder / "store.db", 60));
  const std::string path = folder / "cut.db";
  for (std::size_t size = 0; size < good.size(); size += 67) {
    WriteFile(path, good.substr(0, size));
    const std::string error = GetError(path);
    ASSERT_EQ(error.rfind(path, 0), 0u) << size << ": " << error;
  }
}

TEST(StoreDurability, RefusesAFlippedBitOrIsUnharmedByIt) {
  const TemporaryFolder folder;
  const std::string good = Bytes(MakeStore(folder / "store.db", 60));
  const std::string path = folder / "flipped.db";
  const int flips = EnvironmentNumber("KG_FLIP_ROUNDS", 1000);
  std::mt19937_64 random(5);
  int refused = 0;
  for (int i = 0; i < flips; ++i) {
    std::string bytes = good;
    const std::size_t at = random() % bytes.size();
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
    WriteFile(path, bytes);
    try {
      const Store store(path);
      ASSERT_EQ(store.world_version(), 60u) << "byte " << at;
      ASSERT_TRUE(IsWhole(store)) << "byte " << at;
    } catch (const kg_base::InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, flips / 4);
  RecordProperty("refused", refused);
}

// The files of a store as a power failure would leave them: the log is not yet
// checkpointed.
struct Torn {
  std::string file, log;
};

Torn MakeTorn(const TemporaryFolder& folder, int transactions) {
  const std::string path = MakeStore(folder / "torn.db", 5);
  Store store(path);
  for (int i = 5; i < transactions; ++i) CommitNext(&store);
  return {Bytes(path), Bytes(path + "-wal")};
}

TEST(StoreDurability, ATornLogLeavesAnEarlierWholeState) {
  const TemporaryFolder folder;
  const Torn torn = MakeTorn(folder, 30);
  const std::string path = folder / "copy.db";
  std::set<std::uint64_t> versions;
  for (std::size_t size = 0; size <= torn.log.size(); size += 501) {
    WriteFile(path, torn.file);
    WriteFile(path + "-wal", torn.log.substr(0, size));
    const Store store(path);
    ASSERT_TRUE(IsWhole(store)) << size;
    versions.insert(store.world_version());
  }
  EXPECT_EQ(*versions.begin(), 5u);
  EXPECT_GE(*versions.rbegin(), 29u);
  EXPECT_GT(versions.size(), 20u);
}

TEST(StoreDurability, AFlippedLogLeavesAnEarlierWholeState) {
  const TemporaryFolder folder;
  const Torn torn = MakeTorn(folder, 30);
  const std::string path = folder / "copy.db";
  std::mt19937_64 random(6);
  for (int i = 0; i < 300; ++i) {
    std::string log = torn.log;
    const std::size_t at = random() % log.size();
    log[at] = static_cast<char>(log[at] ^ (1 << random() % 8));
    WriteFile(path, torn.file);
    WriteFile(path + "-wal", log);
    const Store store(path);
    ASSERT_TRUE(IsWhole(store)) << at;
    ASSERT_GE(store.world_version(), 5u);
    ASSERT_LE(store.world_version(), 30u);
  }
}

TEST(StoreDurability, RefusesFilesOfOthersAndLeavesThemAlone) {
  const TemporaryFolder folder;
  SqliteDatabase(folder / "sqlite.db", true).Execute("CREATE TABLE t (x)");
  const std::string other = Bytes(folder / "sqlite.db");
  std::string future = Bytes(MakeStore(folder / "store.db", 1));
  future[63] = 2;  // The schema version in SQLite's header.
  for (const std::string& bytes : {std::string(), std::string("not a database"),
                                   std::string(5000, 'x'), other, future}) {
    WriteFile(folder / "other.db", bytes);
    const std::string error = GetError(folder / "other.db");
    EXPECT_EQ(error.rfind(folder / "other.db", 0), 0u) << error;
    EXPECT_EQ(Bytes(folder / "other.db"), bytes);
  }
  EXPECT_NE(GetError(folder / "").find("not a store"), std::string::npos);
  EXPECT_NE(GetError(folder / "no/such/folder.db").find("cannot be created"),
            std::string::npos);
}

TEST(StoreDurability, RefusesALogWithoutItsFile) {
  const TemporaryFolder folder;
  WriteFile(folder / "gone.db-wal", MakeTorn(folder, 9).log);
  EXPECT_NE(GetError(folder / "gone.db").find("the file is missing"),
            std::string::npos);
}

TEST(StoreDurability, RefusesASecondOpener) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  std::optional<Store> first(path);
  CommitNext(&*first);
  EXPECT_EQ(GetError(path), path + ": is in use by another process");
  const pid_t child = Fork([&] {
    return GetError(path) == path + ": is in use by another process" ? 0 : 1;
  });
  EXPECT_EQ(GetExitCode(child), 0);
  CommitNext(&*first);
  first.reset();
  const Store again(path);
  EXPECT_EQ(again.world_version(), 2u);
  EXPECT_TRUE(IsWhole(again));
}

void LimitFileSize(rlim_t bytes) {
  rlimit limit;
  getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = std::min(bytes, limit.rlim_max);
  setrlimit(RLIMIT_FSIZE, &limit);
}

// Commits until the disk is full; the old state must then be intact, and the
// store must work again once there is space. Returns 0, or the number of the
// failed step.
int FillTheDisk(const std::string& path) {
  signal(SIGXFSZ, SIG_IGN);
  Store store(path);
  LimitFileSize(300000);
  try {
    while (CommitNext(&store) < 100000) {
    }
    return 1;
  } catch (const std::runtime_error&) {
  }
  const std::uint64_t version = store.world_version();
  if (version < 10 || !IsWhole(store)) return 2;
  try {
    CommitNext(&store);
    return 3;
  } catch (const std::runtime_error&) {
  }
  if (store.world_version() != version || !IsWhole(store)) return 4;
  LimitFileSize(RLIM_INFINITY);
  if (CommitNext(&store) != version + 1 || !IsWhole(store)) return 5;
  return 0;
}

TEST(StoreDurability, AFullDiskIsAnErrorWithoutChanges) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  EXPECT_EQ(GetExitCode(Fork([&] { return FillTheDisk(path); })), 0);
  const Store store(path);
  EXPECT_TRUE(IsWhole(store));
  EXPECT_GT(store.world_version(), 10u);
}

TEST(StoreDurability, ARefusedCommitMayBeTriedAgain) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  const pid_t child = Fork([&] {
    signal(SIGXFSZ, SIG_IGN);
    Store store(path);
    Transaction change = store.Begin();
    for (int i = 0; i < 20000; ++i) change.Add(Part(1, i));
    LimitFileSize(200000);
    try {
      change.Commit(WorldChange::kYes);
      return 1;
    } catch (const std::runtime_error&) {
    }
    LimitFileSize(RLIM_INFINITY);
    return change.Commit(WorldChange::kYes) == 1 ? 0 : 2;
  });
  EXPECT_EQ(GetExitCode(child), 0);
  EXPECT_EQ(Store(path).quad_count(), 20000u);
}

// A failed commit has not removed rows of unused terms either: the next commit
// removes them, and their ids are not reused before.
int FillTheDiskWithForgottenTerms(const std::string& path) {
  signal(SIGXFSZ, SIG_IGN);
  Store store(path, {/*compact_after=*/1});
  for (int i = 0; i < 300; ++i) CommitNext(&store);
  for (int round = 0; round < 5; ++round) {
    const std::uint64_t version = store.world_version();
    LimitFileSize(4096);
    try {
      CommitNext(&store);
      return 1;
    } catch (const std::runtime_error&) {
    }
    LimitFileSize(RLIM_INFINITY);
    if (store.world_version() != version || !IsWhole(store)) return 2;
    for (int i = 0; i < 30; ++i) CommitNext(&store);
    if (!IsWhole(store)) return 3;
  }
  return 0;
}

TEST(StoreDurability, AFullDiskLosesNoRowsOfRemovedTerms) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  const auto work = [&] { return FillTheDiskWithForgottenTerms(path); };
  EXPECT_EQ(GetExitCode(Fork(work)), 0);
  const Store store(path);  // Opening checks the digest.
  EXPECT_TRUE(IsWhole(store));
  EXPECT_EQ(store.world_version(), 450u);
}

TEST(StoreDurability, ADiskTooFullForAStoreIsNamed) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  const pid_t child = Fork([&] {
    signal(SIGXFSZ, SIG_IGN);
    LimitFileSize(1000);
    return GetError(path).rfind(path + ": cannot be created", 0) == 0 ? 0 : 1;
  });
  EXPECT_EQ(GetExitCode(child), 0);
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(IsWhole(Store(path)));
}

TEST(StoreDurability, RemovesUnusedTerms) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  MakeStore(path, 500);  // Leaves 200 facts of 2500.
  for (int opening = 0; opening < 3; ++opening) {
    const Store store(path);
    EXPECT_TRUE(IsWhole(store));
    EXPECT_EQ(store.world_version(), 500u);
    EXPECT_EQ(store.Read()->Find(Part(1, 0).object), kNoTerm);
    EXPECT_NE(store.Read()->Find(Part(500, 0).object), kNoTerm);
  }
  Store store(path);
  CommitNext(&store);
  EXPECT_TRUE(IsWhole(store));
}

TEST(StoreDurability, KeepsBytesOfTermsExactly) {
  const TemporaryFolder folder;
  const std::string path = folder / "store.db";
  const std::string odd("a\0b\xC3\xA9\n'", 8);
  const Statement s{Blank("x.1"), Iri("http://h/?q='#"),
                    LanguageLiteral(odd, "en-gb"), Iri(kFactsGraph)};
  {
    Store store(path);
    Transaction change = store.Begin();
    change.Add(s);
    change.Add({s.subject, s.predicate, Literal(""), s.graph});
    change.Commit(WorldChange::kNo);
  }
  const Store store(path);
  EXPECT_TRUE(
      Has(*store.Read(), kFactsGraph, s.subject, s.predicate, s.object));
  EXPECT_TRUE(
      Has(*store.Read(), kFactsGraph, s.subject, s.predicate, Literal("")));
  EXPECT_EQ(store.world_version(), 0u);
}

}  // namespace
}  // namespace kg_core
