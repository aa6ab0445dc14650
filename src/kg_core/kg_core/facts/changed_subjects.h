// What a transaction changes in the facts, by subject.

#ifndef KG_CORE_FACTS_CHANGED_SUBJECTS_H_
#define KG_CORE_FACTS_CHANGED_SUBJECTS_H_

#include <set>

#include "kg_core/rdf/store.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

// kAll: every fact there is counts as changed, too.
enum class ChangeScope { kChanged, kAll };

// Subjects of any fact that came or went; those of `property` only.
std::set<Term> ChangedSubjects(const Transaction& transaction);
std::set<Term> ChangedSubjects(const Transaction& transaction,
                               const Term& property,
                               ChangeScope scope = ChangeScope::kChanged);

// Objects of (subject, link) among the facts, also those that the transaction
// takes away.
std::set<Term> Linked(const Transaction& transaction, const Term& subject,
                      const Term& link);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_CHANGED_SUBJECTS_H_
