// Random rules, facts and changes of both. The inferred graph is compared with
// a naive evaluation of the rules over all assignments and with a new store
// loaded with the current facts; every reason is checked against its rule.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "kg_core/rules/facts_and_conclusions.h"
#include "kg_core/rules/testing/rule_store.h"

namespace kg_core {
namespace {

constexpr int kNodes = 5;
constexpr int kVariables = 3;

// A triple of numbers: nodes n0.., and predicates p0.. or, for 4, "a C".
using Fact3 = std::array<int, 3>;
using World = std::set<Fact3>;
constexpr int kType = 4;

// Subject and object are a node (>= 0) or a variable v, encoded as ~v (< 0).
struct Atom {
  int subject = 0;
  int predicate = 0;
  int object = 0;
  char path = ' ';  // Or '+' or '*'.
};

struct TestRule {
  int level = 0;
  std::vector<std::vector<Atom>> bodies;  // One, or two joined by UNION.
  std::vector<Atom> without;
  bool minus = false;  // MINUS, not NOT EXISTS.
  Atom head;
};

std::string Place(int place) {
  return place < 0 ? "?v" + std::to_string(~place)
                   : "ex:n" + std::to_string(place);
}

std::string Text(const Atom& atom) {
  if (atom.predicate == kType) {
    return Place(atom.subject) + " a ex:C" + std::to_string(atom.object);
  }
  std::string property = "ex:p" + std::to_string(atom.predicate);
  if (atom.path != ' ') property += atom.path;
  return Place(atom.subject) + " " + property + " " + Place(atom.object);
}

std::string Text(const Fact3& fact) {
  return Text(Atom{fact[0], fact[1], fact[2], ' '}) + " .\n";
}

std::string Text(const TestRule& rule) {
  std::string where;
  for (const std::vector<Atom>& body : rule.bodies) {
    where += where.empty() ? "{ " : " UNION { ";
    for (const Atom& atom : body) where += Text(atom) + " . ";
    where += "}";
  }
  for (const Atom& atom : rule.without) {
    where += (rule.minus ? " MINUS { " : " FILTER NOT EXISTS { ") + Text(atom) +
             " }";
  }
  return "CONSTRUCT { " + Text(rule.head) + " } WHERE { " + where + " }";
}

// The naive evaluator.

using Assignment = std::array<int, kVariables>;

int Value(int place, const Assignment& values) {
  return place < 0 ? values[static_cast<std::size_t>(~place)] : place;
}

// True if `to` is reached from `from` by one or more steps.
bool Reaches(const World& world, int predicate, int from, int to) {
  std::set<int> seen;
  std::vector<int> open = {from};
  while (!open.empty()) {
    const int node = open.back();
    open.pop_back();
    for (const Fact3& fact : world) {
      if (fact[0] != node || fact[1] != predicate) continue;
      if (fact[2] == to) return true;
      if (seen.insert(fact[2]).second) open.push_back(fact[2]);
    }
  }
  return false;
}

bool Holds(const Atom& atom, const Assignment& values, const World& world) {
  const int from = Value(atom.subject, values);
  // The class of a type atom is never a variable.
  const int to =
      atom.predicate == kType ? atom.object : Value(atom.object, values);
  if (atom.path == '*' && from == to) return true;
  if (atom.path != ' ') return Reaches(world, atom.predicate, from, to);
  return world.count({from, atom.predicate, to}) > 0;
}

bool HoldAll(const std::vector<Atom>& atoms, const Assignment& values,
             const World& world) {
  for (const Atom& atom : atoms) {
    if (!Holds(atom, values, world)) return false;
  }
  return true;
}

bool HoldsAny(const std::vector<Atom>& atoms, const Assignment& values,
              const World& world) {
  for (const Atom& atom : atoms) {
    if (Holds(atom, values, world)) return true;
  }
  return false;
}

template <typename Visit>
void ForEachAssignment(Visit visit) {
  Assignment values;
  for (int i = 0; i < kNodes * kNodes * kNodes; ++i) {
    values = {i % kNodes, i / kNodes % kNodes, i / kNodes / kNodes};
    visit(values);
  }
}

Fact3 Conclude(const Atom& head, const Assignment& values) {
  return {Value(head.subject, values), head.predicate,
          head.predicate == kType ? head.object : Value(head.object, values)};
}

World Evaluate(const std::map<int, TestRule>& rules, const World& facts) {
  World concluded;
  World all = facts;
  for (int level = 0; level < 3; ++level) {
    std::size_t before = 0;
    do {
      before = concluded.size();
      for (const auto& [name, rule] : rules) {
        if (rule.level != level) continue;
        ForEachAssignment([&, &rule = rule](const Assignment& values) {
          for (const std::vector<Atom>& body : rule.bodies) {
            if (!HoldAll(body, values, all)) continue;
            if (HoldsAny(rule.without, values, all)) continue;
            concluded.insert(Conclude(rule.head, values));
          }
        });
      }
      all.insert(concluded.begin(), concluded.end());
    } while (concluded.size() > before);
  }
  return concluded;
}

// Random cases. Predicates p0 and p1 are of level 0, p2 and types of level 1,
// p3 of level 2; a rule reads its own level and below, and negates only below.

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  int operator()(int n) {
    return static_cast<int>(random_() % static_cast<unsigned>(n));
  }

