// Resource limits of one query.

#ifndef KG_CORE_SPARQL_LIMITS_H_
#define KG_CORE_SPARQL_LIMITS_H_

#include <cstddef>

namespace kg_core {

struct QueryLimits {
  double seconds = 2.0;
  std::size_t rows = 1000000;     // Result rows or triples.
  std::size_t bytes = 64u << 20;  // Size of the result's terms.
  std::size_t text_bytes = 64u << 10;
  int nesting = 200;
  // Memory for the state of sorting, grouping, joining and paths, in bytes.
  std::size_t working_bytes = 256u << 20;
};

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_LIMITS_H_
