// The recursive descent behind ParseQuery; its rules are in parser.cc (query
// forms), parse_update.cc, parse_template.cc, parse_pattern.cc,
// parse_triples.cc and parse_expression.cc, each with its number in
// https://www.w3.org/TR/sparql11-query/#sparqlGrammar.

#ifndef KG_CORE_SPARQL_GRAMMAR_H_
#define KG_CORE_SPARQL_GRAMMAR_H_

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kg_core/sparql/algebra.h"
#include "kg_core/sparql/query.h"
#include "kg_core/sparql/token.h"
#include "kg_core/sparql/update.h"

namespace kg_core::sparql {

class Grammar {
 public:
  Grammar(std::vector<Token> tokens, int nesting);
  Query ReadQuery();
  Update ReadUpdate();

 private:
  // A group and the filters that hold for all of it.
  struct Group {
    Pattern pattern;
    std::vector<Expression> filters;
  };
  // A bracket that has been opened; closes when it goes out of scope.
  class Nested {
   public:
    explicit Nested(Grammar* grammar);
    ~Nested() { --grammar_->depth_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;

   private:
    Grammar* grammar_;
  };

  // Query forms (parser.cc).
  void ReadPrologue();
  void RefuseOtherForms();
  void ReadDatasetClauses();
  void ReadSelect(Select* select);  // From SELECT to its end.
  bool ReadSelectClause(Select* select);
  Column ReadAliased();  // expression AS ?v ')'
  void ReadWhere(Select* select);
  void ReadModifiers(Select* select);
  void ReadModifiersOfForm();
  void AddColumns(const VariableSet& variables, Select* select);
  void ReadGroupBy(Select* select);
  void ReadHaving(Select* select);
  void ReadOrderBy(Select* select);
  void ReadLimits(Select* select);
  void CheckColumns(const Select& select, Position position);
  std::size_t ReadCount();

  // Templates: CONSTRUCT and DESCRIBE (parse_template.cc).
  // What a template may not have, and what a refusal calls the template.
  struct TemplateRules {
    bool active = false;
    bool variables = true;
    bool blank_nodes = true;
    const char* name = "a template";
  };
  void ReadConstruct();
  void ReadDescribe();
  Pattern ReadTemplateTriples(const TemplateRules& rules);
  void AddTemplateColumns(const std::vector<QuadTemplate>& templates);
  std::vector<QuadTemplate> ReadQuads(const TemplateRules& rules);
  void ReadQuadTriples(const Node& graph, std::vector<QuadTemplate>* quads);

  // Updates (parse_update.cc).
  Operation ReadOperation();
  void BeginOperation();
  bool ReadGraphOperation(Operation* operation);
  GraphRef ReadGraphRef(Operation::Kind kind);
  void ReadInsertData(Operation* operation);
  void ReadDeleteWhere(Operation* operation);
  void ReadModify(Operation* operation);
  void ReadUsing();
  void CheckBlankAllowed() const;

  // Patterns (parse_pattern.cc).
  Group ReadGroup();
  Pattern ReadGroupPattern();
  void ReadGroupElement(Group* group, Pattern* basic);
  Pattern ReadGroupOrUnion();
  Pattern ReadGraph();
  Pattern ReadService();
  Pattern ReadMinus(Pattern left);
  Pattern ReadOptional(Pattern left);
  void ReadBind(Group* group);
  Pattern ReadValues();
  std::vector<int> ReadValuesRow(std::size_t width);
  int ReadDataValue();
  Pattern Join(Pattern left, Pattern right);
  void CountPattern();

  // Triples and paths (parse_triples.cc).
  bool AtTriples() const;
  void ReadTriplesBlock(Pattern* basic);
  void ReadPropertyList(const Node& subject, Pattern* basic, bool required);
  void ReadObjects(const Node& subject, const Path* path, const Node& verb,
                   Pattern* basic);
  Node ReadGraphNode(Pattern* basic);
  Node ReadBlankProperties(Pattern* basic);
  Node ReadCollection(Pattern* basic);
  void AddTriple(const Node& subject, const Node& predicate, const Node& object,
                 Pattern* basic);
  void AddPath(const Node& subject, const Path& path, const Node& object,
               Pattern* basic);
  bool AtPath() const;
  Path ReadPath();
  Path ReadPathSequence();
  Path ReadPathStep();
  Path ReadPathPrimary();
  Path ReadNegatedSet();
  Path ReadNegatedLink();
  bool AtTerm() const;
  Node ReadVariableOrTerm();

  // Expressions (parse_expression.cc).
  Expression ReadExpression();
  Expression ReadAnd();
  Expression ReadRelational();
  Expression ReadAdditive();
  Expression ReadMultiplicative();
  Expression ReadUnary();
  Expression ReadPrimary();
  Expression ReadBracketed();
  Expression ReadConstraint();
  Expression ReadWordExpression();
  Expression ReadExists(Expression::Op op);
  Expression ReadAggregate(Aggregate::Kind kind);
  Expression ReadIriExpression();
  Expression ReadCall(const Function& function, Position position);
  Expression ReadSpecialForm(Expression::Op op, std::size_t least,
                             std::size_t most);
  std::vector<Expression> ReadArguments();
  void ReadSeparator(Aggregate* aggregate);

  // Tokens and names (grammar.cc).
  const Token& Peek(std::size_t ahead = 0) const;
  Token Take();
  bool AtWord(std::string_view word, std::size_t ahead = 0) const;
  bool AtMark(std::string_view mark, std::size_t ahead = 0) const;
  bool TakeWord(std::string_view word);
  bool TakeMark(std::string_view mark);
  void ExpectWord(std::string_view word);
  void ExpectMark(std::string_view mark);
  bool AtIri() const;
  std::string ReadIri();
  Term ReadLiteral();
  bool AtLiteral() const;
  int ReadVariable();
  int VariableNumber(const std::string& name);
  int FreshVariable();
  Node BlankNode(const std::string& label);
  int ConstantNumber(const Term& term);
  Node ConstantNode(const Term& term);
  [[noreturn]] void Fail(const Token& token, const std::string& what) const;
  [[noreturn]] void FailAt(Position position, const std::string& what) const;
  [[noreturn]] void Expected(const std::string& what) const;

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int nesting_;
  int depth_ = 0;
  int patterns_ = 0;
  Query query_;
  std::map<std::string, std::string> prefixes_;
  std::map<std::string, int> variable_numbers_;
  std::map<std::string, int> constant_numbers_;
  std::map<std::string, int> block_of_label_;       // Blank node labels.
  std::map<std::string, int> block_of_data_label_;  // In INSERT DATA.
  int block_ = 0;   // The basic graph pattern being read ...
  int blocks_ = 0;  // ... of so many so far.
  // Where aggregates go; nullptr where none may stand.
  Select* aggregates_of_ = nullptr;
  TemplateRules template_;  // Of the template being read.
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_GRAMMAR_H_
