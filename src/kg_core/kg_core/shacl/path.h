// SHACL property paths: parsing, writing, evaluation and inversion.
// https://www.w3.org/TR/shacl/#property-paths

#ifndef KG_CORE_SHACL_PATH_H_
#define KG_CORE_SHACL_PATH_H_

#include <set>
#include <string>
#include <vector>

#include "kg_core/shacl/data_graph.h"

namespace kg_core::shacl {

struct PropertyPath {
  enum class Kind {
    kPredicate,
    kInverse,
    kSequence,
    kAlternative,
    kZeroOrMore,
    kOneOrMore,
    kZeroOrOne
  };
  Kind kind = Kind::kSequence;      // An empty sequence is the identity path.
  Term predicate;                   // kPredicate only.
  std::vector<PropertyPath> parts;  // Other kinds: one part, or a list.
};

PropertyPath PredicatePath(const Term& predicate);
// The sequence of `a` and `b`.
PropertyPath Then(const PropertyPath& a, const PropertyPath& b);
// The inverse path.
PropertyPath Inverse(const PropertyPath& path);

// Turtle syntax, e.g. "ex:p", "[ sh:inversePath ex:p ]", "( ex:p ex:q )".
std::string ToTurtle(const PropertyPath& path);

// Reads the path described by `node`; throws InputError "path: ..." if it is
// not a valid path.
PropertyPath ReadPath(const GraphView& view, const std::string& graph,
                      const Term& node);

// All nodes reached from `from` along the path, each once. Terminates on
// cycles.
std::set<Term> Walk(const DataGraph& data, const PropertyPath& path,
                    const std::set<Term>& from);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_PATH_H_
