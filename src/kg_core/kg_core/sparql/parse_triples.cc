// Triples blocks and property paths, rules [52] to [118].

#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/grammar.h"

namespace kg_core::sparql {
namespace {

Term RdfTerm(const char* name) { return Iri(std::string(kRdf) + name); }

Path Combined(Path::Kind kind, std::vector<Path> parts) {
  if (parts.size() == 1) return std::move(parts[0]);
  Path path;
  path.kind = kind;
  path.parts = std::move(parts);
  return path;
}

Path Wrapped(Path::Kind kind, Path part) {
  Path path;
  path.kind = kind;
  path.parts.push_back(std::move(part));
  return path;
}

}  // namespace

bool Grammar::AtTerm() const {
  return AtIri() || AtLiteral() || Peek().kind == Token::Kind::kVariable ||
         Peek().kind == Token::Kind::kBlankLabel ||
         (AtMark("(") && AtMark(")", 1)) || (AtMark("[") && AtMark("]", 1));
}

bool Grammar::AtTriples() const {
  return AtTerm() || AtMark("(") || AtMark("[");
}

// [106] VarOrTerm, [109] GraphTerm
Node Grammar::ReadVariableOrTerm() {
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
void Grammar::ReadTriplesBlock(Pattern* basic) {
  while (AtTriples()) {
    if (AtTerm()) {
      const Node subject = ReadVariableOrTerm();
      ReadPropertyList(subject, basic, true);
    } else {
      const Node subject = ReadGraphNode(basic);
      ReadPropertyList(subject, basic, false);
    }
    if (!TakeMark(".")) return;
  }
}

bool Grammar::AtPath() const {
  return AtIri() || AtWord("a") || AtMark("^") || AtMark("!") || AtMark("(");
}

// [83] PropertyListPathNotEmpty
void Grammar::ReadPropertyList(const Node& subject, Pattern* basic,
                               bool required) {
  while (true) {
    if (Peek().kind == Token::Kind::kVariable) {
      const Node verb{true, ReadVariable()};
      ReadObjects(subject, nullptr, verb, basic);
    } else if (template_.active ? AtIri() || AtWord("a") : AtPath()) {
      const Path path = template_.active ? ReadPathPrimary() : ReadPath();
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
void Grammar::ReadObjects(const Node& subject, const Path* path,
                          const Node& verb, Pattern* basic) {
  do {
    const Node object = ReadGraphNode(basic);
    if (path != nullptr) {
      AddPath(subject, *path, object, basic);
    } else {
      AddTriple(subject, verb, object, basic);
    }
  } while (TakeMark(","));
}

// [105] GraphNodePath
Node Grammar::ReadGraphNode(Pattern* basic) {
  if (AtTerm()) return ReadVariableOrTerm();
  if (AtMark("[")) return ReadBlankProperties(basic);
  if (AtMark("(")) return ReadCollection(basic);
  Expected("a variable or a term");
}

// [101] BlankNodePropertyListPath
Node Grammar::ReadBlankProperties(Pattern* basic) {
  const Nested nested(this);
  ExpectMark("[");
  const Node node{true, FreshVariable()};
  ReadPropertyList(node, basic, true);
  ExpectMark("]");
  return node;
}

// [103] CollectionPath
Node Grammar::ReadCollection(Pattern* basic) {
  const Nested nested(this);
  ExpectMark("(");
  const Node first = ConstantNode(RdfTerm("first"));
  const Node rest = ConstantNode(RdfTerm("rest"));
  const Node head{true, FreshVariable()};
  Node cell = head;
  while (true) {
    const Node item = ReadGraphNode(basic);
    AddTriple(cell, first, item, basic);
    if (TakeMark(")")) break;
    const Node next{true, FreshVariable()};
    AddTriple(cell, rest, next, basic);
    cell = next;
  }
  AddTriple(cell, rest, ConstantNode(RdfTerm("nil")), basic);
  return head;
}

void Grammar::AddTriple(const Node& subject, const Node& predicate,
                        const Node& object, Pattern* basic) {
  if (!template_.active) CountPattern();
  basic->triples.push_back({subject, predicate, object, std::nullopt});
}

// Links, inverses and sequences are triple patterns.
// https://www.w3.org/TR/sparql11-query/#sparqlTranslatePathPatterns
void Grammar::AddPath(const Node& subject, const Path& path, const Node& object,
                      Pattern* basic) {
  switch (path.kind) {
    case Path::Kind::kLink:
      return AddTriple(subject, {false, path.constant}, object, basic);
    case Path::Kind::kInverse:
      return AddPath(object, path.parts[0], subject, basic);
    case Path::Kind::kSequence: {
      Node from = subject;
      for (std::size_t i = 0; i + 1 < path.parts.size(); ++i) {
        const Node to{true, FreshVariable()};
        AddPath(from, path.parts[i], to, basic);
        from = to;
      }
      return AddPath(from, path.parts.back(), object, basic);
    }
    case Path::Kind::kAlternative:
    case Path::Kind::kZeroOrMore:
    case Path::Kind::kOneOrMore:
    case Path::Kind::kZeroOrOne:
    case Path::Kind::kNegated:
      break;
  }
  CountPattern();
  basic->triples.push_back({subject, {}, object, path});
}

// [89] PathAlternative
Path Grammar::ReadPath() {
  const Nested nested(this);
  std::vector<Path> parts;
  do {
    parts.push_back(ReadPathSequence());
  } while (TakeMark("|"));
  return Combined(Path::Kind::kAlternative, std::move(parts));
}

// [90] PathSequence
Path Grammar::ReadPathSequence() {
  std::vector<Path> parts;
  do {
    parts.push_back(ReadPathStep());
  } while (TakeMark("/"));
  return Combined(Path::Kind::kSequence, std::move(parts));
}

// [91] PathElt, [92] PathEltOrInverse
Path Grammar::ReadPathStep() {
  const bool inverse = TakeMark("^");
  Path path = ReadPathPrimary();
  if (TakeMark("*")) {
    path = Wrapped(Path::Kind::kZeroOrMore, std::move(path));
  } else if (TakeMark("+")) {
    path = Wrapped(Path::Kind::kOneOrMore, std::move(path));
  } else if (TakeMark("?")) {
    path = Wrapped(Path::Kind::kZeroOrOne, std::move(path));
  }
  return inverse ? Wrapped(Path::Kind::kInverse, std::move(path)) : path;
}

// [94] PathPrimary
Path Grammar::ReadPathPrimary() {
  if (TakeMark("!")) return ReadNegatedSet();
  if (TakeMark("(")) {
    Path path = ReadPath();
    ExpectMark(")");
    return path;
  }
  Path link;
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
Path Grammar::ReadNegatedSet() {
  Path path;
  path.kind = Path::Kind::kNegated;
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
Path Grammar::ReadNegatedLink() {
  const bool inverse = TakeMark("^");
  if (!AtIri() && !AtWord("a")) Expected("a property");
  Path link = ReadPathPrimary();
  return inverse ? Wrapped(Path::Kind::kInverse, std::move(link)) : link;
}

}  // namespace kg_core::sparql
