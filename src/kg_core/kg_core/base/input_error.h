// An error in what the outside world handed us: a file, a message, a fact.

#ifndef KG_CORE_BASE_INPUT_ERROR_H_
#define KG_CORE_BASE_INPUT_ERROR_H_

#include <stdexcept>

namespace kg_core {

// Thrown where input is read, caught only at a node's or a program's door.
// Its text is one line that says where the mistake is (file, line, subject,
// property) and what was expected.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace kg_core

#endif  // KG_CORE_BASE_INPUT_ERROR_H_
