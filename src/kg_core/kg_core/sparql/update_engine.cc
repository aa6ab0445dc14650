#include "kg_core/sparql/update_engine.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/limit_error.h"
#include "kg_core/sparql/algebra.h"
#include "kg_core/sparql/budget.h"
#include "kg_core/sparql/construct.h"
#include "kg_core/sparql/evaluator.h"
#include "kg_core/sparql/parser.h"
#include "kg_core/sparql/resolve_dataset.h"
#include "kg_core/sparql/term_table.h"
#include "kg_core/sparql/update.h"

namespace kg_core {
namespace {

using sparql::GraphRef;
using sparql::UpdateOperation;
using Statements = std::vector<Statement>;

bool IsBefore(const Statement& a, const Statement& b) {
  return std::tie(a.graph, a.subject, a.predicate, a.object) <
         std::tie(b.graph, b.subject, b.predicate, b.object);
}

// Set difference a - b; both in the order of Transaction::added().
Statements Without(const Statements& a, const Statements& b) {
  Statements left;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(),
                      std::back_inserter(left), IsBefore);
  return left;
}

// Rolls a transaction back to its state at construction.
class TransactionRollback {
 public:
  explicit TransactionRollback(Transaction* change)
      : change_(change), added_(change->added()), removed_(change->removed()) {}

  void Run() {
    const Statements added = change_->added();
    const Statements removed = change_->removed();
    for (const Statement& s : Without(added, added_)) change_->Remove(s);
    for (const Statement& s : Without(removed, removed_)) change_->Add(s);
    for (const Statement& s : Without(added_, added)) change_->Add(s);
    for (const Statement& s : Without(removed_, removed)) change_->Remove(s);
  }

 private:
  Transaction* change_;
  const Statements added_;
  const Statements removed_;
};

[[noreturn]] void Refuse(const UpdateOperation& operation,
                         const std::string& why) {
  throw kg_base::InputError(std::to_string(operation.position.line) + ":" +
                            std::to_string(operation.position.column) + ": " +
                            why);
}

class UpdateRunner {
 public:
  UpdateRunner(const UpdateGraphs& graphs, const QueryLimits& limits,
               Transaction* change)
      : graphs_(graphs), limits_(limits), budget_(limits), change_(change) {}

  void Run(const UpdateOperation& operation);

 private:
  // The quads of one operation, as ids of its term table.
  struct Quads {
    std::vector<Quad> removed;
    std::vector<Quad> added;
  };

  void Modify(const UpdateOperation& operation);
  Quads Solve(const UpdateOperation& operation, sparql::TermTable* terms);
  void Clear(const UpdateOperation& operation);
  void Create(const UpdateOperation& operation);
  void Transfer(const UpdateOperation& operation);
  void Replace(const std::string& target, const Statements& with);

  std::string GetName(const GraphRef& graph) const {
    return graph.kind == GraphRef::Kind::kIri ? graph.iri
                                              : graphs_.default_graph;
  }
  bool Exists(const GraphRef& graph) const {
    return graph.kind != GraphRef::Kind::kIri ||
           graph.iri == graphs_.default_graph ||
           sparql::HasGraph(change_->view(), graph.iri);
  }
  std::set<std::string> ListGraphs(const GraphRef& graph);
  Statements GetContent(const std::string& graph);
  void CheckWritable(const UpdateOperation& operation,
                     const std::string& graph) const;
  void Count(std::size_t quads) const;

