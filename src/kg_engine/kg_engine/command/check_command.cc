// kg check STORE

#include <iostream>

#include "kg_engine/command/command.h"
#include "kg_engine/command/target.h"
#include "kg_engine/server/world_check.h"

namespace kg_engine::command {
namespace {

int RunCheck(const Arguments& arguments) {
  arguments.ExpectWords(1, 1, "STORE");
  const Target target = OpenStore(arguments.words[0]);
  kg_mission::FileCache files(target.mission_folder,
                              arguments.One("--data").value_or(""));
  const CheckAnswer answer = CheckStore(*target.store->Read(), &files);
  (answer.errors.empty() ? std::cout : std::cerr) << answer.text << std::endl;
  return answer.ok ? kDone : kRefused;
}

}  // namespace

const Subcommand kCheck = {
    "check",
    "STORE [--data FOLDER]",
    "recompile the facts and compare with the artifacts recorded in the store",
    "STORE is that of a node that has been stopped. Its facts are compiled "
    "from\n"
    "nothing; a tensor that its provenance graph does not know, by the hash "
    "of\n"
    "all that it is made of and by its sources, is named, and the status is "
    "1.\n"
    "So it is for a tensor that a change made dirty after the last cycle. A\n"
    "running node is asked by the service kg/check, which compares bit by "
    "bit.\n\n"
    "  --data FOLDER  where the mission's files are looked up first\n",
    {{"--data", true}},
    RunCheck};

}  // namespace kg_engine::command
