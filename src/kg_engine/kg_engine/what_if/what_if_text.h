// A what-if's answer for a person.

#ifndef KG_ENGINE_WHAT_IF_WHAT_IF_TEXT_H_
#define KG_ENGINE_WHAT_IF_WHAT_IF_TEXT_H_

#include <string>

#include "kg_engine/what_if/what_if_answer.h"

namespace kg_engine {

// Lines that say what would change, or why the question was refused; then what
// `answer.text` holds already (the query's table), if anything.
std::string WhatIfText(const WhatIfAnswer& answer);

}  // namespace kg_engine

#endif  // KG_ENGINE_WHAT_IF_WHAT_IF_TEXT_H_
