// A parsed update request. https://www.w3.org/TR/sparql11-update/

#ifndef KG_CORE_SPARQL_UPDATE_H_
#define KG_CORE_SPARQL_UPDATE_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/sparql/query.h"
#include "kg_core/sparql/token.h"

namespace kg_core::sparql {

// The graphs that CLEAR, DROP, CREATE, COPY, MOVE and ADD refer to.
struct GraphRef {
  enum class Kind { kDefault, kNamed, kAll, kIri };
  Kind kind = Kind::kDefault;
  std::string iri;
};

struct UpdateOperation {
  enum class Kind {
    kModify,  // INSERT DATA, DELETE DATA, DELETE WHERE, DELETE/INSERT WHERE
    kLoad,
    kClear,
    kDrop,
    kCreate,
    kCopy,
    kMove,
    kAdd,
  };
  Kind kind = Kind::kModify;
  QueryPosition position;  // For errors.

  // kModify: for every solution of query.select, removed and then added quads;
  // USING stands where FROM stands in a query.
  Query query;
  std::vector<QuadTemplate> removed;
  std::vector<QuadTemplate> added;
  std::optional<std::string> with;

  // The others.
  bool silent = false;
  GraphRef source;  // kCopy, kMove, kAdd.
  GraphRef target;
};

struct UpdateRequest {
  std::vector<UpdateOperation> operations;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_UPDATE_H_
