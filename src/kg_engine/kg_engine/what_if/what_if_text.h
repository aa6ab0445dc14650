// Display text of a what-if's answer.

#ifndef KG_ENGINE_WHAT_IF_WHAT_IF_TEXT_H_
#define KG_ENGINE_WHAT_IF_WHAT_IF_TEXT_H_

#include <string>

#include "kg_engine/what_if/what_if_answer.h"

namespace kg_engine {

// Lines with the changes, or with the reasons of rejection, followed by the
// existing `answer.text` (the query's table), if any.
std::string WhatIfText(const WhatIfAnswer& answer);

}  // namespace kg_engine

#endif  // KG_ENGINE_WHAT_IF_WHAT_IF_TEXT_H_
