// owl:hasKey of the ontology: no two instances of a class share the values of
// its key. SHACL Core cannot express this, since a shape is evaluated on one
// focus node at a time. https://www.w3.org/TR/owl2-syntax/#Keys

#ifndef KG_CORE_FACTS_KEYS_H_
#define KG_CORE_FACTS_KEYS_H_

#include <string>
#include <vector>

#include "kg_core/rdf/store.h"

namespace kg_core {

// One line for each subject changed by `transaction` that shares its key with
// another. Subjects that lack a value for a key property have no key.
std::vector<std::string> CheckKeys(const Transaction& transaction);

}  // namespace kg_core

#endif  // KG_CORE_FACTS_KEYS_H_
