// Term table of one query: terms of the view keep their ids; terms that the
// query introduces or computes get local ids.

#ifndef KG_CORE_SPARQL_TERM_TABLE_H_
#define KG_CORE_SPARQL_TERM_TABLE_H_

#include <deque>
#include <string>

#include "absl/container/flat_hash_map.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/sparql/budget.h"

namespace kg_core::sparql {

class TermTable {
 public:
  TermTable(const GraphView* view, QueryBudget* budget)
      : view_(view), budget_(budget) {}

  // Equal terms have equal ids.
  TermId Intern(const Term& term);
  const Term& Get(TermId id) const;
  // True for a term unknown to the view, which thus occurs in no quad.
  static bool IsLocal(TermId id) { return (id & kLocalBit) != 0; }
  const GraphView& view() const { return *view_; }

 private:
  static constexpr TermId kLocalBit = 0x80000000u;

  const GraphView* view_;
  QueryBudget* budget_;
  std::deque<Term> terms_;
  absl::flat_hash_map<std::string, TermId> ids_;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_TERM_TABLE_H_
