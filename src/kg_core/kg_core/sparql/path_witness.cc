#include "kg_core/sparql/path_witness.h"

#include <set>
#include <utility>

namespace kg_core::sparql {
namespace {

using Way = std::vector<Quad>;

Way Joined(Way first, const Way& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace

bool PathWitness::IsBetter(const Way& a, const Way& b) const {
  if (a.size() != b.size()) return a.size() < b.size();
  for (std::size_t i = 0; i < a.size(); ++i) {
    budget_->Step();
    for (const TermId Quad::*place :
         {&Quad::subject, &Quad::predicate, &Quad::object}) {
      if (a[i].*place == b[i].*place) continue;
      return terms_->Get(a[i].*place) < terms_->Get(b[i].*place);
    }
  }
  return false;
}

void PathWitness::Improve(std::optional<Way>* best,
                          std::optional<Way> way) const {
  if (way && (!*best || IsBetter(*way, **best))) *best = std::move(way);
}

std::optional<Way> PathWitness::Find(const PropertyPath& path, TermId from,
                                     TermId to) const {
  std::optional<Way> best;
  switch (path.kind) {
    case PropertyPath::Kind::kLink:
      return FindLink({from,
                       (*constants_)[static_cast<std::size_t>(path.constant)],
                       to, kNoTerm});
    case PropertyPath::Kind::kInverse:
      return Find(path.parts[0], to, from);
    case PropertyPath::Kind::kSequence:
      return FindSequence(path.parts.data(), path.parts.size(), from, to);
    case PropertyPath::Kind::kAlternative:
      for (const PropertyPath& part : path.parts) {
        Improve(&best, Find(part, from, to));
      }
      return best;
    case PropertyPath::Kind::kNegated:
      return FindNegated(path, from, to);
    case PropertyPath::Kind::kZeroOrMore:
    case PropertyPath::Kind::kOneOrMore:
    case PropertyPath::Kind::kZeroOrOne:
      break;
  }
  return FindClosure(path, from, to);
}

std::optional<Way> PathWitness::FindLink(const Quad& wanted) const {
  std::optional<Way> way;
  graph_->Match(wanted, [&way](const Quad& quad) {
    way = Way{quad};
    return false;
  });
  return way;
}

std::vector<TermId> PathWitness::Targets(const PropertyPath& path,
                                         TermId from) const {
  std::set<TermId> targets;
  walker_.Walk(path, {from, true}, {}, [&targets](TermId, TermId to) {
    targets.insert(to);
    return true;
  });
  return {targets.begin(), targets.end()};
}

std::optional<Way> PathWitness::FindSequence(const PropertyPath* parts,
                                             std::size_t count, TermId from,
                                             TermId to) const {
  if (count == 1) return Find(parts[0], from, to);
  std::optional<Way> best;
  for (const TermId middle : Targets(parts[0], from)) {
    const auto rest = FindSequence(parts + 1, count - 1, middle, to);
    if (!rest) continue;
    const auto first = Find(parts[0], from, middle);
    if (first) Improve(&best, Joined(*first, *rest));
  }
  return best;
}

// Tries every triple between the two nodes, in both directions.
std::optional<Way> PathWitness::FindNegated(const PropertyPath& path,
                                            TermId from, TermId to) const {
  std::optional<Way> best;
  for (const bool inverse : {false, true}) {
    const TermId subject = inverse ? to : from;
    const TermId object = inverse ? from : to;
    // Members of the set exclude triples only in their own direction.
    bool has_direction = !inverse && path.parts.empty();
    std::set<TermId> excluded;
    for (const PropertyPath& part : path.parts) {
      if ((part.kind == PropertyPath::Kind::kInverse) != inverse) continue;
      has_direction = true;
      const PropertyPath& link = inverse ? part.parts[0] : part;
      excluded.insert((*constants_)[static_cast<std::size_t>(link.constant)]);
    }
    if (!has_direction) continue;
    graph_->Match({subject, kNoTerm, object, kNoTerm}, [&](const Quad& quad) {
      if (excluded.count(quad.predicate) == 0) Improve(&best, Way{quad});
      return true;
    });
  }
  return best;
}

// One more step from every node of `layer`: the best path to each next node.
PathWitness::Ways PathWitness::NextLayer(const PropertyPath& step,
                                         const Ways& layer) const {
  Ways next;
  for (const auto& [node, way] : layer) {
    for (const TermId target : Targets(step, node)) {
      budget_->Step();
      const auto hop = Find(step, node, target);
      if (!hop) continue;
      Way longer = Joined(way, *hop);
      const auto [known, is_new] = next.try_emplace(target, longer);
      if (!is_new && IsBetter(longer, known->second)) {
        known->second = std::move(longer);
      }
    }
  }
  return next;
}

// Breadth-first search, one layer of nodes at a time.
std::optional<Way> PathWitness::FindClosure(const PropertyPath& path,
                                            TermId from, TermId to) const {
  if (path.kind != PropertyPath::Kind::kOneOrMore && from == to) return Way{};
  std::set<TermId> seen;
  Ways layer = {{from, {}}};
  while (!layer.empty()) {
    layer = NextLayer(path.parts[0], layer);
    const auto found = layer.find(to);
    if (found != layer.end()) return found->second;
    if (path.kind == PropertyPath::Kind::kZeroOrOne) break;
    for (auto node = layer.begin(); node != layer.end();) {
      node =
          seen.insert(node->first).second ? std::next(node) : layer.erase(node);
    }
  }
  return std::nullopt;
}

}  // namespace kg_core::sparql
