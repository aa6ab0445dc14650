// Recursive descent parser behind ParseQuery; its rules are in parser.cc (query
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

class SparqlGrammar {
 public:
  SparqlGrammar(std::vector<Token> tokens, int nesting);
  Query ReadQuery();
  UpdateRequest ReadUpdate();

 private:
  // A group graph pattern and the filters that apply to the whole group.
  struct Group {
    GraphPattern pattern;
    std::vector<Expression> filters;
  };
  // Scope guard for one level of bracket nesting.
  class Nested {
   public:
    explicit Nested(SparqlGrammar* grammar);
    ~Nested() { --grammar_->depth_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;

   private:
    SparqlGrammar* grammar_;
  };

  // Query forms (parser.cc).
  void ReadPrologue();
  void RefuseOtherForms();
  void ReadDatasetClauses();
  void ReadSelect(SelectQuery* select);  // From SELECT to its end.
  bool ReadSelectClause(SelectQuery* select);
  SelectColumn ReadAliased();  // expression AS ?v ')'
  void ReadWhere(SelectQuery* select);
  void ReadModifiers(SelectQuery* select);
  void ReadModifiersOfForm();
  void AddColumn(int variable, SelectQuery* select);
  void AddColumns(const VariableSet& variables, SelectQuery* select);
  std::vector<int> NamedMembers(const VariableSet& variables) const;
  void ReadGroupBy(SelectQuery* select);
  int ReadKeyName(const SelectQuery& select);  // After AS.
  void ReadHaving(SelectQuery* select);
  void ReadOrderBy(SelectQuery* select);
  void ReadLimits(SelectQuery* select);
  void CheckColumns(const SelectQuery& select, QueryPosition position);
  std::size_t ReadCount();

  // Templates: CONSTRUCT and DESCRIBE (parse_template.cc).

  // Kinds of terms allowed in a template, and its name in error messages.
  struct TemplateRules {
    bool active = false;
    bool variables = true;
    bool blank_nodes = true;
    const char* name = "a template";
  };
  void ReadConstruct();
  void ReadDescribe();
  GraphPattern ReadTemplateTriples(const TemplateRules& rules);
  void AddTemplateColumns(const std::vector<QuadTemplate>& templates);
  std::vector<QuadTemplate> ReadQuads(const TemplateRules& rules);
  void ReadQuadTriples(const VarOrTerm& graph,
                       std::vector<QuadTemplate>* quads);

  // Updates (parse_update.cc).
  UpdateOperation ReadOperation();
  void BeginOperation();
  bool ReadGraphOperation(UpdateOperation* operation);
  GraphRef ReadGraphRef(UpdateOperation::Kind kind);
  void ReadInsertData(UpdateOperation* operation);
  void ReadDeleteWhere(UpdateOperation* operation);
  void ReadModify(UpdateOperation* operation);
  void ReadUsing();
  void CheckBlankAllowed() const;

  // Patterns (parse_pattern.cc).
  Group ReadGroup();
  GraphPattern ReadGroupPattern();
  void ReadGroupElement(Group* group, GraphPattern* basic);
  GraphPattern ReadGroupOrUnion();
  GraphPattern ReadGraph();
  GraphPattern ReadService();
  GraphPattern ReadMinus(GraphPattern left);
  GraphPattern ReadOptional(GraphPattern left);
  void ReadBind(Group* group);
  GraphPattern ReadValues();
  int ReadValuesName(const std::vector<int>& known);
  std::vector<int> ReadValuesRow(std::size_t width);
  int ReadDataValue();
  GraphPattern Join(GraphPattern left, GraphPattern right);
  void CountPattern();

  // Triples and paths (parse_triples.cc).
  bool AtTriples() const;
  void ReadTriplesBlock(GraphPattern* basic);
  void ReadPropertyList(const VarOrTerm& subject, GraphPattern* basic,
                        bool required);
  void ReadObjects(const VarOrTerm& subject, const PropertyPath* path,
                   const VarOrTerm& verb, GraphPattern* basic);
  VarOrTerm ReadGraphNode(GraphPattern* basic);
  VarOrTerm ReadBlankProperties(GraphPattern* basic);
  VarOrTerm ReadCollection(GraphPattern* basic);
  void AddTriple(const VarOrTerm& subject, const VarOrTerm& predicate,
                 const VarOrTerm& object, GraphPattern* basic);
  void AddPath(const VarOrTerm& subject, const PropertyPath& path,
               const VarOrTerm& object, GraphPattern* basic);
  bool AtPath() const;
  PropertyPath ReadPath();
  PropertyPath ReadPathSequence();
  PropertyPath ReadPathStep();
  PropertyPath ReadPathPrimary();
  PropertyPath ReadNegatedSet();
  PropertyPath ReadNegatedLink();
  bool AtTerm() const;
  VarOrTerm ReadVariableOrTerm();

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
  Expression ReadAggregate(AggregateCall::Kind kind);
  Expression ReadIriExpression();
  Expression ReadCall(const SparqlFunction& function, QueryPosition position);
  Expression ReadSpecialForm(Expression::Op op, std::size_t least,
                             std::size_t most);
  std::vector<Expression> ReadArguments();
  void ReadSeparator(AggregateCall* aggregate);

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
  VarOrTerm BlankNode(const std::string& label);
  int ConstantNumber(const Term& term);
  VarOrTerm ConstantNode(const Term& term);
  [[noreturn]] void Fail(const Token& token, const std::string& what) const;
  [[noreturn]] void FailAt(QueryPosition position,
                           const std::string& what) const;
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
  std::map<std::string, int> block_of_label_;  // Blank node labels.
  // Blank node labels of INSERT DATA.
  std::map<std::string, int> block_of_data_label_;
  int block_ = 0;   // Number of the basic graph pattern being read.
  int blocks_ = 0;  // Basic graph patterns so far.
  // The query that collects aggregates; nullptr where none are allowed.
  SelectQuery* aggregates_of_ = nullptr;
  TemplateRules template_;  // Rules of the template being read.
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_GRAMMAR_H_
