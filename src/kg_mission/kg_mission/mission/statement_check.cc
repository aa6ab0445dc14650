#include "kg_mission/mission/statement_check.h"

#include <algorithm>
#include <cmath>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_base/geo/wkt.h"
#include "kg_core/facts/changed_subjects.h"
#include "kg_core/facts/literals.h"
#include "kg_core/facts/terms.h"

namespace kg_mission {
namespace {

using kg_core::GraphView;
using kg_core::PropertyFacts;
using kg_core::Statement;
using kg_core::Term;
using kg_core::ToTurtle;
using kg_core::Vocabulary;

std::string Where(const Statement& statement) {
  return ToTurtle(statement.subject) + " " + ToTurtle(statement.predicate) +
         ": ";
}

std::string List(const std::vector<Term>& terms) {
  return kg_base::JoinStrings(terms, " or ",
                              [](const Term& term) { return ToTurtle(term); });
}

bool IsFiniteNumber(const Term& literal) {
  const std::optional<double> number = kg_core::NumericValue(literal);
  return number && std::isfinite(*number);
}

// xsd:double also accepts integers and decimals: 3, 0.4, 4e-1.
bool Fits(const Term& literal, const Term& datatype) {
  if (datatype == kg_core::Rdfs("Literal")) return true;
  const std::string xsd = kg_core::kXsd;
  if (datatype.text == xsd + "double") {
    return IsFiniteNumber(literal);
  }
  return literal.datatype == datatype.text && kg_core::IsWellFormed(literal);
}

std::vector<Statement> CollectStatements(const GraphView& view,
                                         const Term& subject) {
  std::vector<Statement> statements;
  kg_core::Quad pattern;
  pattern.subject = view.Find(subject);
  pattern.graph = view.Find(kg_core::Facts());
  if (pattern.subject == kg_core::kNoTerm ||
      pattern.graph == kg_core::kNoTerm) {
    return {};
  }
  view.Match(pattern, [&](const kg_core::Quad& quad) {
    statements.push_back({subject, view.Get(quad.predicate),
                          view.Get(quad.object), kg_core::Facts()});
    return true;
  });
  return statements;
}

// Types in the facts or in the vocabulary: a shipped rule has its class in the
// vocabulary, but may be a subject of facts.
std::vector<Term> ListTypes(const GraphView& view, const Term& subject) {
  std::vector<Term> types =
      kg_core::Objects(view, kg_core::kFactsGraph, subject, kg_core::RdfType());
  const bool is_shipped_rule =
      types.empty() && kg_core::Has(view, kg_core::kVocabGraph, subject,
                                    kg_core::RdfType(), kg_core::Ex("Rule"));
  if (is_shipped_rule) types.push_back(kg_core::Ex("Rule"));
  return types;
}

class SubjectCheck {
 public:
  SubjectCheck(const Vocabulary& vocabulary, const GraphView& view,
               const Term& subject)
      : vocabulary_(vocabulary),
        statements_(CollectStatements(view, subject)),
        types_(ListTypes(view, subject)),
        subject_(subject) {}

  std::vector<std::string> Run() {
    if (statements_.empty()) return {};
    if (types_.empty()) {
      reasons_.push_back(ToTurtle(subject_) +
                         ": has facts but no class (a ex:...)" + UsedHint());
    }
    for (const Term& type : types_) {
      if (!vocabulary_.HasClass(type)) {
        reasons_.push_back(ToTurtle(subject_) +
                           " a: " + vocabulary_.UnknownClass(type));
      }
    }
    for (const Statement& statement : statements_) Check(statement);
    return std::move(reasons_);
  }

 private:
  std::string UsedHint() const {
    const PropertyFacts* facts =
        vocabulary_.FindProperty(statements_.front().predicate);
    if (facts == nullptr) return "";
    return ", and " + ToTurtle(statements_.front().predicate) + " belongs to " +
           List(facts->domains);
  }

  void Check(const Statement& statement) {
    const PropertyFacts* facts = vocabulary_.FindProperty(statement.predicate);
    if (facts == nullptr) {
      reasons_.push_back(ToTurtle(subject_) + ": " +
                         vocabulary_.UnknownProperty(statement.predicate));
      return;
    }
    if (facts->is_annotation) return;
    CheckDomain(statement, *facts);
    CheckRange(statement, *facts);
  }

  void CheckDomain(const Statement& statement, const PropertyFacts& facts) {
    if (types_.empty() || facts.domains.empty()) return;
    if (vocabulary_.IsAnyOf(types_, facts.domains)) return;
    reasons_.push_back(Where(statement) + "belongs to " + List(facts.domains) +
                       ", not to " + List(types_));
  }

  void CheckRange(const Statement& statement, const PropertyFacts& facts) {
    const Term& value = statement.object;
    // The shapes check the classes of objects.
    if (!value.is_literal() && !facts.classes.empty()) return;
    if (facts.datatypes.empty()) {
      if (!value.is_literal()) return;
      reasons_.push_back(Where(statement) + "expected an instance of " +
                         List(facts.classes) + ", not " + ToTurtle(value));
      return;
    }
    const bool fits =
        value.is_literal() &&
        std::any_of(facts.datatypes.begin(), facts.datatypes.end(),
                    [&](const Term& type) { return Fits(value, type); });
    if (fits) {
      CheckWkt(statement);
      return;
    }
    reasons_.push_back(Where(statement) + "expected " + List(facts.datatypes) +
                       ", not " + ToTurtle(value));
  }

  void CheckWkt(const Statement& statement) {
    if (statement.object.datatype !=
        std::string(kg_core::kGeo) + "wktLiteral") {
      return;
    }
    try {
      kg_base::Geometry::FromWkt(statement.object.text);
    } catch (const kg_base::InputError& error) {
      reasons_.push_back(Where(statement) + error.what());
    }
  }

  const Vocabulary& vocabulary_;
  const std::vector<Statement> statements_;
  const std::vector<Term> types_;
  const Term& subject_;
  std::vector<std::string> reasons_;
};

}  // namespace

std::vector<std::string> CheckChangedSubjects(
    const Vocabulary& vocabulary, const kg_core::Transaction& transaction) {
  return CheckSubjects(vocabulary, transaction.view(),
                       kg_core::ChangedSubjects(transaction));
}

std::vector<std::string> CheckSubjects(const Vocabulary& vocabulary,
                                       const GraphView& view,
                                       const std::set<Term>& subjects) {
  std::vector<std::string> reasons;
  for (const Term& subject : subjects) {
    for (std::string& reason : SubjectCheck(vocabulary, view, subject).Run()) {
      reasons.push_back(std::move(reason));
    }
  }
  return reasons;
}

}  // namespace kg_mission
