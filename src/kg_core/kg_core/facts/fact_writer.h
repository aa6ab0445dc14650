// Builder for statements about a sequence of subjects in one graph, including
// PROV-O activities. https://www.w3.org/TR/prov-o/
//
//   FactWriter write(Iri(kProvGraph));
//   write.Activity(run, "PlanRun", begin_s, end_s).Integer("rounds", 2);
//   write.AddTo(transaction);

#ifndef KG_CORE_FACTS_FACT_WRITER_H_
#define KG_CORE_FACTS_FACT_WRITER_H_

#include <string>
#include <utility>
#include <vector>

#include "kg_core/facts/literals.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/store.h"

namespace kg_core {

class FactWriter {
 public:
  explicit FactWriter(Term graph) : graph_(std::move(graph)) {}

  // The statements that follow are about `subject`.
  FactWriter& About(const Term& subject) {
    subject_ = subject;
    return *this;
  }
  FactWriter& About(const Term& subject, const std::string& type) {
    return About(subject).Add(RdfType(), Ex(type));
  }
  FactWriter& Add(const Term& property, const Term& value) {
    statements_.push_back({subject_, property, value, graph_});
    return *this;
  }
  FactWriter& Integer(const std::string& name, long long value) {
    return Add(Ex(name), IntegerLiteral(value));
  }
  FactWriter& Text(const std::string& name, const std::string& value) {
    return Add(Ex(name), Literal(value));
  }
  FactWriter& Link(const std::string& name, const Term& value) {
    return Add(Ex(name), value);
  }
  FactWriter& Time(const Term& property, double time_s) {
    return Add(property, DateTimeLiteral(time_s));
  }

  // Adds a prov:Activity of a class in ex:, with start and end time.
  FactWriter& Activity(const Term& subject, const std::string& type,
                       double started_s, double ended_s) {
    return About(subject, type)
        .Add(RdfType(), Prov("Activity"))
        .Time(Prov("startedAtTime"), started_s)
        .Time(Prov("endedAtTime"), ended_s);
  }
  FactWriter& Used(const Term& entity) { return Add(Prov("used"), entity); }

  // Stages all statements in the order in which they were added.
  void AddTo(Transaction& transaction) {
    for (const Statement& statement : statements_) transaction.Add(statement);
    statements_.clear();
  }

 private:
  Term graph_;
  Term subject_;
  std::vector<Statement> statements_;
};

}  // namespace kg_core

#endif  // KG_CORE_FACTS_FACT_WRITER_H_
