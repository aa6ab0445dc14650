// The triples of CONSTRUCT and DESCRIBE as Turtle.

#include <map>
#include <set>

#include "kg_base/common/join_strings.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/results.h"

namespace kg_core {
namespace {

// Objects grouped by subject and property, all in Turtle syntax.
using ObjectSet = std::set<std::string>;
using PropertyObjects = std::map<std::string, ObjectSet>;
using SubjectProperties = std::map<std::string, PropertyObjects>;

bool Uses(const Term& term, const NamespacePrefix& prefix) {
  const std::string& iri = term.is_literal() ? term.datatype : term.text;
  return !term.is_blank() && iri.rfind(prefix.iri, 0) == 0;
}

std::string UsedPrefixes(const std::vector<Triple>& triples) {
  std::string out;
  for (const NamespacePrefix& prefix : kPrefixes) {
    bool used = false;
    for (const Triple& t : triples) {
      used = used || Uses(t.subject, prefix) || Uses(t.predicate, prefix) ||
             Uses(t.object, prefix);
    }
    if (!used) continue;
    out += std::string("@prefix ") + prefix.name + ": <" + prefix.iri + "> .\n";
  }
  return out;
}

std::string Property(const Term& predicate) {
  return predicate.text == std::string(kRdf) + "type" ? "a"
                                                      : ToTurtle(predicate);
}

std::string PropertyLines(const PropertyObjects& properties) {
  std::string out;
  for (const auto& [property, objects] : properties) {
    out += (out.empty() ? " " : " ;\n    ") + property + " " +
           kg_base::JoinStrings({objects.begin(), objects.end()});
  }
  return out;
}

}  // namespace

std::string TriplesToTurtle(const std::vector<Triple>& triples) {
  SubjectProperties subjects;
  for (const Triple& t : triples) {
    subjects[ToTurtle(t.subject)][Property(t.predicate)].insert(
        ToTurtle(t.object));
  }
  std::string out = UsedPrefixes(triples);
  for (const auto& [subject, properties] : subjects) {
    out += (out.empty() ? "" : "\n") + subject + PropertyLines(properties) +
           " .\n";
  }
  return out;
}

}  // namespace kg_core
