// The functions of SPARQL, as data tables.
// https://www.w3.org/TR/sparql11-query/#SparqlOps
//
// A function takes terms and returns a term, or std::nullopt for SPARQL's
// error. Forms that accept unbound arguments or evaluate lazily (BOUND, IF,
// COALESCE, IN, sameTerm, EXISTS) are not functions but part of expression.cc.

#ifndef KG_CORE_SPARQL_FUNCTIONS_H_
#define KG_CORE_SPARQL_FUNCTIONS_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "kg_base/text/regex.h"
#include "kg_core/rdf/term.h"

namespace kg_base {
class Geometry;
}

namespace kg_core::sparql {

// State shared by function calls besides their arguments; one per query.
struct FunctionContext {
  std::string base;
  Term now;
  std::mt19937_64 random;
  kg_base::RegexCache regexes;
  // Parsed WKT by literal text; nullptr if the text is not valid WKT.
  absl::flat_hash_map<std::string, std::shared_ptr<const kg_base::Geometry>>
      geometries;
  // Results of BNODE("x") by label, which are the same within one solution.
  absl::flat_hash_map<std::string, Term> blanks_of_row;
};

using Arguments = std::vector<const Term*>;
using Answer = std::optional<Term>;

struct SparqlFunction {
  std::string name;  // Upper case keyword, or an IRI.
  std::size_t least = 1;
  std::size_t most = 1;
  Answer (*call)(FunctionContext& context, const Arguments& arguments);
};

inline constexpr std::size_t kAnyNumber = 1000000;

std::vector<SparqlFunction> TermFunctions();
std::vector<SparqlFunction> StringFunctions();
std::vector<SparqlFunction> NumberFunctions();
std::vector<SparqlFunction> TimeFunctions();
std::vector<SparqlFunction> HashFunctions();
std::vector<SparqlFunction> CastFunctions();
std::vector<SparqlFunction> GeoFunctions();

// Look-up by case-insensitive keyword or by IRI; nullptr if unknown.
const SparqlFunction* FindKeywordFunction(std::string_view name);
const SparqlFunction* FindIriFunction(std::string_view iri);

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_FUNCTIONS_H_
