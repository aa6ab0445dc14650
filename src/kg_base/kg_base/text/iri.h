// Resolution of relative IRI references against a base.
// https://www.rfc-editor.org/rfc/rfc3986#section-5.2

#ifndef KG_BASE_TEXT_IRI_H_
#define KG_BASE_TEXT_IRI_H_

#include <string>
#include <string_view>

namespace kg_base {

// Does the IRI begin with a scheme ("http:")?
bool IsAbsoluteIri(std::string_view iri);
// Resolves `reference` against `base`. Without a base a relative reference is
// returned unchanged.
std::string ResolveIri(std::string_view base, std::string_view reference);

}  // namespace kg_base

#endif  // KG_BASE_TEXT_IRI_H_