  const UpdateGraphs& graphs_;
  const QueryLimits& limits_;
  sparql::QueryBudget budget_;
  Transaction* change_;
};

void UpdateRunner::Run(const UpdateOperation& operation) {
  switch (operation.kind) {
    case UpdateOperation::Kind::kModify:
      return Modify(operation);
    case UpdateOperation::Kind::kClear:
    case UpdateOperation::Kind::kDrop:
      return Clear(operation);
    case UpdateOperation::Kind::kCreate:
      return Create(operation);
    case UpdateOperation::Kind::kCopy:
    case UpdateOperation::Kind::kMove:
    case UpdateOperation::Kind::kAdd:
      return Transfer(operation);
    case UpdateOperation::Kind::kLoad:
      if (operation.silent) return;
      Refuse(operation,
             "LOAD is not available: an update reads this store only");
  }
}

void UpdateRunner::CheckWritable(const UpdateOperation& operation,
                                 const std::string& graph) const {
  if (!graphs_.writable) return;
  const std::vector<std::string>& writable = *graphs_.writable;
  if (std::find(writable.begin(), writable.end(), graph) != writable.end()) {
    return;
  }
  Refuse(operation, "graph " + ToTurtle(GraphFromName(graph)) +
                        " may not be changed by an update");
}

void UpdateRunner::Count(std::size_t quads) const {
  if (quads <= limits_.rows) return;
  throw kg_base::LimitError("the update changes more quads than the limit of " +
                            std::to_string(limits_.rows));
}

// https://www.w3.org/TR/sparql11-update/#deleteInsert: first all solutions are
// found, then quads are removed, then added.
void UpdateRunner::Modify(const UpdateOperation& operation) {
  sparql::TermTable terms(&change_->view(), &budget_);
  const Quads quads = Solve(operation, &terms);
  const std::string& own =
      operation.with ? *operation.with : graphs_.default_graph;
  const auto statement = [&](const Quad& quad) {
    const Term graph = quad.graph == kNoTerm ? Iri(own) : terms.Get(quad.graph);
    CheckWritable(operation, ToGraphName(graph));
    budget_.Step();
    return Statement{terms.Get(quad.subject), terms.Get(quad.predicate),
                     terms.Get(quad.object), graph};
  };
  for (const Quad& quad : quads.removed) change_->Remove(statement(quad));
  for (const Quad& quad : quads.added) change_->Add(statement(quad));
}

UpdateRunner::Quads UpdateRunner::Solve(const UpdateOperation& operation,
                                        sparql::TermTable* terms) {
  Dataset dataset = graphs_.read;
  if (operation.with) dataset.default_graphs = {*operation.with};
  const sparql::Query& query = operation.query;
  sparql::PatternEvaluator evaluator(
      &query, terms, sparql::Resolve(query, dataset, terms), &budget_);
  sparql::TemplateInstantiator instantiator(&query, terms);
  // Find all solutions before anything changes.
  Quads quads;
  const auto into = [&](std::vector<Quad>* list) {
    return [this, &quads, list](const Quad& quad) {
      budget_.UseWorkingBytes(2 * sizeof(Quad));
      list->push_back(quad);
      Count(quads.removed.size() + quads.added.size());
    };
  };
  evaluator.Run([&](sparql::Row& row) {
    instantiator.Run(operation.removed, row, into(&quads.removed));
    instantiator.Run(operation.added, row, into(&quads.added));
    return true;
  });
  return quads;
}

// The names of the graphs referred to that have quads.
std::set<std::string> UpdateRunner::ListGraphs(const GraphRef& graph) {
  const bool many = graph.kind == GraphRef::Kind::kNamed ||
                    graph.kind == GraphRef::Kind::kAll;
  if (!many) return {GetName(graph)};
  const GraphView& view = change_->view();
  std::set<TermId> ids;
  view.Match({}, [&](const Quad& quad) {
    budget_.Step();
    ids.insert(quad.graph);
    return true;
  });
  std::set<std::string> names;
  for (const TermId id : ids) names.insert(ToGraphName(view.Get(id)));
  if (graph.kind == GraphRef::Kind::kNamed) names.erase(graphs_.default_graph);
  return names;
}

// https://www.w3.org/TR/sparql11-update/#clear, #drop
void UpdateRunner::Clear(const UpdateOperation& operation) {
  for (const std::string& graph : ListGraphs(operation.target)) {
    CheckWritable(operation, graph);
    Replace(graph, {});
  }
}

// https://www.w3.org/TR/sparql11-update/#create
void UpdateRunner::Create(const UpdateOperation& operation) {
  if (operation.silent || !Exists(operation.target)) return;
  Refuse(operation, "CREATE: there is a graph " +
                        AbbreviateIri(operation.target.iri) + " already");
}

Statements UpdateRunner::GetContent(const std::string& graph) {
  const GraphView& view = change_->view();
  Statements statements;
  const TermId id = view.Find(GraphFromName(graph));
  if (id == kNoTerm) return statements;
  view.Match({kNoTerm, kNoTerm, kNoTerm, id}, [&](const Quad& quad) {
    budget_.Step();
    budget_.UseWorkingBytes(sizeof(Statement));
    statements.push_back({view.Get(quad.subject), view.Get(quad.predicate),
                          view.Get(quad.object), GraphFromName(graph)});
    Count(statements.size());
    return true;
  });
  return statements;
}

void UpdateRunner::Replace(const std::string& target, const Statements& with) {
  change_->RemoveMatching(nullptr, nullptr, nullptr, GraphFromName(target));
  for (const Statement& statement : with) change_->Add(statement);
}

// https://www.w3.org/TR/sparql11-update/#copy, #move, #add
void UpdateRunner::Transfer(const UpdateOperation& operation) {
  const std::string source = GetName(operation.source);
  const std::string target = GetName(operation.target);
  if (!Exists(operation.source)) {
    if (operation.silent) return;
    Refuse(operation, "the store has no graph " + AbbreviateIri(source));
  }
  if (source == target) return;
  CheckWritable(operation, target);
  Statements content = GetContent(source);
  for (Statement& statement : content) {
    budget_.Step();
    statement.graph = Iri(target);
  }
  // ADD keeps the content of the target, COPY and MOVE replace it.
  if (operation.kind == UpdateOperation::Kind::kAdd) {
    for (const Statement& statement : content) change_->Add(statement);
    return;
  }
  Replace(target, content);
  if (operation.kind != UpdateOperation::Kind::kMove) return;
  CheckWritable(operation, source);
  Replace(source, {});
}

// Parses the request and rejects what can be rejected before execution.
sparql::UpdateRequest Parse(std::string_view text, const QueryLimits& limits) {
  if (text.size() > limits.text_bytes) {
    throw kg_base::LimitError("the update is longer than the limit of " +
                              std::to_string(limits.text_bytes) + " bytes");
  }
  sparql::UpdateRequest update = sparql::ParseUpdate(text, limits.nesting);
  for (UpdateOperation& operation : update.operations) {
    const std::string& unknown = operation.query.unavailable;
    if (!unknown.empty()) throw kg_base::InputError(unknown);
    sparql::Prepare(&operation.query.select);
  }
  return update;
}

}  // namespace

void RunUpdate(std::string_view text, const UpdateGraphs& graphs,
               const QueryLimits& limits, Transaction* change) {
  const sparql::UpdateRequest update = Parse(text, limits);
  UpdateRunner updater(graphs, limits, change);
  TransactionRollback rollback(change);
  try {
    for (const UpdateOperation& operation : update.operations) {
      updater.Run(operation);
    }
  } catch (...) {
    rollback.Run();
    throw;
  }
}

}  // namespace kg_core
