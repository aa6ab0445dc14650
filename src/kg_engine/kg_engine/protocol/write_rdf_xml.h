// Triples as RDF/XML, for clients that know no other syntax.
// https://www.w3.org/TR/rdf-syntax-grammar/

#ifndef KG_ENGINE_PROTOCOL_WRITE_RDF_XML_H_
#define KG_ENGINE_PROTOCOL_WRITE_RDF_XML_H_

#include <string>
#include <vector>

#include "kg_core/sparql/query_result.h"

namespace kg_engine {

// Writes one rdf:Description per triple, in the given order. Throws HttpError
// 406 for triples that RDF/XML cannot express: a predicate that does not end in
// an XML name, a control character.
std::string TriplesToRdfXml(const std::vector<kg_core::Triple>& triples);

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_WRITE_RDF_XML_H_
