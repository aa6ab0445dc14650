#include "kg_mission/mission/stage_update.h"

#include <algorithm>
#include <set>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/keys.h"
#include "kg_core/facts/terms.h"
#include "kg_core/facts/vocabulary.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/update_engine.h"
#include "kg_mission/mission/conclusions.h"
#include "kg_mission/mission/derived_facts.h"
#include "kg_mission/mission/ingested_facts.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/mission_rules.h"
#include "kg_mission/mission/statement_check.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

using kg_base::InputError;
using kg_core::ChangeScope;
using kg_core::Fact;
using kg_core::Facts;
using kg_core::FactUpdate;
using kg_core::ParseTurtleTerm;
using kg_core::Quad;
using kg_core::RdfType;
using kg_core::Statement;
using kg_core::Term;
using kg_core::Transaction;

constexpr std::size_t kMaxReasons = 20;

std::string Quote(const Fact& fact) {
  return fact.subject + " " + fact.property + " " + fact.value;
}

Term ParseIri(const std::string& text, const char* what) {
  const Term term = ParseTurtleTerm(text);
  if (term.is_iri()) return term;
  throw InputError(std::string("expected an IRI as ") + what + ", not " + text);
}

class UpdateStager {
 public:
  explicit UpdateStager(Transaction& transaction)
      : transaction_(transaction), vocabulary_(transaction.view()) {}

  void Apply(const FactUpdate& update) {
    if (update.replaces_facts) ClearFacts();
    for (const Fact& fact : update.remove) {
      Try("remove", fact, &UpdateStager::Remove);
    }
    for (const Fact& fact : update.set) Try("set", fact, &UpdateStager::Clear);
    if (!reasons_.empty()) return;
    for (const Fact& fact : update.set) Try("set", fact, &UpdateStager::Add);
    for (const Fact& fact : update.add) Try("add", fact, &UpdateStager::Add);
    if (!update.turtle.empty()) {
      const std::string source =
          "update" + (update.author.empty() ? "" : " of " + update.author);
      AddParsed(
          [&] { return kg_core::ParseTurtle(update.turtle, source, Facts()); });
    }
    AddParsed([&] { return update.statements; });
    if (!update.sparql.empty() && reasons_.empty()) RunSparql(update);
  }

  template <typename Parse>
  void AddParsed(Parse parse) {
    try {
      for (Statement& statement : parse()) AddStatement(std::move(statement));
    } catch (const InputError& error) {
      reasons_.push_back(error.what());
    }
  }

  // Stages derived facts and conclusions, and checks the result.
  UpdateJudgement Finish() {
    if (!reasons_.empty()) return {Reasons(), std::nullopt};
    if (transaction_.empty()) return {{}, std::vector<kg_core::Violation>()};
    Append(StageDerivedFacts(transaction_, scope_));
    if (IngestIsDue(transaction_)) DropIngestedFacts(transaction_);
    Append(CheckChangedSubjects(vocabulary_, transaction_));
    Append(StageMissionRules(transaction_));
    std::vector<kg_core::Violation> violations = ValidateChange(transaction_);
    if (reasons_.empty()) Append(kg_core::Lines(violations));
    if (reasons_.empty()) Append(kg_core::CheckKeys(transaction_));
    if (reasons_.empty()) {
      Append(CheckConclusions(vocabulary_, transaction_.view()));
    }
    if (reasons_.empty()) CheckMission();
    return {Reasons(), std::move(violations)};
  }

 private:
  void Try(const char* what, const Fact& fact,
           void (UpdateStager::*apply)(const Fact&)) {
    try {
      (this->*apply)(fact);
    } catch (const InputError& error) {
      reasons_.push_back(std::string(what) + " " + Quote(fact) + ": " +
                         error.what());
    }
  }

  Term ParseProperty(const std::string& text) const {
    const Term property = vocabulary_.Canonical(
        text == "a" ? RdfType() : ParseIri(text, "property"));
    if (vocabulary_.FindProperty(property) != nullptr) return property;
    throw InputError(vocabulary_.UnknownProperty(property));
  }

  // Removes all facts except ingested ones, which come from files, not from
  // senders.
  void ClearFacts() {
    scope_ = ChangeScope::kAll;
    const kg_core::GraphView& view = transaction_.view();
    const std::set<Term> ingested = IngestedSubjects(view);
    std::vector<Statement> statements;
    const kg_core::TermId graph = view.Find(Facts());
    if (graph == kg_core::kNoTerm) return;
    view.Match({kg_core::kNoTerm, kg_core::kNoTerm, kg_core::kNoTerm, graph},
               [&](const Quad& quad) {
                 statements.push_back({view.Get(quad.subject),
                                       view.Get(quad.predicate),
                                       view.Get(quad.object), Facts()});
                 return true;
               });
    // Remove after the scan: the view follows changes of the transaction.
    for (const Statement& statement : statements) {
      if (ingested.count(statement.subject) == 0) {
        transaction_.Remove(statement);
      }
    }
  }

  // Runs the SPARQL update; it reads the dataset of queries and writes facts
  // only.
  void RunSparql(const FactUpdate& update) {
    kg_core::UpdateGraphs graphs;
    graphs.writable = {kg_core::kFactsGraph};
    if (update.sparql_reads) graphs.read = *update.sparql_reads;
    try {
      kg_core::RunUpdate(update.sparql, graphs, {}, &transaction_);
      for (const Statement& statement : transaction_.added()) Rename(statement);
    } catch (const InputError& error) {
      reasons_.push_back(std::string("sparql: ") + error.what());
    }
  }

