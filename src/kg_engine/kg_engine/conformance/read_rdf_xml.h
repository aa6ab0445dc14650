// Reads RDF/XML, used by the oldest tests for results and data.

#ifndef KG_ENGINE_CONFORMANCE_READ_RDF_XML_H_
#define KG_ENGINE_CONFORMANCE_READ_RDF_XML_H_

#include <string_view>
#include <vector>

#include "kg_core/rdf/syntax.h"

namespace kg_engine {

// Supported: node and property elements, rdf:about, ID, nodeID, resource,
// datatype, li, parseType Resource and Collection, property attributes,
// xml:lang and xml:base. Throws InputError for anything else, such as a DTD,
// parseType Literal or reification.
std::vector<kg_core::Statement> ParseRdfXml(std::string_view text,
                                            const kg_core::RdfSource& source);

}  // namespace kg_engine

#endif  // KG_ENGINE_CONFORMANCE_READ_RDF_XML_H_
