// An error for possibly valid input that exceeds a limit.

#ifndef KG_BASE_COMMON_LIMIT_ERROR_H_
#define KG_BASE_COMMON_LIMIT_ERROR_H_

#include "kg_base/common/input_error.h"

namespace kg_base {

// Too much time, memory, rows, steps or text. A retry, or a smaller request,
// may succeed.
class LimitError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace kg_base

#endif  // KG_BASE_COMMON_LIMIT_ERROR_H_
