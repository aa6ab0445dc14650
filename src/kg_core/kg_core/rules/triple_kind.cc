#include "kg_core/rules/triple_kind.h"

namespace kg_core {
namespace {

bool Agree(const std::optional<Term>& a, const std::optional<Term>& b) {
  return !a || !b || *a == *b;
}

}  // namespace

bool Includes(const TripleKind& kind, const Statement& statement) {
  if (kind.predicate && *kind.predicate != statement.predicate) return false;
  return !kind.type || *kind.type == statement.object;
}

bool Overlap(const TripleKind& a, const TripleKind& b) {
  return Agree(a.predicate, b.predicate) && Agree(a.type, b.type);
}

std::string ToString(const TripleKind& kind) {
  if (kind.type) return "a " + ToTurtle(*kind.type);
  return kind.predicate ? ToTurtle(*kind.predicate) : "any property";
}

}  // namespace kg_core
