// Result of a query.

#ifndef KG_CORE_SPARQL_QUERY_RESULT_H_
#define KG_CORE_SPARQL_QUERY_RESULT_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/rdf/term.h"

namespace kg_core {

struct Triple {
  Term subject;
  Term predicate;
  Term object;
};

struct QueryResult {
  enum class Form { kSelect, kAsk, kConstruct, kDescribe };
  Form form = Form::kSelect;
  std::vector<std::string> variables;
  std::vector<std::vector<std::optional<Term>>> rows;
  bool answer = false;
  std::vector<Triple> triples;  // For CONSTRUCT and DESCRIBE, each once.
};

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_QUERY_RESULT_H_
