#include "kg_core/facts/vocabulary.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string_view>

#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/terms.h"

namespace kg_core {
namespace {

bool StartsWith(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

bool IsDatatype(const Term& range) {
  return StartsWith(range.text, kXsd) || range == GeoTerm("wktLiteral") ||
         range == Rdfs("Literal");
}

PropertyFacts ReadProperty(const GraphView& view, const Term& property) {
  PropertyFacts facts;
  facts.domains = Objects(view, kVocabGraph, property, Ex("domainIncludes"));
  for (Term& range :
       Objects(view, kVocabGraph, property, Ex("rangeIncludes"))) {
    (IsDatatype(range) ? facts.datatypes : facts.classes)
        .push_back(std::move(range));
  }
  return facts;
}

Term Owl(const std::string& local) { return Iri(kOwl + local); }

std::map<Term, Term> ReadAliases(const GraphView& view) {
  std::map<Term, Term> aliases;
  for (const char* name : {"equivalentClass", "equivalentProperty"}) {
    Quad pattern;
    pattern.predicate = view.Find(Owl(name));
    pattern.graph = view.Find(Iri(kVocabGraph));
    if (pattern.predicate == kNoTerm || pattern.graph == kNoTerm) continue;
    view.Match(pattern, [&](const Quad& quad) {
      aliases.emplace(view.Get(quad.subject), view.Get(quad.object));
      return true;
    });
  }
  return aliases;
}

// The term whose abbreviated name has the smallest edit distance to that of
// `wanted`.
template <typename Terms>
std::string Nearest(const Terms& terms, const std::string& wanted) {
  std::string best;
  int best_distance = static_cast<int>(wanted.size()) + 1;
  for (const Term& term : terms) {
    const std::string name = ToTurtle(term);
    const int distance = EditDistance(name, wanted);
    if (distance < best_distance) {
      best = name;
      best_distance = distance;
    }
  }
  return best;
}

template <typename Terms>
std::string Unknown(const Terms& terms, const Term& term, const char* what) {
  const std::string name = ToTurtle(term);
  return name + " is not a " + what + " of the ontology, the nearest is " +
         Nearest(terms, name);
}

}  // namespace

Vocabulary::Vocabulary(const GraphView& view)
    : view_(view), aliases_(ReadAliases(view)) {
  const Term annotation = Owl("AnnotationProperty");
  for (const Term& type : {Owl("ObjectProperty"), Owl("DatatypeProperty"),
                           Iri(std::string(kRdf) + "Property"), annotation}) {
    for (const Term& property : Subjects(view, kVocabGraph, RdfType(), type)) {
      PropertyFacts facts = ReadProperty(view, property);
      facts.is_annotation = type == annotation;
      properties_[property] = std::move(facts);
    }
  }
  const std::vector<Term> classes =
      Subjects(view, kVocabGraph, RdfType(), Owl("Class"));
  classes_.insert(classes.begin(), classes.end());
}

const PropertyFacts* Vocabulary::FindProperty(const Term& property) const {
  const auto found = properties_.find(property);
  return found == properties_.end() ? nullptr : &found->second;
}

const Term& Vocabulary::Canonical(const Term& term) const {
  const auto found = aliases_.find(term);
  return found == aliases_.end() ? term : found->second;
}

bool Vocabulary::IsAnyOf(const std::vector<Term>& types,
                         const std::vector<Term>& tops) const {
  for (const Term& top : tops) {
    const std::set<Term> below = ClassAndSubclasses(view_, top);
    const auto is_below = [&](const Term& type) {
      return below.count(type) != 0;
    };
    if (std::any_of(types.begin(), types.end(), is_below)) return true;
  }
  return false;
}

std::string Vocabulary::UnknownProperty(const Term& property) const {
  std::vector<Term> names;
  for (const auto& [name, facts] : properties_) names.push_back(name);
  return Unknown(names, property, "property");
}

std::string Vocabulary::UnknownClass(const Term& type) const {
  return Unknown(classes_, type, "class");
}

int EditDistance(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace kg_core
