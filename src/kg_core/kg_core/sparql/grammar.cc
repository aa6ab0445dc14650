#include "kg_core/sparql/grammar.h"

#include <algorithm>
#include <cctype>

#include "kg_base/common/input_error.h"
#include "kg_base/text/iri.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_core::sparql {
namespace {

bool SameWord(std::string_view a, std::string_view b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
           return std::toupper(static_cast<unsigned char>(x)) ==
                  std::toupper(static_cast<unsigned char>(y));
         });
}

std::string Describe(const Token& token) {
  switch (token.kind) {
    case Token::Kind::kEnd:
      return "the end of the query";
    case Token::Kind::kIri:
      return "<" + token.text + ">";
    case Token::Kind::kPrefixedName:
      return token.prefix + ":" + token.text;
    case Token::Kind::kBlankLabel:
      return "_:" + token.text;
    case Token::Kind::kVariable:
      return "?" + token.text;
    case Token::Kind::kString:
      return "a string";
    case Token::Kind::kLanguageTag:
      return "@" + token.text;
    case Token::Kind::kInteger:
    case Token::Kind::kDecimal:
    case Token::Kind::kDouble:
    case Token::Kind::kWord:
    case Token::Kind::kPunctuation:
      break;
  }
  return token.text;
}

}  // namespace

SparqlGrammar::SparqlGrammar(std::vector<Token> tokens, int nesting)
    : tokens_(std::move(tokens)), nesting_(nesting) {
  for (const NamespacePrefix& prefix : kPrefixes) {
    prefixes_[prefix.name] = prefix.iri;
  }
}

SparqlGrammar::Nested::Nested(SparqlGrammar* grammar) : grammar_(grammar) {
  if (++grammar->depth_ > grammar->nesting_) {
    grammar->Fail(grammar->Peek(), "nested deeper than the limit of " +
                                       std::to_string(grammar->nesting_));
  }
}

const Token& SparqlGrammar::Peek(std::size_t ahead) const {
  return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

Token SparqlGrammar::Take() {
  const Token token = Peek();
  if (at_ + 1 < tokens_.size()) ++at_;
  return token;
}

bool SparqlGrammar::AtWord(std::string_view word, std::size_t ahead) const {
  const Token& token = Peek(ahead);
  return token.kind == Token::Kind::kWord && SameWord(token.text, word);
}

bool SparqlGrammar::AtMark(std::string_view mark, std::size_t ahead) const {
  const Token& token = Peek(ahead);
  return token.kind == Token::Kind::kPunctuation && token.text == mark;
}

bool SparqlGrammar::TakeWord(std::string_view word) {
  if (!AtWord(word)) return false;
  Take();
  return true;
}

bool SparqlGrammar::TakeMark(std::string_view mark) {
  if (!AtMark(mark)) return false;
  Take();
  return true;
}

void SparqlGrammar::ExpectWord(std::string_view word) {
  if (!TakeWord(word)) Expected(std::string(word));
}

void SparqlGrammar::ExpectMark(std::string_view mark) {
  if (!TakeMark(mark)) Expected("'" + std::string(mark) + "'");
}

void SparqlGrammar::FailAt(QueryPosition position,
                           const std::string& what) const {
  throw kg_base::InputError(std::to_string(position.line) + ":" +
                            std::to_string(position.column) + ": " + what);
}

void SparqlGrammar::Fail(const Token& token, const std::string& what) const {
  FailAt(token.position, what);
}

void SparqlGrammar::Expected(const std::string& what) const {
  Fail(Peek(), "expected " + what + ", got " + Describe(Peek()));
}

bool SparqlGrammar::AtIri() const {
  return Peek().kind == Token::Kind::kIri ||
         Peek().kind == Token::Kind::kPrefixedName;
}

// [136] iri
std::string SparqlGrammar::ReadIri() {
  if (!AtIri()) Expected("an IRI");
  const Token token = Take();
  if (token.kind == Token::Kind::kIri) {
    std::string iri = kg_base::ResolveIri(query_.base, token.text);
    if (kg_base::IsAbsoluteIri(iri)) return iri;
    Fail(token, "relative IRI <" + iri +
                    ">; expected an absolute IRI or a BASE before it");
  }
  const auto prefix = prefixes_.find(token.prefix);
  if (prefix == prefixes_.end()) {
    Fail(token, "prefix '" + token.prefix + ":' is not declared");
  }
  return prefix->second + token.text;
}

bool SparqlGrammar::AtLiteral() const {
  const auto numeric = [](const Token& token) {
    return token.kind == Token::Kind::kInteger ||
           token.kind == Token::Kind::kDecimal ||
           token.kind == Token::Kind::kDouble;
  };
  if (AtMark("+") || AtMark("-")) return numeric(Peek(1));
  return numeric(Peek()) || Peek().kind == Token::Kind::kString ||
         AtWord("true") || AtWord("false");
}

// [129] RDFLiteral, [130] NumericLiteral, [134] BooleanLiteral
Term SparqlGrammar::ReadLiteral() {
  std::string sign;
  if (AtMark("+") || AtMark("-")) sign = Take().text;
  const Token token = Take();
  const std::string xsd(kXsd);
  switch (token.kind) {
    case Token::Kind::kInteger:
      return Literal(sign + token.text, xsd + "integer");
    case Token::Kind::kDecimal:
      return Literal(sign + token.text, xsd + "decimal");
    case Token::Kind::kDouble:
      return Literal(sign + token.text, xsd + "double");
    case Token::Kind::kWord:
      return BooleanLiteral(SameWord(token.text, "true"));
    case Token::Kind::kString:
      break;
    default:
      Fail(token, "expected a literal, got " + Describe(token));
  }
  // A string, optionally followed by a language tag or a datatype.
  if (Peek().kind == Token::Kind::kLanguageTag) {
    return LanguageLiteral(token.text, Take().text);
  }
  return TakeMark("^^") ? Literal(token.text, ReadIri()) : Literal(token.text);
}

int SparqlGrammar::ReadVariable() {
  if (Peek().kind != Token::Kind::kVariable) Expected("a variable");
  if (!template_.variables) {
    Fail(Peek(), std::string(template_.name) + " may not have variables");
  }
  return VariableNumber(Take().text);
}

int SparqlGrammar::VariableNumber(const std::string& name) {
  const int next = static_cast<int>(query_.variables.size());
  const auto [found, is_new] = variable_numbers_.emplace(name, next);
  if (is_new) query_.variables.push_back(name);
  return found->second;
}

int SparqlGrammar::FreshVariable() {
  CheckBlankAllowed();
  return VariableNumber("." + std::to_string(query_.variables.size()));
}

// A blank node label may only be used in one basic graph pattern.
// https://www.w3.org/TR/sparql11-query/#grammarBNodes
VarOrTerm SparqlGrammar::BlankNode(const std::string& label) {
  CheckBlankAllowed();
  const auto [found, is_new] = block_of_label_.emplace(label, block_);
  if (!is_new && found->second != block_) {
    Fail(Peek(),
         "blank node _:" + label + " is used in two different graph patterns");
  }
  return {true, VariableNumber("_:" + label)};
}

int SparqlGrammar::ConstantNumber(const Term& term) {
  const int next = static_cast<int>(query_.constants.size());
  const auto [found, is_new] =
      constant_numbers_.emplace(ToNTriples(term), next);
  if (is_new) query_.constants.push_back(term);
  return found->second;
}

VarOrTerm SparqlGrammar::ConstantNode(const Term& term) {
  return {false, ConstantNumber(term)};
}

}  // namespace kg_core::sparql
