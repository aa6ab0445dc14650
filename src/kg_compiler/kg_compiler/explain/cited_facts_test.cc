#include "kg_compiler/explain/cited_facts.h"

#include <gtest/gtest.h>

#include <string>

#include "kg_core/facts/literals.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/store.h"

namespace kg_compiler {
namespace {

using kg_core::Ex;
using kg_core::Facts;
using kg_core::Prov;

// What is said of a cell without data of a field whose file has so many
// impossible values.
std::string SaidOfNoData(int impossible_values) {
  kg_core::Store store("");
  kg_core::Transaction transaction = store.Begin();
  transaction.Add({Ex("field"), Prov("wasDerivedFrom"), Ex("file"), Facts()});
  transaction.Add({Ex("report"), Prov("wasDerivedFrom"), Ex("file"), Facts()});
  transaction.Add({Ex("report"), Ex("impossibleValues"),
                   kg_core::IntegerLiteral(impossible_values), Facts()});
  transaction.Add(
      {Ex("report"), Ex("variable"), kg_core::Literal("water_u"), Facts()});
  return CitedFacts(transaction.view()).NoData(Ex("field").text);
}

TEST(CitedFacts, SayThatACellMayLackDataBecauseItsValueIsImpossible) {
  EXPECT_EQ(SaidOfNoData(0), "land: the currents have no data here");
  EXPECT_EQ(SaidOfNoData(17),
            "land: the currents have no data here; or not land: 17 impossible "
            "values of water_u in the file count as no data");
}

}  // namespace
}  // namespace kg_compiler
