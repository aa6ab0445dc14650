// For tests: a store's content as a std::set, and random changes applied to
// both.

#ifndef KG_CORE_RDF_TESTING_STORE_MODEL_H_
#define KG_CORE_RDF_TESTING_STORE_MODEL_H_

#include <algorithm>
#include <iterator>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "gtest/gtest.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/store.h"

namespace kg_core {

using Key = std::tuple<Term, Term, Term, Term>;  // Subject to graph.
using Model = std::set<Key>;

inline Key MakeKey(const Statement& s) {
  return {s.subject, s.predicate, s.object, s.graph};
}

inline Term Ex(const std::string& name) { return Iri(kEx + name); }

inline Statement Fact(const std::string& s, const std::string& p, Term object) {
  return {Ex(s), Ex(p), std::move(object), Iri(kFactsGraph)};
}

inline Model GetContent(const GraphView& view) {
  Model content;
  view.Match({}, [&](const Quad& q) {
    content.emplace(view.Get(q.subject), view.Get(q.predicate),
                    view.Get(q.object), view.Get(q.graph));
    return true;
  });
  return content;
}

// The named graphs: as reported by the view, and as derived from the model.
inline std::vector<Term> ListGraphs(const GraphView& view) {
  std::vector<Term> graphs;
  for (const TermId graph : view.Graphs()) graphs.push_back(view.Get(graph));
  std::sort(graphs.begin(), graphs.end());
  return graphs;
}

inline std::vector<Term> ListGraphs(const Model& model) {
  std::set<Term> graphs;
  for (const Key& key : model) graphs.insert(std::get<3>(key));
  return {graphs.begin(), graphs.end()};
}

inline Model AsModel(const std::vector<Statement>& statements) {
  Model model;
  for (const Statement& s : statements) model.insert(MakeKey(s));
  return model;
}

inline Model Minus(const Model& a, const Model& b) {
  Model difference;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(),
                      std::inserter(difference, difference.end()));
  return difference;
}

// About 40 * `spread` different terms.
class RandomFacts {
 public:
  explicit RandomFacts(int seed, int spread = 1)
      : random_(seed), spread_(spread) {}
  int Pick(int n) { return static_cast<int>(random_() % n); }
  Term Object() {
    switch (Pick(4)) {
      case 0:
        return Ex("o" + std::to_string(Pick(6 * spread_)));
      case 1:
        return IntegerLiteral(Pick(6 * spread_));
      case 2:
        return LanguageLiteral("w" + std::to_string(Pick(3)), "en");
      default:
        return Blank("b" + std::to_string(Pick(3)));
    }
  }
  Statement Next() {
    const Term graph = Iri(Pick(2) ? kFactsGraph : kVocabGraph);
    const Term subject = Pick(5) ? Ex("s" + std::to_string(Pick(8 * spread_)))
                                 : Blank("b" + std::to_string(Pick(3)));
    return {subject, Ex("p" + std::to_string(Pick(4))), Object(), graph};
  }

 private:
  std::mt19937 random_;
  int spread_;
};

inline void RemoveMatching(const Statement& s, int bits, Transaction* change,
                           Model* model) {
  const Term* subject = bits & 4 ? &s.subject : nullptr;
  const Term* predicate = bits & 2 ? &s.predicate : nullptr;
  const Term* object = bits & 1 ? &s.object : nullptr;
  change->RemoveMatching(subject, predicate, object, s.graph);
  for (auto it = model->begin(); it != model->end();) {
    const bool fits = (!subject || std::get<0>(*it) == *subject) &&
                      (!predicate || std::get<1>(*it) == *predicate) &&
                      (!object || std::get<2>(*it) == *object) &&
                      std::get<3>(*it) == s.graph;
    it = fits ? model->erase(it) : std::next(it);
  }
}

inline void ChangeAtRandom(RandomFacts* facts, Transaction* change,
                           Model* model) {
  const Statement s = facts->Next();
  switch (facts->Pick(6)) {
    case 0:
      RemoveMatching(s, 1 + facts->Pick(7), change, model);
      return;
    case 1:
    case 2:
      change->Remove(s);
      model->erase(MakeKey(s));
      return;
    default:
      change->Add(s);
      model->insert(MakeKey(s));
  }
}

// Random transactions, committed or discarded, checked against a std::set;
// snapshots are held over many commits; a durable store is reopened at random.
inline void RunAgainstModel(const std::string& path, RandomFacts facts,
                            const StoreOptions& options) {
  auto store = std::make_unique<Store>(path, options);
  Model committed;
  std::uint64_t world_version = 0;
  std::vector<std::pair<std::shared_ptr<const GraphView>, Model>> held;
  for (int round = 0; round < 120; ++round) {
    if (!path.empty() && facts.Pick(12) == 0) {
      store.reset();
      store = std::make_unique<Store>(path, options);
    }
    {
      Transaction change = store->Begin();
      Model next = committed;
      for (int i = facts.Pick(30); i > 0; --i) {
        ChangeAtRandom(&facts, &change, &next);
      }
      ASSERT_EQ(GetContent(change.view()), next);
      ASSERT_EQ(ListGraphs(change.view()), ListGraphs(next));
      ASSERT_EQ(AsModel(change.added()), Minus(next, committed));
      ASSERT_EQ(AsModel(change.removed()), Minus(committed, next));
      ASSERT_EQ(change.empty(), next == committed);
      ASSERT_EQ(GetContent(*store->Read()), committed);
      if (facts.Pick(4) != 0) {
        const bool is_world = facts.Pick(2) == 0;
        if (is_world && next != committed) ++world_version;
        ASSERT_EQ(
            change.Commit(is_world ? WorldChange::kYes : WorldChange::kNo),
            world_version);
        committed = next;
      }
    }
    ASSERT_EQ(store->world_version(), world_version);
    ASSERT_EQ(store->quad_count(), committed.size());
    held.emplace_back(store->Read(), committed);
    const auto& [view, was] = held[facts.Pick(held.size())];
    ASSERT_EQ(GetContent(*view), was);
    ASSERT_EQ(ListGraphs(*view), ListGraphs(was));
  }
  store.reset();
  for (const auto& [view, was] : held) ASSERT_EQ(GetContent(*view), was);
}

}  // namespace kg_core

#endif  // KG_CORE_RDF_TESTING_STORE_MODEL_H_
