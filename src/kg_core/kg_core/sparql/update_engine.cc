#include "kg_core/sparql/update_engine.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_core/base/limit_error.h"
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
using sparql::Operation;
using Statements = std::vector<Statement>;

bool IsBefore(const Statement& a, const Statement& b) {
  return std::tie(a.graph, a.subject, a.predicate, a.object) <
         std::tie(b.graph, b.subject, b.predicate, b.object);
}

// `a` without `b`; both in the order of Transaction::added().
Statements Without(const Statements& a, const Statements& b) {
  Statements left;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(),
                      std::back_inserter(left), IsBefore);
  return left;
}

// Takes a transaction back to where it was when this was made.
class Rollback {
 public:
  explicit Rollback(Transaction* change)
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

[[noreturn]] void Refuse(const Operation& operation, const std::string& why) {
  throw InputError(std::to_string(operation.position.line) + ":" +
                   std::to_string(operation.position.column) + ": " + why);
}

class Updater {
 public:
  Updater(const UpdateGraphs& graphs, const QueryLimits& limits,
          Transaction* change)
      : graphs_(graphs), limits_(limits), budget_(limits), change_(change) {}

  void Run(const Operation& operation);

 private:
  // The quads of one operation, by ids of its term table.
  struct Quads {
    std::vector<Quad> removed;
    std::vector<Quad> added;
  };

  void Modify(const Operation& operation);
  Quads Solve(const Operation& operation, sparql::TermTable* terms);
  void Clear(const Operation& operation);
  void Create(const Operation& operation);
  void Transfer(const Operation& operation);
  void Replace(const std::string& target, const Statements& with);

  std::string NameOf(const GraphRef& graph) const {
    return graph.kind == GraphRef::Kind::kIri ? graph.iri
                                              : graphs_.default_graph;
  }
  bool Exists(const GraphRef& graph) const {
    return graph.kind != GraphRef::Kind::kIri ||
           graph.iri == graphs_.default_graph ||
           sparql::HasGraph(change_->view(), graph.iri);
  }
  std::set<std::string> GraphsOf(const GraphRef& graph);
  Statements ContentOf(const std::string& graph);
  void CheckWritable(const Operation& operation,
                     const std::string& graph) const;
  void Count(std::size_t quads) const;

