// An RDF term: IRI, blank node or literal. Lexical forms are kept exactly as
// they were written ("1.50" stays "1.50"); equality is term equality
// (https://www.w3.org/TR/rdf11-concepts/#dfn-literal-term-equality).

#ifndef KG_CORE_RDF_TERM_H_
#define KG_CORE_RDF_TERM_H_

#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace kg_core {

struct Term {
  enum class Kind { kIri, kBlank, kLiteral };

  Kind kind = Kind::kIri;
  std::string text;      // IRI, blank node label without "_:", lexical form.
  std::string datatype;  // Literals only: its IRI, never empty.
  std::string language;  // Literals only: lower case tag, usually empty.

  bool is_iri() const { return kind == Kind::kIri; }
  bool is_blank() const { return kind == Kind::kBlank; }
  bool is_literal() const { return kind == Kind::kLiteral; }
};

bool operator==(const Term& a, const Term& b);
bool operator!=(const Term& a, const Term& b);
bool operator<(const Term& a, const Term& b);  // Some total order.

Term Iri(std::string iri);
Term Blank(std::string label);
Term Literal(std::string lexical);  // xsd:string
Term Literal(std::string lexical, std::string datatype);
Term LanguageLiteral(std::string lexical, std::string language);
Term DoubleLiteral(double value);  // Shortest form that reads back the same.
Term IntegerLiteral(long long value);
Term BooleanLiteral(bool value);

// The name of a graph as text: its IRI, or "_:" and the label of a blank node,
// which no IRI begins with. A dataset may have both kinds:
// https://www.w3.org/TR/rdf11-concepts/#section-dataset
std::string ToGraphName(const Term& graph);
Term GraphFromName(std::string_view name);

// The value of a numeric literal (xsd:integer and derived types, decimal,
// float, double), else nullopt. NaN and infinities are values.
std::optional<double> NumericValue(const Term& term);

// N-Triples syntax, e.g. <http://...>, _:b0, "x"@en, "1"^^<...#integer>.
std::string ToNTriples(const Term& term);

// Turtle term syntax with the usual prefixes, e.g. ex:alpha, "0.4", 3, true.
// Used in reasons, reports and text tables.
std::string ToTurtle(const Term& term);

std::ostream& operator<<(std::ostream& out, const Term& term);

}  // namespace kg_core

#endif  // KG_CORE_RDF_TERM_H_
