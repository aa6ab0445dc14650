// GRAPH ?g gives the same result as a full scan, with far fewer quads visited.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/store.h"
#include "kg_core/sparql/query_engine.h"

namespace kg_core {
namespace {

Term Ex(const std::string& name) { return Iri(kEx + name); }
Term GraphNumber(int i) { return Iri(kGraph + std::to_string(i)); }

// Counts the quads visited.
class CountingView : public GraphView {
 public:
  explicit CountingView(const GraphView& view) : view_(view) {}
  TermId Find(const Term& term) const override { return view_.Find(term); }
  const Term& Get(TermId id) const override { return view_.Get(id); }
  void Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const override {
    view_.Match(pattern, [&](const Quad& quad) {
      ++looked_at;
      return visit(quad);
    });
  }
  std::size_t Estimate(const Quad& pattern) const override {
    return view_.Estimate(pattern);
  }
  std::vector<TermId> Graphs() const override { return view_.Graphs(); }
  std::uint64_t world_version() const override { return 0; }

  mutable int looked_at = 0;

 private:
  const GraphView& view_;
};

// The values of one result column, sorted.
std::vector<std::string> Answer(const GraphView& view,
                                const std::string& query) {
  std::vector<std::string> cells;
  for (const auto& row :
       RunQuery(view, "SELECT ?g { " + query + " }", {}, {}).rows) {
    cells.push_back(row.at(0)->text);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

std::vector<Quad> Quads(const GraphView& view) {
  std::vector<Quad> quads;
  view.Match({}, [&](const Quad& quad) {
    quads.push_back(quad);
    return true;
  });
  return quads;
}

// Reference: ?g of every matching quad, by a full scan.
std::vector<std::string> ByScan(const GraphView& view, const Quad& pattern) {
  std::vector<std::string> cells;
  for (const Quad& q : Quads(view)) {
    const bool fits = (!pattern.subject || pattern.subject == q.subject) &&
                      (!pattern.predicate || pattern.predicate == q.predicate);
    if (fits) cells.push_back(view.Get(q.graph).text);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

TEST(NamedGraphs, GiveTheSameRowsAsAScanOfAllQuads) {
  std::mt19937 random(5);
  const auto pick = [&](const char* kind, int n) {
    return Ex(kind + std::to_string(random() % n));
  };
  for (int round = 0; round < 50; ++round) {
    Store store("");
    Transaction change = store.Begin();
    for (int i = random() % 400; i > 0; --i) {
      change.Add({pick("s", 30), pick("p", 3), pick("o", 30),
                  GraphNumber(random() % 12)});
    }
    change.Add({Ex("s0"), Ex("p0"), Ex("o0"), GraphNumber(0)});
    change.Commit(WorldChange::kYes);
    const auto view = store.Read();
    EXPECT_EQ(Answer(*view, "GRAPH ?g { ?s ?p ?o }"), ByScan(*view, {}));
    Quad pattern;
    pattern.predicate = view->Find(Ex("p0"));
    EXPECT_EQ(Answer(*view, "GRAPH ?g { ?s <" + Ex("p0").text + "> ?o }"),
              ByScan(*view, pattern));
    pattern = {};
    pattern.subject = view->Find(Ex("s0"));
    EXPECT_EQ(Answer(*view, "GRAPH ?g { <" + Ex("s0").text + "> ?p ?o }"),
              ByScan(*view, pattern));
    const auto all = ByScan(*view, {});
    const std::set<std::string> names(all.begin(), all.end());
    EXPECT_EQ(Answer(*view, "GRAPH ?g {}"),
              std::vector<std::string>(names.begin(), names.end()));
  }
}

TEST(NamedGraphs, AreListedWithoutLookingAtTheirQuads) {
  Store store("");
  Transaction change = store.Begin();
  for (int i = 0; i < 30000; ++i) {
    change.Add(
        {Ex("s" + std::to_string(i)), Ex("p"), Ex("o"), GraphNumber(i % 3)});
  }
  change.Add({Ex("s"), Ex("rare"), Ex("o"), GraphNumber(3)});
  change.Commit(WorldChange::kYes);
  const auto snapshot = store.Read();
  const CountingView view(*snapshot);
  EXPECT_EQ(Answer(view, "GRAPH ?g {}").size(), 4u);
  EXPECT_LT(view.looked_at, 20);
  // Candidates are graphs 0 to 2: each of their quads is visited once.
  view.looked_at = 0;
  EXPECT_EQ(Answer(view, "GRAPH ?g { ?s <" + Ex("p").text + "> ?o }").size(),
            30000u);
  EXPECT_LT(view.looked_at, 30020);
}

TEST(NamedGraphs, AGraphThatHasLostItsLastQuadIsNotListed) {
  Store store("");
  for (int i = 0; i < 3; ++i) {
    Transaction change = store.Begin();
    change.Add({Ex("s"), Ex("p"), Ex("o"), GraphNumber(i)});
    change.RemoveMatching(nullptr, nullptr, nullptr, GraphNumber(i - 1));
    change.Commit(WorldChange::kYes);
    EXPECT_EQ(Answer(*store.Read(), "GRAPH ?g {}"),
              std::vector<std::string>{GraphNumber(i).text});
  }
}

}  // namespace
}  // namespace kg_core
