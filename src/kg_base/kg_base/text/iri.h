// Relative IRI references against a base.
// https://www.rfc-editor.org/rfc/rfc3986#section-5.2

#ifndef KG_BASE_TEXT_IRI_H_
#define KG_BASE_TEXT_IRI_H_

#include <string>
#include <string_view>

namespace kg_base {

// Does it begin with a scheme ("http:")?
bool IsAbsoluteIri(std::string_view iri);
// The IRI that `reference` means where `base` is the base. Without a base a
// relative reference stays as it is.
std::string ResolveIri(std::string_view base, std::string_view reference);

}  // namespace kg_base

#endif  // KG_BASE_TEXT_IRI_H_
