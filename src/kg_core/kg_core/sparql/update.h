// A parsed update request. https://www.w3.org/TR/sparql11-update/

#ifndef KG_CORE_SPARQL_UPDATE_H_
#define KG_CORE_SPARQL_UPDATE_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/sparql/query.h"
#include "kg_core/sparql/token.h"

namespace kg_core::sparql {

// Graph operand of CLEAR, DROP, CREATE, COPY, MOVE and ADD.
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
  QueryPosition position;  // Position in the text, for errors.

  // kModify: quads removed and then added for every solution of query.select;
  // USING is stored as FROM.
  Query query;
  std::vector<QuadTemplate> removed;
  std::vector<QuadTemplate> added;
  std::optional<std::string> with;

  // Operands of the other kinds.
  bool silent = false;
  GraphRef source;  // kCopy, kMove, kAdd.
  GraphRef target;
};

struct UpdateRequest {
  std::vector<UpdateOperation> operations;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_UPDATE_H_
