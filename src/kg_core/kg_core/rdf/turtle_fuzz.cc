// Fuzz test: arbitrary input as Turtle is either rejected with a one-line
// error, or survives parse, write and parse with the same facts.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/isomorphism.h"

namespace kg_core {
namespace {

// With more, the isomorphism test is too slow.
constexpr std::size_t kManyBlanks = 6;

std::size_t CountBlanks(const std::vector<Statement>& statements) {
  std::set<std::string> labels;
  for (const Statement& s : statements) {
    if (s.subject.is_blank()) labels.insert(s.subject.text);
    if (s.object.is_blank()) labels.insert(s.object.text);
  }
  return labels.size();
}

std::string Write(const std::vector<Statement>& statements) {
  Store store("");
  Transaction change = store.Begin();
  for (const Statement& s : statements) change.Add(s);
  change.Commit(WorldChange::kYes);
  return WriteTurtle(*store.Read(), kFactsGraph);
}

void ReadWriteRead(const std::string& text) {
  const Term graph = Iri(kFactsGraph);
  const std::vector<Statement> first = ParseTurtle(text, "fuzz", graph);
  const std::vector<Statement> second =
      ParseTurtle(Write(first), "written", graph);
  if (CountBlanks(first) != CountBlanks(second)) std::abort();
  if (CountBlanks(first) > kManyBlanks) return;
  if (!IsIsomorphic(first, second)) std::abort();
}

}  // namespace
}  // namespace kg_core

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    kg_core::ReadWriteRead(text);
  } catch (const kg_base::InputError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}
