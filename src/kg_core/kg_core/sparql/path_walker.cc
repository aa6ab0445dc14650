#include "kg_core/sparql/path_walker.h"

#include <algorithm>

#include "absl/container/flat_hash_set.h"

namespace kg_core::sparql {

bool PathWalker::Walk(const PropertyPath& path, End from, End to,
                      Visit visit) const {
  switch (path.kind) {
    case PropertyPath::Kind::kLink:
      return graph_->Match(
          {from.id, FindId(path), to.id, kNoTerm},
          [&](const Quad& quad) { return visit(quad.subject, quad.object); });
    case PropertyPath::Kind::kInverse:
      return Walk(path.parts[0], to, from,
                  [&](TermId a, TermId b) { return visit(b, a); });
    case PropertyPath::Kind::kSequence:
      return WalkSequence(path.parts.data(), path.parts.size(), {from, to},
                          visit);
    case PropertyPath::Kind::kAlternative:
      return std::all_of(path.parts.begin(), path.parts.end(),
                         [&](const PropertyPath& part) {
                           return Walk(part, from, to, visit);
                         });
    case PropertyPath::Kind::kNegated:
      return WalkNegated(path, {from, to}, visit);
    case PropertyPath::Kind::kZeroOrMore:
    case PropertyPath::Kind::kOneOrMore:
    case PropertyPath::Kind::kZeroOrOne:
      return WalkClosure(path, {from, to}, visit);
  }
  return true;
}

bool PathWalker::WalkSequence(const PropertyPath* parts, std::size_t count,
                              Ends ends, Visit visit) const {
  if (count == 1) return Walk(parts[0], ends.from, ends.to, visit);
  if (ends.from.id == kNoTerm && ends.to.id != kNoTerm) {
    return Walk(parts[count - 1], End(), ends.to,
                [&](TermId middle, TermId to) {
                  return WalkSequence(
                      parts, count - 1, {End(), End{middle}},
                      [&](TermId from, TermId) { return visit(from, to); });
                });
  }
  return Walk(parts[0], ends.from, End(), [&](TermId from, TermId middle) {
    return WalkSequence(parts + 1, count - 1, {End{middle}, ends.to},
                        [&](TermId, TermId to) { return visit(from, to); });
  });
}

// https://www.w3.org/TR/sparql11-query/#defn_evalPP_negatedPropertySet
bool PathWalker::WalkNegated(const PropertyPath& path, Ends ends,
                             Visit visit) const {
  std::vector<TermId> forward;
  std::vector<TermId> backward;
  for (const PropertyPath& part : path.parts) {
    const bool inverse = part.kind == PropertyPath::Kind::kInverse;
    (inverse ? backward : forward)
        .push_back(FindId(inverse ? part.parts[0] : part));
  }
  const auto contains = [](const std::vector<TermId>& ids, TermId id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  // !(p | q) matches forward only, !(^p) backward only, a mixture both.
  if (!forward.empty() || backward.empty()) {
    const bool go_on = graph_->Match(
        {ends.from.id, kNoTerm, ends.to.id, kNoTerm}, [&](const Quad& quad) {
          return contains(forward, quad.predicate) ||
                 visit(quad.subject, quad.object);
        });
    if (!go_on) return false;
  }
  if (backward.empty()) return true;
  return graph_->Match({ends.to.id, kNoTerm, ends.from.id, kNoTerm},
                       [&](const Quad& quad) {
                         return contains(backward, quad.predicate) ||
                                visit(quad.object, quad.subject);
                       });
}

// https://www.w3.org/TR/sparql11-query/#defn_evalPP_ZeroOrMorePath
std::vector<TermId> PathWalker::Reach(const PropertyPath& path, TermId start,
                                      bool forward) const {
  absl::flat_hash_set<TermId> seen;
  std::vector<TermId> reached;
  const auto add = [&](TermId node) {
    budget_->Step();
    if (seen.insert(node).second) reached.push_back(node);
  };
  const auto expand = [&](TermId node) {
    const End bound{node, true};  // ALP starts each step from a term.
    Walk(path.parts[0], forward ? bound : End(), forward ? End() : bound,
         [&](TermId from, TermId to) {
           add(forward ? to : from);
           return true;
         });
  };
  // Breadth-first search. p+ includes its start only if a cycle leads back to
  // it.
  if (path.kind == PropertyPath::Kind::kOneOrMore) {
    expand(start);
  } else {
    add(start);
  }
  if (path.kind == PropertyPath::Kind::kZeroOrOne) {
    expand(start);
    return reached;
  }
  for (std::size_t i = 0; i < reached.size(); ++i) expand(reached[i]);
  return reached;
}

bool PathWalker::WalkClosure(const PropertyPath& path, Ends ends,
                             Visit visit) const {
  const TermId from = ends.from.id;
  const TermId to = ends.to.id;
  if (from == kNoTerm && to == kNoTerm) {
    for (const TermId node : graph_->Nodes()) {
      if (!WalkClosure(path, {End{node}, End()}, visit)) return false;
    }
    return true;
  }
  const TermId start = from == kNoTerm ? to : from;
  const bool between_variables = !ends.from.is_term && !ends.to.is_term;
  if (between_variables && !graph_->HasNode(start)) return true;
  if (from == kNoTerm) {
    for (const TermId node : Reach(path, to, false)) {
      if (!visit(node, to)) return false;
    }
    return true;
  }
  for (const TermId node : Reach(path, from, true)) {
    if (to != kNoTerm && to != node) continue;
    if (!visit(from, node)) return false;
  }
  return true;
}

}  // namespace kg_core::sparql
