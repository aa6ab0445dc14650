// Input that may well be right, but asks for more than its limits.

#ifndef KG_CORE_BASE_LIMIT_ERROR_H_
#define KG_CORE_BASE_LIMIT_ERROR_H_

#include "kg_core/base/input_error.h"

namespace kg_core {

// Too much time, memory, rows, steps or text. Tried again, or with less, it may
// succeed.
class LimitError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace kg_core

#endif  // KG_CORE_BASE_LIMIT_ERROR_H_