  const UpdateGraphs& graphs_;
  const QueryLimits& limits_;
  sparql::Budget budget_;
  Transaction* change_;
};

void Updater::Run(const Operation& operation) {
  switch (operation.kind) {
    case Operation::Kind::kModify:
      return Modify(operation);
    case Operation::Kind::kClear:
    case Operation::Kind::kDrop:
      return Clear(operation);
    case Operation::Kind::kCreate:
      return Create(operation);
    case Operation::Kind::kCopy:
    case Operation::Kind::kMove:
    case Operation::Kind::kAdd:
      return Transfer(operation);
    case Operation::Kind::kLoad:
      if (operation.silent) return;
      Refuse(operation,
             "LOAD is not available: an update reads this store only");
  }
}

void Updater::CheckWritable(const Operation& operation,
                            const std::string& graph) const {
  if (!graphs_.writable) return;
  const std::vector<std::string>& writable = *graphs_.writable;
  if (std::find(writable.begin(), writable.end(), graph) != writable.end()) {
    return;
  }
  Refuse(operation,
         "graph " + AbbreviateIri(graph) + " may not be changed by an update");
}

void Updater::Count(std::size_t quads) const {
  if (quads <= limits_.rows) return;
  throw LimitError("the update changes more quads than the limit of " +
                   std::to_string(limits_.rows));
}

// https://www.w3.org/TR/sparql11-update/#deleteInsert: first all is matched,
// then removed, then added.
void Updater::Modify(const Operation& operation) {
  sparql::TermTable terms(&change_->view(), &budget_);
  const Quads quads = Solve(operation, &terms);
  const std::string& own =
      operation.with ? *operation.with : graphs_.default_graph;
  const auto statement = [&](const Quad& quad) {
    const Term graph = quad.graph == kNoTerm ? Iri(own) : terms.Get(quad.graph);
    CheckWritable(operation, graph.text);
    budget_.Step();
    return Statement{terms.Get(quad.subject), terms.Get(quad.predicate),
                     terms.Get(quad.object), graph};
  };
  for (const Quad& quad : quads.removed) change_->Remove(statement(quad));
  for (const Quad& quad : quads.added) change_->Add(statement(quad));
}

Updater::Quads Updater::Solve(const Operation& operation,
                              sparql::TermTable* terms) {
  Dataset dataset = graphs_.read;
  if (operation.with) dataset.default_graphs = {*operation.with};
  const sparql::Query& query = operation.query;
  sparql::Evaluator evaluator(&query, terms,
                              sparql::Resolve(query, dataset, terms), &budget_);
  sparql::Instantiator instantiator(&query, terms);
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

// The names of the graphs meant, of those that have quads.
std::set<std::string> Updater::GraphsOf(const GraphRef& graph) {
  const bool many = graph.kind == GraphRef::Kind::kNamed ||
                    graph.kind == GraphRef::Kind::kAll;
  if (!many) return {NameOf(graph)};
  const GraphView& view = change_->view();
  std::set<TermId> ids;
  view.Match({}, [&](const Quad& quad) {
    budget_.Step();
    ids.insert(quad.graph);
    return true;
  });
  std::set<std::string> names;
  for (const TermId id : ids) names.insert(view.Get(id).text);
  if (graph.kind == GraphRef::Kind::kNamed) names.erase(graphs_.default_graph);
  return names;
}

// https://www.w3.org/TR/sparql11-update/#clear, #drop
void Updater::Clear(const Operation& operation) {
  for (const std::string& graph : GraphsOf(operation.target)) {
    CheckWritable(operation, graph);
    Replace(graph, {});
  }
}

// https://www.w3.org/TR/sparql11-update/#create
void Updater::Create(const Operation& operation) {
  if (operation.silent || !Exists(operation.target)) return;
  Refuse(operation, "CREATE: there is a graph " +
                        AbbreviateIri(operation.target.iri) + " already");
}

Statements Updater::ContentOf(const std::string& graph) {
  const GraphView& view = change_->view();
  Statements statements;
  const TermId id = view.Find(Iri(graph));
  if (id == kNoTerm) return statements;
  view.Match({kNoTerm, kNoTerm, kNoTerm, id}, [&](const Quad& quad) {
    budget_.Step();
    budget_.UseWorkingBytes(sizeof(Statement));
    statements.push_back({view.Get(quad.subject), view.Get(quad.predicate),
                          view.Get(quad.object), Iri(graph)});
    Count(statements.size());
    return true;
  });
  return statements;
}

void Updater::Replace(const std::string& target, const Statements& with) {
  change_->RemoveMatching(nullptr, nullptr, nullptr, Iri(target));
  for (const Statement& statement : with) change_->Add(statement);
}

// https://www.w3.org/TR/sparql11-update/#copy, #move, #add
void Updater::Transfer(const Operation& operation) {
  const std::string source = NameOf(operation.source);
  const std::string target = NameOf(operation.target);
  if (!Exists(operation.source)) {
    if (operation.silent) return;
    Refuse(operation, "the store has no graph " + AbbreviateIri(source));
  }
  if (source == target) return;
  CheckWritable(operation, target);
  Statements content = ContentOf(source);
  for (Statement& statement : content) {
    budget_.Step();
    statement.graph = Iri(target);
  }
  if (operation.kind == Operation::Kind::kAdd) {
    for (const Statement& statement : content) change_->Add(statement);
    return;
  }
  Replace(target, content);
  if (operation.kind != Operation::Kind::kMove) return;
  CheckWritable(operation, source);
  Replace(source, {});
}

// What can be refused before anything is done.
sparql::Update Parse(std::string_view text, const QueryLimits& limits) {
  if (text.size() > limits.text_bytes) {
    throw LimitError("the update is longer than the limit of " +
                     std::to_string(limits.text_bytes) + " bytes");
  }
  sparql::Update update = sparql::ParseUpdate(text, limits.nesting);
  for (Operation& operation : update.operations) {
    const std::string& unknown = operation.query.unavailable;
    if (!unknown.empty()) throw InputError(unknown);
    sparql::Prepare(&operation.query.select);
  }
  return update;
}

}  // namespace

void RunUpdate(std::string_view text, const UpdateGraphs& graphs,
               const QueryLimits& limits, Transaction* change) {
  const sparql::Update update = Parse(text, limits);
  Updater updater(graphs, limits, change);
  Rollback rollback(change);
  try {
    for (const Operation& operation : update.operations) updater.Run(operation);
  } catch (...) {
    rollback.Run();
    throw;
  }
}

}  // namespace kg_core