  // Normalizes a statement written by SPARQL like other facts.
  void Rename(const Statement& statement) {
    if (statement.graph != Facts()) return;
    transaction_.Remove(statement);
    AddStatement(statement);
  }

  // Converts plain strings to WKT if the property requires it, and alternative
  // class names to the canonical ones.
  Term Coerce(const Term& property, Term value) const {
    if (property == RdfType()) return vocabulary_.Canonical(value);
    const kg_core::PropertyFacts* facts = vocabulary_.FindProperty(property);
    const Term wkt = kg_core::GeoTerm("wktLiteral");
    if (facts == nullptr || !value.is_literal()) return value;
    if (value.datatype != std::string(kg_core::kXsd) + "string") return value;
    const auto& types = facts->datatypes;
    if (std::find(types.begin(), types.end(), wkt) == types.end()) return value;
    return kg_core::WktLiteral(std::move(value.text));
  }

  void AddStatement(Statement statement) {
    statement.predicate = vocabulary_.Canonical(statement.predicate);
    statement.object = Coerce(statement.predicate, std::move(statement.object));
    transaction_.Add(statement);
  }

  void Add(const Fact& fact) {
    const Term subject = ParseIri(fact.subject, "subject");
    const Term property = ParseProperty(fact.property);
    const Term value = ParseTurtleTerm(fact.value);
    if (value.is_blank()) {
      throw InputError("expected an IRI or a literal, not a blank node");
    }
    AddStatement({subject, property, value, Facts()});
  }

  void Clear(const Fact& fact) {
    const Term subject = ParseIri(fact.subject, "subject");
    const Term property = ParseProperty(fact.property);
    ParseTurtleTerm(fact.value);
    transaction_.RemoveMatching(&subject, &property, nullptr, Facts());
  }

  void Remove(const Fact& fact) {
    const Term subject = ParseIri(fact.subject, "subject");
    if (fact.property.empty() && !fact.value.empty()) {
      throw InputError("expected a property, or neither property nor value");
    }
    std::optional<Term> property, value;
    if (!fact.property.empty()) property = ParseProperty(fact.property);
    if (!fact.value.empty()) {
      value = Coerce(*property, ParseTurtleTerm(fact.value));
    }
    if (!Matches(subject, property, value)) {
      throw InputError("there is no such fact");
    }
    transaction_.RemoveMatching(&subject, property ? &*property : nullptr,
                                value ? &*value : nullptr, Facts());
  }

  bool Matches(const Term& subject, const std::optional<Term>& property,
               const std::optional<Term>& value) const {
    const kg_core::GraphView& view = transaction_.view();
    Quad pattern;
    pattern.subject = view.Find(subject);
    pattern.graph = view.Find(Facts());
    if (property) pattern.predicate = view.Find(*property);
    if (value) pattern.object = view.Find(*value);
    if (pattern.subject == kg_core::kNoTerm ||
        pattern.graph == kg_core::kNoTerm ||
        (property && pattern.predicate == kg_core::kNoTerm) ||
        (value && pattern.object == kg_core::kNoTerm)) {
      return false;
    }
    bool found = false;
    view.Match(pattern, [&](const Quad&) {
      found = true;
      return false;
    });
    return found;
  }

  bool HadMission() const {
    const auto is_mission = [](const Statement& statement) {
      return statement.graph == Facts() && statement.predicate == RdfType() &&
             statement.object == kg_core::Ex("Mission");
    };
    const std::vector<Statement> removed = transaction_.removed();
    return std::any_of(removed.begin(), removed.end(), is_mission);
  }

  // Reads the mission to check it; skipped if there is none before and after
  // the update.
  void CheckMission() {
    const bool has_mission =
        !kg_core::FindInstances(transaction_.view(), kg_core::kFactsGraph,
                                kg_core::Ex("Mission"))
             .empty();
    if (!has_mission && !HadMission()) return;
    try {
      ReadMission(transaction_.view());
    } catch (const InputError& error) {
      reasons_.push_back(error.what());
    }
  }

  void Append(std::vector<std::string> more) {
    for (std::string& reason : more) reasons_.push_back(std::move(reason));
  }

  // The reasons in the order found, without duplicates, up to a maximum number.
  std::vector<std::string> Reasons() {
    std::set<std::string> seen;
    std::vector<std::string> once;
    for (std::string& reason : reasons_) {
      if (seen.insert(reason).second) once.push_back(std::move(reason));
    }
    if (once.size() > kMaxReasons) {
      const std::size_t left = once.size() - kMaxReasons;
      once.resize(kMaxReasons);
      once.push_back("and " + std::to_string(left) + " more");
    }
    return once;
  }

  Transaction& transaction_;
  const kg_core::Vocabulary vocabulary_;
  ChangeScope scope_ = ChangeScope::kChanged;
  std::vector<std::string> reasons_;
};

}  // namespace

UpdateJudgement JudgeUpdate(const FactUpdate& update,
                            Transaction& transaction) {
  UpdateStager stager(transaction);
  stager.Apply(update);
  return stager.Finish();
}

std::vector<std::string> StageUpdate(const FactUpdate& update,
                                     Transaction& transaction) {
  return JudgeUpdate(update, transaction).reasons;
}

std::vector<std::string> StageFactsFile(const std::string& path,
                                        Transaction& transaction) {
  UpdateStager stager(transaction);
  stager.AddParsed([&] { return kg_core::ParseTurtleFile(path, Facts()); });
  return stager.Finish().reasons;
}

}  // namespace kg_mission
