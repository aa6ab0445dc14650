// SHACL property paths: read, written, walked and turned around.
// https://www.w3.org/TR/shacl/#property-paths

#ifndef KG_CORE_SHACL_PATH_H_
#define KG_CORE_SHACL_PATH_H_

#include <set>
#include <string>
#include <vector>

#include "kg_core/shacl/data_graph.h"

namespace kg_core::shacl {

struct Path {
  enum class Kind {
    kPredicate,
    kInverse,
    kSequence,
    kAlternative,
    kZeroOrMore,
    kOneOrMore,
    kZeroOrOne
  };
  Kind kind = Kind::kSequence;  // An empty sequence stays where it is.
  Term predicate;               // kPredicate only.
  std::vector<Path> parts;      // Else: one, or those of a list.
};

Path PredicatePath(const Term& predicate);
// `a`, then `b`.
Path Then(const Path& a, const Path& b);
// The path back.
Path Inverse(const Path& path);

// In Turtle, e.g. "ex:p", "[ sh:inversePath ex:p ]", "( ex:p ex:q )".
std::string ToTurtle(const Path& path);

// The path that `node` describes; throws InputError "path: ..." if it is none.
Path ReadPath(const GraphView& view, const std::string& graph,
              const Term& node);

// Every node that the path reaches from `from`, once. Cycles end.
std::set<Term> Walk(const DataGraph& data, const Path& path,
                    const std::set<Term>& from);

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_PATH_H_
