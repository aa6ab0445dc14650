// Properties and classes of the ontology (vocabulary graph), for checks and for
// suggestions in error messages.

#ifndef KG_CORE_FACTS_VOCABULARY_H_
#define KG_CORE_FACTS_VOCABULARY_H_

#include <map>
#include <set>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

struct PropertyFacts {
  bool is_annotation = false;   // No restrictions.
  std::vector<Term> domains;    // ex:domainIncludes
  std::vector<Term> datatypes;  // Datatypes in ex:rangeIncludes.
  std::vector<Term> classes;    // Classes in ex:rangeIncludes.
};

class Vocabulary {
 public:
  explicit Vocabulary(const GraphView& view);

  const PropertyFacts* FindProperty(const Term& property) const;
  bool HasClass(const Term& type) const { return classes_.count(type) != 0; }
  // True if one of `types` or of their superclasses is among `tops`.
  bool IsAnyOf(const std::vector<Term>& types,
               const std::vector<Term>& tops) const;

  // The canonical name if `term` is an alias (owl:equivalentClass,
  // owl:equivalentProperty), else `term`.
  const Term& Canonical(const Term& term) const;

  // "ex:usePolicy is not a property of the ontology, nearest is ex:usesPolicy"
  std::string UnknownProperty(const Term& property) const;
  std::string UnknownClass(const Term& type) const;

 private:
  const GraphView& view_;
  std::map<Term, PropertyFacts> properties_;
  std::set<Term> classes_;
  std::map<Term, Term> aliases_;
};

// Levenshtein distance: minimum number of character insertions, deletions and
// replacements that turn a into b.
int EditDistance(const std::string& a, const std::string& b);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_VOCABULARY_H_
