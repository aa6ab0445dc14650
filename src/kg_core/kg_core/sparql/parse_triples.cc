// Triples blocks and property paths, rules [52] to [118].

#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/grammar.h"

namespace kg_core::sparql {
namespace {

Term RdfTerm(const char* name) { return Iri(std::string(kRdf) + name); }

PropertyPath Combined(PropertyPath::Kind kind,
                      std::vector<PropertyPath> parts) {
  if (parts.size() == 1) return std::move(parts[0]);
  PropertyPath path;
  path.kind = kind;
  path.parts = std::move(parts);
  return path;
}

PropertyPath Wrapped(PropertyPath::Kind kind, PropertyPath part) {
  PropertyPath path;
  path.kind = kind;
  path.parts.push_back(std::move(part));
  return path;
}

}  // namespace

bool SparqlGrammar::AtTerm() const {
  return AtIri() || AtLiteral() || Peek().kind == Token::Kind::kVariable ||
         Peek().kind == Token::Kind::kBlankLabel ||
         (AtMark("(") && AtMark(")", 1)) || (AtMark("[") && AtMark("]", 1));
}

bool SparqlGrammar::AtTriples() const {
  return AtTerm() || AtMark("(") || AtMark("[");
}

// [106] VarOrTerm, [109] GraphTerm
VarOrTerm SparqlGrammar::ReadVariableOrTerm() {
  if (Peek().kind == Token::Kind::kVariable) return {true, ReadVariable()};
  if (AtIri()) return ConstantNode(Iri(ReadIri()));
  if (AtLiteral()) return ConstantNode(ReadLiteral());
  if (Peek().kind == Token::Kind::kBlankLabel) return BlankNode(Take().text);
  if (AtMark("[") && AtMark("]", 1)) {
    Take();
    Take();
    return {true, FreshVariable()};
  }
  if (TakeMark("(")) {
    ExpectMark(")");
    return ConstantNode(RdfTerm("nil"));
  }
  Expected("a variable or a term");
}

// [55] TriplesBlock
void SparqlGrammar::ReadTriplesBlock(GraphPattern* basic) {
  while (AtTriples()) {
    if (AtTerm()) {
      const VarOrTerm subject = ReadVariableOrTerm();
      ReadPropertyList(subject, basic, true);
    } else {
      const VarOrTerm subject = ReadGraphNode(basic);
      ReadPropertyList(subject, basic, false);
    }
    if (!TakeMark(".")) return;
  }
}

bool SparqlGrammar::AtPath() const {
  return AtIri() || AtWord("a") || AtMark("^") || AtMark("!") || AtMark("(");
}

// [83] PropertyListPathNotEmpty
void SparqlGrammar::ReadPropertyList(const VarOrTerm& subject,
                                     GraphPattern* basic, bool required) {
  while (true) {
    if (Peek().kind == Token::Kind::kVariable) {
      const VarOrTerm verb{true, ReadVariable()};
      ReadObjects(subject, nullptr, verb, basic);
    } else if (template_.active ? AtIri() || AtWord("a") : AtPath()) {
      const PropertyPath path =
          template_.active ? ReadPathPrimary() : ReadPath();
      ReadObjects(subject, &path, {}, basic);
    } else if (required) {
      Expected("a property");
    } else {
      return;
    }
    if (!AtMark(";")) return;
    while (TakeMark(";")) required = false;
  }
}

// [86] ObjectListPath
void SparqlGrammar::ReadObjects(const VarOrTerm& subject,
                                const PropertyPath* path, const VarOrTerm& verb,
                                GraphPattern* basic) {
  do {
    const VarOrTerm object = ReadGraphNode(basic);
    if (path != nullptr) {
      AddPath(subject, *path, object, basic);
    } else {
      AddTriple(subject, verb, object, basic);
    }
  } while (TakeMark(","));
}

// [105] GraphNodePath
VarOrTerm SparqlGrammar::ReadGraphNode(GraphPattern* basic) {
  if (AtTerm()) return ReadVariableOrTerm();
  if (AtMark("[")) return ReadBlankProperties(basic);
  if (AtMark("(")) return ReadCollection(basic);
  Expected("a variable or a term");
}

// [101] BlankNodePropertyListPath
VarOrTerm SparqlGrammar::ReadBlankProperties(GraphPattern* basic) {
  const Nested nested(this);
  ExpectMark("[");
  const VarOrTerm node{true, FreshVariable()};
  ReadPropertyList(node, basic, true);
  ExpectMark("]");
  return node;
}

// [103] CollectionPath
VarOrTerm SparqlGrammar::ReadCollection(GraphPattern* basic) {
  const Nested nested(this);
  ExpectMark("(");
  const VarOrTerm first = ConstantNode(RdfTerm("first"));
  const VarOrTerm rest = ConstantNode(RdfTerm("rest"));
  const VarOrTerm head{true, FreshVariable()};
  VarOrTerm cell = head;
  while (true) {
    const VarOrTerm item = ReadGraphNode(basic);
    AddTriple(cell, first, item, basic);
    if (TakeMark(")")) break;
    const VarOrTerm next{true, FreshVariable()};
    AddTriple(cell, rest, next, basic);
    cell = next;
  }
  AddTriple(cell, rest, ConstantNode(RdfTerm("nil")), basic);
  return head;
}

void SparqlGrammar::AddTriple(const VarOrTerm& subject,
                              const VarOrTerm& predicate,
                              const VarOrTerm& object, GraphPattern* basic) {
  if (!template_.active) CountPattern();
  basic->triples.push_back({subject, predicate, object, std::nullopt});
}

// Links, inverses and sequences are translated to triple patterns.
// https://www.w3.org/TR/sparql11-query/#sparqlTranslatePathPatterns
void SparqlGrammar::AddPath(const VarOrTerm& subject, const PropertyPath& path,
                            const VarOrTerm& object, GraphPattern* basic) {
  switch (path.kind) {
    case PropertyPath::Kind::kLink:
      return AddTriple(subject, {false, path.constant}, object, basic);
    case PropertyPath::Kind::kInverse:
      return AddPath(object, path.parts[0], subject, basic);
    case PropertyPath::Kind::kSequence: {
      // A sequence becomes triples linked by fresh variables.
      VarOrTerm from = subject;
      for (std::size_t i = 0; i + 1 < path.parts.size(); ++i) {
        const VarOrTerm to{true, FreshVariable()};
        AddPath(from, path.parts[i], to, basic);
        from = to;
      }
      return AddPath(from, path.parts.back(), object, basic);
    }
    case PropertyPath::Kind::kAlternative:
    case PropertyPath::Kind::kZeroOrMore:
    case PropertyPath::Kind::kOneOrMore:
    case PropertyPath::Kind::kZeroOrOne:
    case PropertyPath::Kind::kNegated:
      break;
  }
  CountPattern();
  basic->triples.push_back({subject, {}, object, path});
}

// [89] PathAlternative
PropertyPath SparqlGrammar::ReadPath() {
  const Nested nested(this);
  std::vector<PropertyPath> parts;
  do {
    parts.push_back(ReadPathSequence());
  } while (TakeMark("|"));
  return Combined(PropertyPath::Kind::kAlternative, std::move(parts));
}

// [90] PathSequence
PropertyPath SparqlGrammar::ReadPathSequence() {
  std::vector<PropertyPath> parts;
  do {
    parts.push_back(ReadPathStep());
  } while (TakeMark("/"));
  return Combined(PropertyPath::Kind::kSequence, std::move(parts));
}

// [91] PathElt, [92] PathEltOrInverse
PropertyPath SparqlGrammar::ReadPathStep() {
  const bool inverse = TakeMark("^");
  PropertyPath path = ReadPathPrimary();
  if (TakeMark("*")) {
    path = Wrapped(PropertyPath::Kind::kZeroOrMore, std::move(path));
  } else if (TakeMark("+")) {
    path = Wrapped(PropertyPath::Kind::kOneOrMore, std::move(path));
  } else if (TakeMark("?")) {
    path = Wrapped(PropertyPath::Kind::kZeroOrOne, std::move(path));
  }
  return inverse ? Wrapped(PropertyPath::Kind::kInverse, std::move(path))
                 : path;
}

// [94] PathPrimary
PropertyPath SparqlGrammar::ReadPathPrimary() {
  if (TakeMark("!")) return ReadNegatedSet();
  if (TakeMark("(")) {
    PropertyPath path = ReadPath();
    ExpectMark(")");
    return path;
  }
  PropertyPath link;
  if (AtWord("a") && Peek().text == "a") {
    Take();
    link.constant = ConstantNumber(RdfTerm("type"));
  } else {
    if (!AtIri()) Expected("a property path");
    link.constant = ConstantNumber(Iri(ReadIri()));
  }
  return link;
}

// [95] PathNegatedPropertySet
PropertyPath SparqlGrammar::ReadNegatedSet() {
  PropertyPath path;
  path.kind = PropertyPath::Kind::kNegated;
  if (!TakeMark("(")) {
    path.parts.push_back(ReadNegatedLink());
    return path;
  }
  if (TakeMark(")")) return path;
  do {
    path.parts.push_back(ReadNegatedLink());
  } while (TakeMark("|"));
  ExpectMark(")");
  return path;
}

// [96] PathOneInPropertySet
PropertyPath SparqlGrammar::ReadNegatedLink() {
  const bool inverse = TakeMark("^");
  if (!AtIri() && !AtWord("a")) Expected("a property");
  PropertyPath link = ReadPathPrimary();
  return inverse ? Wrapped(PropertyPath::Kind::kInverse, std::move(link))
                 : link;
}

}  // namespace kg_core::sparql
