// An error in external input: a file, a message, a fact.

#ifndef KG_BASE_COMMON_INPUT_ERROR_H_
#define KG_BASE_COMMON_INPUT_ERROR_H_

#include <stdexcept>
#include <string>

#include "kg_base/common/one_line.h"

namespace kg_base {

// Thrown where input is read, caught only in a node's callbacks or a program's
// main(). Its text is one line, even if it quotes other text, and states where
// the error is (file, line, subject, property) and what was expected.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& text)
      : std::runtime_error(OneLine(text)) {}
};

}  // namespace kg_base

#endif  // KG_BASE_COMMON_INPUT_ERROR_H_
