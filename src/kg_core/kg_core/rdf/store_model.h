// For tests: a store's content as a plain set, and random changes of both.

#ifndef KG_CORE_RDF_STORE_MODEL_H_
#define KG_CORE_RDF_STORE_MODEL_H_

#include <algorithm>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/store.h"

namespace kg_core {

using Key = std::tuple<Term, Term, Term, Term>;  // Subject to graph.
using Model = std::set<Key>;

inline Key KeyOf(const Statement& s) {
  return {s.subject, s.predicate, s.object, s.graph};
}

inline Term Ex(const std::string& name) { return Iri(kEx + name); }

inline Statement Fact(const std::string& s, const std::string& p, Term object) {
  return {Ex(s), Ex(p), std::move(object), Iri(kFactsGraph)};
}

inline Model ContentOf(const GraphView& view) {
  Model content;
  view.Match({}, [&](const Quad& q) {
    content.emplace(view.Get(q.subject), view.Get(q.predicate),
                    view.Get(q.object), view.Get(q.graph));
    return true;
  });
  return content;
}

inline Model AsModel(const std::vector<Statement>& statements) {
  Model model;
  for (const Statement& s : statements) model.insert(KeyOf(s));
  return model;
}

inline Model Minus(const Model& a, const Model& b) {
  Model difference;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(),
                      std::inserter(difference, difference.end()));
  return difference;
}

class RandomFacts {
 public:
  explicit RandomFacts(int seed) : random_(seed) {}
  int Pick(int n) { return static_cast<int>(random_() % n); }
  Term Object() {
    switch (Pick(4)) {
      case 0:
        return Ex("o" + std::to_string(Pick(6)));
      case 1:
        return IntegerLiteral(Pick(6));
      case 2:
        return LanguageLiteral("w" + std::to_string(Pick(3)), "en");
      default:
        return Blank("b" + std::to_string(Pick(3)));
    }
  }
  Statement Next() {
    const Term graph = Iri(Pick(2) ? kFactsGraph : kVocabGraph);
    const Term subject = Pick(5) ? Ex("s" + std::to_string(Pick(8)))
                                 : Blank("b" + std::to_string(Pick(3)));
    return {subject, Ex("p" + std::to_string(Pick(4))), Object(), graph};
  }

 private:
  std::mt19937 random_;
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
      model->erase(KeyOf(s));
      return;
    default:
      change->Add(s);
      model->insert(KeyOf(s));
  }
}

}  // namespace kg_core

#endif  // KG_CORE_RDF_STORE_MODEL_H_