  int Predicate(int level) {
    static constexpr int kOf[3][2] = {{0, 1}, {2, kType}, {3, 3}};
    return kOf[level][(*this)(2)];
  }
  int AnyPlace() { return (*this)(6) == 0 ? (*this)(kNodes) : ~(*this)(3); }

  Atom MakeAtom(int level) {
    Atom atom;
    atom.predicate = Predicate(level);
    atom.subject = AnyPlace();
    atom.object = atom.predicate == kType ? (*this)(3) : AnyPlace();
    if (atom.predicate != kType && (*this)(5) == 0) {
      atom.path = "+*"[(*this)(2)];
    }
    return atom;
  }

  TestRule MakeRule() {
    TestRule rule;
    rule.level = (*this)(3);
    const int bodies = 1 + (*this)(4) / 3;
    for (int i = 0; i < bodies; ++i) {
      rule.bodies.push_back(MakeBody(rule.level));
    }
    if (rule.level > 0 && (*this)(2) == 0) {
      rule.without = {MakeAtom((*this)(rule.level))};
      rule.without[0].path = ' ';
      Bind(&rule.without[0].subject);
      if (rule.without[0].predicate != kType) Bind(&rule.without[0].object);
      rule.minus = (*this)(2) == 0 && HasVariable(rule.without[0]);
    }
    rule.head = MakeAtom(rule.level);
    rule.head.path = ' ';
    Bind(&rule.head.subject);
    if (rule.head.predicate != kType) Bind(&rule.head.object);
    return rule;
  }

  Fact3 MakeFact() {
    const int predicate = (*this)(5);
    return {(*this)(kNodes), predicate,
            (*this)(predicate == kType ? 3 : kNodes)};
  }

 private:
  // Every body binds variables 0 and 1 by atoms without paths.
  std::vector<Atom> MakeBody(int level) {
    std::vector<Atom> body;
    Atom binder;
    do {
      binder = MakeAtom((*this)(level + 1));
    } while (binder.predicate == kType);
    binder.subject = ~0;
    binder.object = ~1;
    binder.path = ' ';
    body.push_back(binder);
    for (int more = (*this)(3); more > 0; --more) {
      body.push_back(MakeAtom((*this)(level + 1)));
    }
    return body;
  }
  void Bind(int* place) {
    if (*place < 0) *place = ~(*this)(2);
  }
  static bool HasVariable(const Atom& atom) {
    return atom.subject < 0 || (atom.predicate != kType && atom.object < 0);
  }

  std::mt19937 random_;
};

// Converts terms back to numbers.
Fact3 ToFact(const Term& subject, const Term& predicate, const Term& object) {
  const auto digit = [](const Term& term) { return term.text.back() - '0'; };
  if (predicate == RdfType()) return {digit(subject), kType, digit(object)};
  return {digit(subject), digit(predicate), digit(object)};
}
Fact3 ToFact(const Triple& triple) {
  return ToFact(triple.subject, triple.predicate, triple.object);
}

World ConclusionsIn(const GraphView& view) {
  World world;
  for (const Statement& s : Conclusions(view)) {
    world.insert(ToFact(s.subject, s.predicate, s.object));
  }
  return world;
}

World CollectPremises(const Inference& inference) {
  World premises;
  for (const Triple& triple : inference.premises) {
    premises.insert(ToFact(triple));
  }
  return premises;
}

// True if some assignment lets the rule draw this conclusion from exactly these
// premises.
bool Follows(const TestRule& rule, const Inference& inference,
             const World& all) {
  const World premises = CollectPremises(inference);
  bool follows = false;
  ForEachAssignment([&](const Assignment& values) {
    if (Conclude(rule.head, values) != ToFact(inference.conclusion)) return;
    if (HoldsAny(rule.without, values, all)) return;
    for (const std::vector<Atom>& body : rule.bodies) {
      if (!HoldAll(body, values, premises)) continue;
      bool needs_all = true;
      for (const Fact3& premise : premises) {
        World fewer = premises;
        fewer.erase(premise);
        needs_all = needs_all && !HoldAll(body, values, fewer);
      }
      follows = follows || needs_all;
    }
  });
  return follows;
}

// True if all conclusions are grounded in facts: repeatedly removes grounded
// inferences until none is left.
bool RestOnFacts(std::vector<Inference> inferences, World grounded) {
  bool is_new = true;
  while (is_new) {
    is_new = false;
    for (const Inference& inference : inferences) {
      const World premises = CollectPremises(inference);
      const bool rests = std::all_of(
          premises.begin(), premises.end(),
          [&](const Fact3& fact) { return grounded.count(fact) > 0; });
      if (rests) is_new |= grounded.insert(ToFact(inference.conclusion)).second;
    }
  }
  return std::all_of(
      inferences.begin(), inferences.end(), [&](const Inference& inference) {
        const World premises = CollectPremises(inference);
        return std::all_of(
            premises.begin(), premises.end(),
            [&](const Fact3& fact) { return grounded.count(fact) > 0; });
      });
}

class RandomWorld {
 public:
  explicit RandomWorld(unsigned seed) : dice_(seed) {
    for (int i = 0; i < 6; ++i) pool_.push_back(dice_.MakeRule());
  }

