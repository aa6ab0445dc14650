// SHACL property paths: read, written, walked and turned around.
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
  Kind kind = Kind::kSequence;      // An empty sequence stays where it is.
  Term predicate;                   // kPredicate only.
  std::vector<PropertyPath> parts;  // Else: one, or those of a list.
};

PropertyPath PredicatePath(const Term& predicate);
// `a`, then `b`.
PropertyPath Then(const PropertyPath& a, const PropertyPath& b);
// The path back.
PropertyPath Inverse(const PropertyPath& path);

// In Turtle, e.g. "ex:p", "[ sh:inversePath ex:p ]", "( ex:p ex:q )".
std::string ToTurtle(const PropertyPath& path);

// The path that `node` describes; throws InputError "path: ..." if it is none.
PropertyPath ReadPath(const GraphView& view, const std::string& graph,
                      const Term& node);

// Every node that the path reaches from `from`, once. Cycles end.
std::set<Term> Walk(const DataGraph& data, const PropertyPath& path,
                    const std::set<Term>& from);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_PATH_H_
