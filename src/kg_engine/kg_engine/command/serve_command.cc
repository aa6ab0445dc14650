// kg serve TARGET --port N

#include <pthread.h>

#include <csignal>
#include <cstdlib>
#include <iostream>

#include "kg_base/common/input_error.h"
#include "kg_engine/command/change.h"
#include "kg_engine/command/command.h"
#include "kg_engine/command/target.h"
#include "kg_engine/http/sparql_http_server.h"
#include "kg_engine/state/mission_state.h"

namespace kg_engine::command {
namespace {

using Outcome = kg_engine::UpdateVerdict::Outcome;

int ReadPort(const Arguments& arguments) {
  const std::string text = arguments.One("--port").value_or("");
  char* end = nullptr;
  const long port = std::strtol(text.c_str(), &end, 10);
  const bool fits = !text.empty() && *end == '\0' && port >= 0 && port <= 65535;
  if (fits) return static_cast<int>(port);
  throw UsageError("expected --port N, 0 to 65535");
}

// Serialised: a transaction waits for the previous one.
kg_engine::UpdateVerdict Decide(const kg_core::FactUpdate& update,
                                const std::string& data_folder,
                                const Target& target) {
  kg_engine::UpdateVerdict verdict;
  verdict.outcome = Outcome::kRefused;
  try {
    kg_core::Transaction transaction = target.store->Begin();
    verdict.reasons = Stage(update, data_folder, target, &transaction);
    if (!verdict.reasons.empty()) return verdict;
    if (!transaction.empty()) transaction.Commit(kg_core::WorldChange::kYes);
    verdict.outcome = Outcome::kAccepted;
  } catch (const std::runtime_error& error) {  // InputError, no disk space.
    verdict.reasons = {error.what()};
  }
  verdict.world_version = target.store->world_version();
  return verdict;
}

// Blocks the signals for all threads started later.
sigset_t BlockEndSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

int RunServe(const Arguments& arguments) {
  arguments.ExpectWords(1, 1, "TARGET");
  SparqlHttpOptions options;
  options.port = ReadPort(arguments);
  options.token_file = arguments.One("--token-file").value_or("");
  options.writable = arguments.Has("--writable");
  const std::string data = arguments.One("--data").value_or("");
  const Target target = OpenTarget(arguments.words[0], data);
  if (options.writable && IsMissionFolder(arguments.words[0])) {
    throw kg_base::InputError(arguments.words[0] +
                              ": a mission folder is not changed; serve a "
                              "store, or without --writable");
  }
  kg_engine::EndpointStore store;
  store.read = [&target] { return target.store->Read(); };
  store.dataset = CurrentDataset;
  store.update = [&](const kg_core::FactUpdate& update) {
    return Decide(update, data, target);
  };
  const sigset_t signals = BlockEndSignals();
  const SparqlHttpServer server(options, std::move(store));
  std::cout << "http://127.0.0.1:" << server.port() << "/sparql" << std::endl;
  int signal = 0;
  sigwait(&signals, &signal);
  return kDone;
}

}  // namespace

const Subcommand kServe = {
    "serve",
    "TARGET --port N [--token-file FILE] [--writable] [--data FOLDER]",
    "SPARQL over HTTP on 127.0.0.1, until it is interrupted",
    "Queries, graphs and updates as docs/interface.md has them. The first "
    "line\n"
    "of the output is the endpoint.\n\n"
    "  --port N           0: one that is free\n"
    "  --token-file FILE  holds the token that every request must carry;\n"
    "                     readable by its owner only (chmod 600)\n"
    "  --writable         facts may be changed; needs a token and a store\n"
    "  --data FOLDER      where a mission's files are looked up first\n",
    {{"--port", true},
     {"--token-file", true},
     {"--writable"},
     {"--data", true}},
    RunServe};

}  // namespace kg_engine::command