  void ChangeSomething() {
    std::string add;
    std::string remove;
    touched_.clear();
    for (int n = 1 + dice_(4); n > 0; --n) ChangeFact(&add, &remove);
    if (dice_(3) == 0) ChangeRule(&add, &remove);
    ASSERT_EQ(store_.Change(add, remove), std::vector<std::string>());
  }

  void Check() {
    const auto view = store_.store.Read();
    const World wanted = Evaluate(rules_, facts_);
    ASSERT_EQ(ConclusionsIn(*view), wanted) << Describe();
    CheckReasons(*view, wanted);
    RuleStore scratch;
    std::string all;
    for (const auto& [name, rule] : rules_) all += RuleText(name);
    for (auto fact = facts_.rbegin(); fact != facts_.rend(); ++fact) {
      all += Text(*fact);
    }
    ASSERT_EQ(scratch.Change(all), std::vector<std::string>());
    ASSERT_EQ(WriteTurtle(*view, kInferredGraph),
              WriteTurtle(*scratch.store.Read(), kInferredGraph))
        << Describe();
    conclusions_ += wanted.size();
  }

  std::size_t conclusions() const { return conclusions_; }

 private:
  std::string RuleText(int name) const {
    return RuleStore::RuleTurtle("r" + std::to_string(name),
                                 Text(pool_[static_cast<std::size_t>(name)])) +
           "\n";
  }

  void ChangeFact(std::string* add, std::string* remove) {
    const Fact3 fact = dice_.MakeFact();
    // Each fact changes once per transaction.
    if (!touched_.insert(fact).second) return;
    const bool is_new = facts_.insert(fact).second;
    if (!is_new) facts_.erase(fact);
    (is_new ? *add : *remove) += Text(fact);
  }

  void ChangeRule(std::string* add, std::string* remove) {
    const int name = dice_(static_cast<int>(pool_.size()));
    const bool is_new =
        rules_.emplace(name, pool_[static_cast<std::size_t>(name)]).second;
    if (!is_new) rules_.erase(name);
    (is_new ? *add : *remove) += RuleText(name);
  }

  void CheckReasons(const GraphView& view, const World& conclusions) {
    World all = facts_;
    all.insert(conclusions.begin(), conclusions.end());
    std::vector<Inference> inferences;
    for (const Statement& s : Conclusions(view)) {
      const auto why = WhyInferred(view, {s.subject, s.predicate, s.object});
      ASSERT_FALSE(why.empty()) << s.subject << s.predicate << s.object;
      for (const Inference& inference : why) {
        const int name = inference.rule_iri.back() - '0';
        ASSERT_TRUE(Follows(rules_.at(name), inference, all))
            << Text(rules_.at(name));
        for (const Fact3& fact : CollectPremises(inference)) {
          ASSERT_EQ(all.count(fact), 1u);
        }
        inferences.push_back(inference);
      }
    }
    ASSERT_TRUE(RestOnFacts(inferences, facts_)) << Describe();
  }

  std::string Describe() const {
    std::string text;
    for (const auto& [name, rule] : rules_) text += Text(rule) + "\n";
    for (const Fact3& fact : facts_) text += Text(fact);
    return text;
  }

  Dice dice_;
  std::vector<TestRule> pool_;
  std::map<int, TestRule> rules_;
  World facts_;
  World touched_;
  RuleStore store_;
  std::size_t conclusions_ = 0;
};

TEST(InferenceRandom, ConclusionsAreTheFixedPointOfTheFactsAsTheyAre) {
  std::size_t conclusions = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    RandomWorld world(seed);
    for (int change = 0; change < 12; ++change) {
      world.ChangeSomething();
      if (HasFatalFailure()) FAIL() << "seed " << seed;
      world.Check();
      if (HasFatalFailure()) FAIL() << "seed " << seed << " change " << change;
    }
    conclusions += world.conclusions();
  }
  EXPECT_GT(conclusions, 1000u);
}

}  // namespace
}  // namespace kg_core
