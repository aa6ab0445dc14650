// The subjects of the facts that a transaction changes.

#ifndef KG_CORE_FACTS_CHANGED_SUBJECTS_H_
#define KG_CORE_FACTS_CHANGED_SUBJECTS_H_

#include <set>

#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

// kAll: every existing fact also counts as changed.
enum class ChangeScope { kChanged, kAll };

// Subjects of all added or removed facts; the overload considers `property`
// only.
std::set<Term> ChangedSubjects(const Transaction& transaction);
std::set<Term> ChangedSubjects(const Transaction& transaction,
                               const Term& property,
                               ChangeScope scope = ChangeScope::kChanged);

// Objects of (subject, link) in the facts, including those removed by the
// transaction.
std::set<Term> Linked(const Transaction& transaction, const Term& subject,
                      const Term& link);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_CHANGED_SUBJECTS_H_
