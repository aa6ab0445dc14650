#include "kg_core/rdf/store.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <thread>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/testing/store_model.h"
#include "kg_core/rdf/turtle.h"

namespace kg_core {
namespace {

using kg_base::InputError;

TEST(Store, BehavesLikeASetInMemory) {
  for (int seed = 0; seed < 10; ++seed) {
    RunAgainstModel("", RandomFacts(seed), {});
  }
}

TEST(Store, BehavesLikeASetOnDisk) {
  for (int seed = 0; seed < 3; ++seed) {
    const kg_base::TemporaryFolder folder;
    RunAgainstModel(folder / "store.db", RandomFacts(seed), {});
  }
}

TEST(Store, DoesWhatTheHeaderShows) {
  Store store("");
  Transaction change = store.Begin();
  change.Add(Fact("alpha", "usesPolicy", Ex("safe")));
  EXPECT_TRUE(Has(change.view(), kFactsGraph, Ex("alpha"), Ex("usesPolicy"),
                  Ex("safe")));
  EXPECT_EQ(store.quad_count(), 0u);
  EXPECT_EQ(change.Commit(WorldChange::kYes), 1u);
  const std::shared_ptr<const GraphView> world = store.Read();
  EXPECT_EQ(world->world_version(), 1u);
  EXPECT_EQ(FirstObject(*world, kFactsGraph, Ex("alpha"), Ex("usesPolicy")),
            Ex("safe"));
  EXPECT_EQ(Objects(*world, kFactsGraph, Ex("alpha"), Ex("usesPolicy")).size(),
            1u);
  EXPECT_EQ(Subjects(*world, kFactsGraph, Ex("usesPolicy"), Ex("safe")),
            std::vector<Term>{Ex("alpha")});
  EXPECT_FALSE(FirstObject(*world, kVocabGraph, Ex("alpha"), Ex("usesPolicy")));
  EXPECT_FALSE(FirstObject(*world, kFactsGraph, Ex("beta"), Ex("usesPolicy")));
}

TEST(Store, OnlyRealChangesOfTheWorldCount) {
  Store store("");
  const auto commit = [&](bool add, WorldChange kind) {
    Transaction change = store.Begin();
    if (add) change.Add(Fact("a", "p", IntegerLiteral(1)));
    if (!add) change.Remove(Fact("a", "p", IntegerLiteral(1)));
    return change.Commit(kind);
  };
  EXPECT_EQ(commit(false, WorldChange::kYes), 0u);
  EXPECT_EQ(commit(true, WorldChange::kNo), 0u);
  EXPECT_EQ(commit(true, WorldChange::kYes), 0u);
  EXPECT_EQ(commit(false, WorldChange::kYes), 1u);
  EXPECT_EQ(commit(true, WorldChange::kYes), 2u);
}

TEST(Store, IdsOfATransactionStayValidAfterItsCommit) {
  Store store("");
  Transaction change = store.Begin();
  change.Add(Fact("a", "p", Literal("new")));
  const TermId id = change.view().Find(Literal("new"));
  ASSERT_NE(id, kNoTerm);
  EXPECT_EQ(store.Read()->Find(Literal("new")), kNoTerm);
  const Term& term = change.view().Get(id);
  change.Commit(WorldChange::kYes);
  EXPECT_EQ(store.Read()->Find(Literal("new")), id);
  EXPECT_EQ(&store.Read()->Get(id), &term);
}

TEST(Store, ADroppedTransactionLeavesNoTrace) {
  Store store("");
  {
    Transaction change = store.Begin();
    change.Add(Fact("a", "p", Literal("never")));
  }
  EXPECT_EQ(store.quad_count(), 0u);
  EXPECT_EQ(store.Read()->Find(Literal("never")), kNoTerm);
  Transaction change = store.Begin();
  change.Add(Fact("b", "q", Literal("ever")));
  change.Commit(WorldChange::kYes);
  EXPECT_EQ(GetContent(*store.Read()),
            Model{MakeKey(Fact("b", "q", Literal("ever")))});
}

TEST(Store, AMatchMayChangeTheTransactionItLooksAt) {
  Store store("");
  Transaction change = store.Begin();
  for (int i = 0; i < 1000; ++i) {
    change.Add(Fact("a", "p", IntegerLiteral(i)));
  }
  int seen = 0;
  const GraphView& view = change.view();
  view.Match({}, [&](const Quad& q) {
    const Term object = view.Get(q.object);
    change.Remove(Fact("a", "p", object));
    change.Add(Fact("b", "q", object));
    return ++seen > 0;
  });
  EXPECT_EQ(seen, 1000);
  EXPECT_EQ(Objects(view, kFactsGraph, Ex("b"), Ex("q")).size(), 1000u);
  EXPECT_TRUE(Objects(view, kFactsGraph, Ex("a"), Ex("p")).empty());
}

TEST(Store, RefusesWhatIsNoRdf) {
  Store store("");
  Transaction change = store.Begin();
  const Term graph = Iri(kFactsGraph), p = Ex("p"), literal = Literal("x");
  EXPECT_THROW(change.Add({literal, p, p, graph}), InputError);
  EXPECT_THROW(change.Add({p, literal, p, graph}), InputError);
  EXPECT_THROW(change.Add({p, Blank("b"), p, graph}), InputError);
  EXPECT_THROW(change.Add({p, p, p, literal}), InputError);
  EXPECT_TRUE(change.empty());
}

TEST(Store, OneTransactionAtATime) {
  Store store("");
  std::optional<Transaction> first(store.Begin());
  EXPECT_THROW(store.Begin(), std::logic_error);
  std::thread other([&] {
    Transaction second = store.Begin();  // Waits for the first to end.
    EXPECT_EQ(store.quad_count(), 1u);
  });
  first->Add(Fact("a", "p", Literal("x")));
  first->Commit(WorldChange::kYes);
  EXPECT_THROW(first->Add(Fact("a", "p", Literal("y"))), std::logic_error);
  EXPECT_THROW(first->Commit(WorldChange::kYes), std::logic_error);
  other.join();
  EXPECT_NO_THROW(store.Begin());
}

TEST(Store, NoTermHasAnUnknownId) {
  Store store("");
  EXPECT_THROW(store.Read()->Get(kNoTerm), std::out_of_range);
  EXPECT_THROW(store.Read()->Get(4000000000u), std::out_of_range);
}

TEST(Store, WritesTurtleThatReadsBack) {
  RandomFacts facts(9);
  Store store("");
  Transaction change = store.Begin();
  for (int i = 0; i < 300; ++i) {
    Statement s = facts.Next();
    if (s.subject.is_blank() || s.object.is_blank()) continue;
    change.Add(s);
  }
  change.Add(
      {Ex("a"), Iri(kRdf + std::string("type")), Ex("C"), Iri(kFactsGraph)});
  change.Add(Fact("a", "p", Literal("\"\\\n\xC3\xA9")));
  change.Add(Fact("a.b/c", "p", DoubleLiteral(0.1)));
  const GraphView& view = change.view();
  const std::string text = WriteTurtle(view, kFactsGraph);
  const auto read = ParseTurtle(text, "text", Iri(kFactsGraph));
  Model expected;
  for (const Key& key : GetContent(view)) {
    if (std::get<3>(key) == Iri(kFactsGraph)) expected.insert(key);
  }
  EXPECT_EQ(AsModel(read), expected);

  Store other("");  // The same statements in a different order.
  Transaction copy = other.Begin();
  for (auto s = read.rbegin(); s != read.rend(); ++s) copy.Add(*s);
  EXPECT_EQ(WriteTurtle(copy.view(), kFactsGraph), text);
  EXPECT_NE(text.find("\nex:a a ex:C ;\n    ex:p "), std::string::npos) << text;
}

TEST(Store, WritesBlankNodesThatReadBack) {
  const Term graph = Iri(kFactsGraph);
  const auto write = [&](const std::string& text) {
    Store store("");
    Transaction change = store.Begin();
    for (const Statement& s : ParseTurtle(text, "text", graph)) change.Add(s);
    return WriteTurtle(change.view(), kFactsGraph);
  };
  const auto unlabelled = [](std::string text) {
    std::set<std::string> labels;
    for (std::size_t at = 0; (at = text.find("_:b", at)) != text.npos;) {
      const std::size_t end = text.find_first_of(" ,;.\n", at);
      labels.insert(text.substr(at, end - at));
      text.replace(at, end - at, "_:?");
      at += 3;
    }
    return text + std::to_string(labels.size());
  };
  const std::string once =
      write("ex:a ex:p [ ex:q 1 ], ( 1 2 ) . _:x ex:p _:x .");
  EXPECT_EQ(unlabelled(write(once)), unlabelled(once));
  EXPECT_NE(once.find("_:b"), std::string::npos);
}

}  // namespace
}  // namespace kg_core
