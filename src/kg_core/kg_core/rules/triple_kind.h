// Kinds of triples: a predicate, plus the class if the predicate is rdf:type.
// Used to describe what a rule reads and writes.

#ifndef KG_CORE_RULES_TRIPLE_KIND_H_
#define KG_CORE_RULES_TRIPLE_KIND_H_

#include <optional>
#include <string>

#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

// Triples with this predicate (nullopt: any) and, for rdf:type, this class
// (nullopt: any).
struct TripleKind {
  std::optional<Term> predicate;
  std::optional<Term> type;
};

bool Includes(const TripleKind& kind, const Statement& statement);
bool Overlap(const TripleKind& a, const TripleKind& b);
std::string ToString(const TripleKind& kind);

}  // namespace kg_core

#endif  // KG_CORE_RULES_TRIPLE_KIND_H_
