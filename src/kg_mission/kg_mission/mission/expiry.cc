#include "kg_mission/mission/expiry.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "kg_core/facts/literals.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/store.h"
#include "kg_mission/mission/validity.h"

namespace kg_mission {
namespace {

using kg_core::Facts;
using kg_core::GraphView;
using kg_core::Quad;
using kg_core::Statement;
using kg_core::Term;
using kg_core::ToTurtle;

constexpr double kNever_s = std::numeric_limits<double>::infinity();

// End of validity in Unix seconds by subject; the earlier one if there are two.
std::map<Term, double> Lives(const GraphView& view) {
  // An entity may have both end properties: the earlier time counts.
  std::map<Term, double> lives;
  for (const char* name : kEndProperties) {
    Quad pattern;
    pattern.predicate = view.Find(kg_core::Ex(name));
    pattern.graph = view.Find(Facts());
    if (pattern.predicate == kg_core::kNoTerm ||
        pattern.graph == kg_core::kNoTerm) {
      continue;
    }
    view.Match(pattern, [&](const Quad& quad) {
      const std::optional<double> end_s =
          kg_core::UnixSeconds(view.Get(quad.object));
      if (!end_s) return true;
      const auto known = lives.emplace(view.Get(quad.subject), *end_s).first;
      known->second = std::min(known->second, *end_s);
      return true;
    });
  }
  return lives;
}

// A fact with object `node` whose subject is not in `gone`, if there is one.
std::optional<Statement> Referrer(const GraphView& view, const Term& node,
                                  const std::set<Term>& gone) {
  std::optional<Statement> found;
  Quad pattern;
  pattern.object = view.Find(node);
  pattern.graph = view.Find(Facts());
  view.Match(pattern, [&](const Quad& quad) {
    const Term& subject = view.Get(quad.subject);
    if (gone.count(subject) != 0) return true;
    // Ingested facts about `node` are removed together with it.
    if (view.Get(quad.predicate) == kg_core::Ex("ingestedFrom")) return true;
    found = Statement{subject, view.Get(quad.predicate), node, Facts()};
    return false;
  });
  return found;
}

// The reason why `node` must be kept; empty if it can be removed.
std::string Obstacle(const GraphView& view, const Term& node,
                     const std::set<Term>& gone) {
  if (!node.is_iri()) return ToTurtle(node) + " is kept: it has no name";
  const std::optional<Statement> referrer = Referrer(view, node, gone);
  if (!referrer) return "";
  return ToTurtle(node) + " is kept: " + ToTurtle(referrer->subject) + " " +
         ToTurtle(referrer->predicate) + " refers to it";
}

}  // namespace

double NextExpiry_s(const GraphView& view, double after_s) {
  double next_s = kNever_s;
  for (const auto& [node, end_s] : Lives(view)) {
    if (end_s > after_s) next_s = std::min(next_s, end_s);
  }
  return next_s;
}

ExpiredFacts FindExpired(const GraphView& view, double mission_time_s) {
  std::set<Term> gone;
  for (const auto& [node, end_s] : Lives(view)) {
    if (end_s <= mission_time_s) gone.insert(node);
  }
  ExpiredFacts expiry;
  // Iterate: a subject that is kept may keep others.
  for (bool settled = false; !settled;) {
    settled = true;
    for (auto node = gone.begin(); node != gone.end();) {
      const std::string obstacle = Obstacle(view, *node, gone);
      if (!obstacle.empty()) {
        expiry.kept.push_back(obstacle);
        settled = false;
      }
      node = obstacle.empty() ? std::next(node) : gone.erase(node);
    }
  }
  expiry.update.author = "kg";
  expiry.update.id = "expiry";
  for (const Term& node : gone) {
    expiry.update.remove.push_back({ToTurtle(node), "", ""});
  }
  return expiry;
}

}  // namespace kg_mission
