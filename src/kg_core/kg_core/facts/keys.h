// owl:hasKey of the ontology: no two instances of a class share the values of
// its key. SHACL Core cannot say it (sh:uniqueLang apart, a shape sees one
// focus node). https://www.w3.org/TR/owl2-syntax/#Keys

#ifndef KG_CORE_FACTS_KEYS_H_
#define KG_CORE_FACTS_KEYS_H_

#include <string>
#include <vector>

#include "kg_core/rdf/store.h"

namespace kg_core {

// A line for each subject that `transaction` changed and that shares its key
// with another. Subjects without a value for each property of the key have
// none.
std::vector<std::string> CheckKeys(const Transaction& transaction);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_KEYS_H_
