// Fuzz test: arbitrary input as a SPARQL query and as an update on a small
// dataset is answered, or rejected with a one-line error, within the limits.
// The result of a query can be written in every format; a rejected update
// changes nothing.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/results.h"
#include "kg_core/sparql/update_engine.h"

namespace kg_core {
namespace {

using kg_base::InputError;

constexpr char kWorld[] = R"ttl(
ex:alpha a ex:Agent ; ex:id "alpha" ; ex:usesPolicy ex:fast ; ex:speed 0.9 .
ex:bravo a ex:Agent ; ex:id "bravo"@en ; ex:usesPolicy ex:safe ; ex:speed 1e0 .
ex:zone geo:asWKT "POLYGON((0 0, 1 0, 1 1, 0 1, 0 0))"^^geo:wktLiteral ;
    ex:since "2026-06-02T00:00:00Z"^^xsd:dateTime ; ex:near ( ex:alpha 7 ) .
ex:alpha ex:after ex:bravo . ex:bravo ex:after ex:zone .
)ttl";

Store& World() {
  static Store* const store = [] {
    auto* made = new Store("");
    Transaction change = made->Begin();
    for (const Statement& s : ParseTurtle(kWorld, "world", Iri(kFactsGraph))) {
      change.Add(s);
    }
    change.Commit(WorldChange::kYes);
    return made;
  }();
  return *store;
}

QueryLimits Limits() {
  QueryLimits limits;
  limits.seconds = 0.5;
  limits.rows = 2000;
  limits.bytes = 1u << 20;
  limits.working_bytes = 8u << 20;
  return limits;
}

void CheckOneLine(const InputError& error) {
  if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
}

void Ask(const std::string& text) {
  try {
    const QueryResult result =
        RunQuery(*World().Read(), text, DefaultDataset(std::nullopt), Limits());
    for (const ResultFormat& format : ResultFormats()) format.write(result);
    TriplesToTurtle(result.triples);
  } catch (const InputError& error) {
    CheckOneLine(error);
  }
}

void Change(const std::string& text) {
  Transaction change = World().Begin();
  try {
    RunUpdate(text, {}, Limits(), &change);
  } catch (const InputError& error) {
    CheckOneLine(error);
    if (!change.empty()) std::abort();
  }
}

}  // namespace
}  // namespace kg_core

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  kg_core::Ask(text);
  kg_core::Change(text);
  return 0;
}
