// Short names for the terms used in reading and writing mission facts.

#ifndef KG_CORE_FACTS_TERMS_H_
#define KG_CORE_FACTS_TERMS_H_

#include <string>
#include <string_view>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

inline Term Ex(std::string_view local) { return Iri(kEx + std::string(local)); }
inline Term Prov(std::string_view local) {
  return Iri(kProv + std::string(local));
}
inline Term TimeTerm(std::string_view local) {
  return Iri(kTime + std::string(local));
}
inline Term GeoTerm(std::string_view local) {
  return Iri(kGeo + std::string(local));
}
inline Term Rdfs(std::string_view local) {
  return Iri(kRdfs + std::string(local));
}
inline Term RdfType() { return Iri(std::string(kRdf) + "type"); }
inline Term Facts() { return Iri(kFactsGraph); }

inline Term WktLiteral(std::string wkt) {
  return Literal(std::move(wkt), std::string(kGeo) + "wktLiteral");
}

}  // namespace kg_core

#endif  // KG_CORE_FACTS_TERMS_H_
