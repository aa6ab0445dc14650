// kg: queries, changes, checks and compares a store or a mission folder from
// the command line; see command.h.

#include <string>
#include <vector>

#include "kg_engine/command/command.h"

int main(int argc, char** argv) {
  const std::vector<std::string> line(argv + (argc > 0 ? 1 : 0), argv + argc);
  return kg_engine::command::RunCommand(line);
}
