// The prefixes predefined in all Turtle terms, queries and reports of this
// project, and the named graphs of the store.

#ifndef KG_CORE_RDF_NAMESPACES_H_
#define KG_CORE_RDF_NAMESPACES_H_

#include <optional>
#include <string>
#include <string_view>

namespace kg_core {

struct NamespacePrefix {
  const char* name;  // Without the colon.
  const char* iri;
};

inline constexpr char kEx[] = "http://example.org/mission/";
inline constexpr char kRdf[] = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
inline constexpr char kRdfs[] = "http://www.w3.org/2000/01/rdf-schema#";
inline constexpr char kOwl[] = "http://www.w3.org/2002/07/owl#";
inline constexpr char kXsd[] = "http://www.w3.org/2001/XMLSchema#";
inline constexpr char kSh[] = "http://www.w3.org/ns/shacl#";
inline constexpr char kProv[] = "http://www.w3.org/ns/prov#";
inline constexpr char kTime[] = "http://www.w3.org/2006/time#";
inline constexpr char kGeo[] = "http://www.opengis.net/ont/geosparql#";
inline constexpr char kGeof[] =
    "http://www.opengis.net/def/function/geosparql/";
inline constexpr char kSsn[] = "http://www.w3.org/ns/ssn/";
inline constexpr char kSosa[] = "http://www.w3.org/ns/sosa/";
inline constexpr char kGraph[] = "http://example.org/mission/graph/";

inline constexpr NamespacePrefix kPrefixes[] = {
    {"ex", kEx},       {"rdf", kRdf},   {"rdfs", kRdfs}, {"owl", kOwl},
    {"xsd", kXsd},     {"sh", kSh},     {"prov", kProv}, {"time", kTime},
    {"geo", kGeo},     {"geof", kGeof}, {"ssn", kSsn},   {"sosa", kSosa},
    {"graph", kGraph},
};

// Current truth: what operators and ingest assert, validated before commit.
inline constexpr char kFactsGraph[] = "http://example.org/mission/graph/facts";
// Ontology, shapes and rules.
inline constexpr char kVocabGraph[] = "http://example.org/mission/graph/vocab";
// Conclusions of the rules from facts and vocabulary, with their premises;
// updated in the same transaction as those, never written by hand.
inline constexpr char kInferredGraph[] =
    "http://example.org/mission/graph/inferred";
// Activities and entities of PROV-O; append-only.
inline constexpr char kProvGraph[] = "http://example.org/mission/graph/prov";
// Who changed what and when, old and new value; append-only.
inline constexpr char kLogGraph[] = "http://example.org/mission/graph/log";
// Agent positions: mission state reported automatically, not entered by an
// operator.
inline constexpr char kStateGraph[] = "http://example.org/mission/graph/state";
// One run's artifacts, written once: kPlanGraphPrefix + run number.
inline constexpr char kPlanGraphPrefix[] =
    "http://example.org/mission/graph/plan/";

// The IRI abbreviated by `prefixed` ("ex:alpha"); nullopt if its prefix is not
// one of kPrefixes.
std::optional<std::string> ExpandPrefixed(std::string_view prefixed);

// The abbreviated form ("ex:alpha") if a prefix matches and the rest is a plain
// local name, else "<iri>".
std::string AbbreviateIri(std::string_view iri);

}  // namespace kg_core

#endif  // KG_CORE_RDF_NAMESPACES_H_
