// Kinds of triples: a predicate, and the class where that is rdf:type. What a
// rule reads and writes is known as such kinds.

#ifndef KG_CORE_RULES_TRIPLE_KIND_H_
#define KG_CORE_RULES_TRIPLE_KIND_H_

#include <optional>
#include <string>

#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

// Triples with this predicate (nothing: any) and, of rdf:type, this class
// (nothing: any).
struct TripleKind {
  std::optional<Term> predicate;
  std::optional<Term> type;
};

bool Includes(const TripleKind& kind, const Statement& statement);
bool Overlap(const TripleKind& a, const TripleKind& b);
std::string ToString(const TripleKind& kind);

}  // namespace kg_core

#endif  // KG_CORE_RULES_TRIPLE_KIND_H_
