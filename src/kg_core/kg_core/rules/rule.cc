#include "kg_core/rules/rule.h"

#include <algorithm>
#include <set>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_core/facts/literals.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rules/rule_analysis.h"
#include "kg_core/sparql/algebra.h"
#include "kg_core/sparql/limits.h"
#include "kg_core/sparql/parser.h"

namespace kg_core {
namespace {

using kg_base::InputError;

// Removes the order of solutions, which is irrelevant since conclusions are a
// set.
void DropOrder(sparql::GraphPattern* pattern);
void DropOrder(sparql::SelectQuery* select) {
  select->order_by.clear();
  select->distinct = false;
  DropOrder(&select->where);
}
void DropOrder(sparql::GraphPattern* pattern) {
  for (sparql::GraphPattern& part : pattern->parts) DropOrder(&part);
  if (pattern->select != nullptr) DropOrder(pattern->select.get());
}

Rule Parse(const Term& iri, const std::string& construct) {
  const QueryLimits limits;
  if (construct.size() > limits.text_bytes) {
    throw InputError("longer than the limit of " +
                     std::to_string(limits.text_bytes) + " bytes");
  }
  Rule rule;
  rule.iri = iri;
  rule.query = sparql::ParseQuery(construct, limits.nesting);
  RuleReads found = AnalyseRule(rule.query);
  rule.reads = std::move(found.reads);
  rule.negative_reads = std::move(found.negative_reads);
  DropOrder(&rule.query.select);
  sparql::Prepare(&rule.query.select);
  rule.writes = AnalyseTemplate(rule.query);
  // An ASK yields whole solutions, a CONSTRUCT only the variables named in its
  // template.
  if (!rule.query.select.grouped) rule.query.form = sparql::Query::Form::kAsk;
  return rule;
}

// The values in the facts if any, else those in the vocabulary.
std::vector<Term> CollectValues(const GraphView& view, const Term& rule,
                                const Term& property) {
  std::vector<Term> values = Objects(view, kFactsGraph, rule, property);
  if (values.empty()) values = Objects(view, kVocabGraph, rule, property);
  return values;
}

bool IsEnabled(const GraphView& view, const Term& rule) {
  const std::vector<Term> flags = CollectValues(view, rule, Ex("enabled"));
  return std::none_of(flags.begin(), flags.end(), [](const Term& flag) {
    return BooleanValue(flag) == false;
  });
}

}  // namespace

Rule ParseRule(const Term& iri, const std::string& construct) {
  try {
    return Parse(iri, construct);
  } catch (const InputError& error) {
    throw InputError(ToTurtle(iri) + " ex:construct: " + error.what());
  }
}

std::vector<Rule> LoadRules(const GraphView& view,
                            std::vector<std::string>* reasons) {
  std::set<Term> iris;
  for (const char* graph : {kVocabGraph, kFactsGraph}) {
    for (Term& iri : Subjects(view, graph, RdfType(), Ex("Rule"))) {
      iris.insert(std::move(iri));
    }
  }
  std::vector<Rule> rules;
  for (const Term& iri : iris) {
    // Record one reason per unusable rule and continue with the next.
    try {
      const std::vector<Term> texts = CollectValues(view, iri, Ex("construct"));
      if (!iri.is_iri() || texts.size() != 1) {
        throw InputError(ToTurtle(iri) +
                         " ex:construct: expected an IRI with exactly one");
      }
      Rule rule = ParseRule(iri, texts[0].text);
      if (IsEnabled(view, iri)) rules.push_back(std::move(rule));
    } catch (const InputError& error) {
      reasons->push_back(error.what());
    }
  }
  return rules;
}

bool DefinesRules(const Statement& statement) {
  return statement.predicate == Ex("construct") ||
         statement.predicate == Ex("enabled") ||
         (statement.predicate == RdfType() && statement.object == Ex("Rule"));
}

}  // namespace kg_core
