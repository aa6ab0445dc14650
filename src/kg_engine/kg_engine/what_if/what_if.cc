#include "kg_engine/what_if/what_if.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/sha256.h"
#include "kg_base/common/stopwatch.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/results.h"
#include "kg_engine/state/mission_state.h"
#include "kg_engine/what_if/plan_change.h"
#include "kg_engine/what_if/what_if_facts.h"
#include "kg_engine/what_if/what_if_text.h"
#include "kg_mission/mission/mission_reader.h"

namespace kg_engine {
namespace {

using kg_base::InputError;

constexpr double kDefaultLimit_s = 60.0;

// Of all but the facts that a plan leaves from.
std::string KeyOf(const Present& present) {
  kg_base::Hasher key;
  key.Add(static_cast<double>(present.facts->world_version()));
  key.Add(present.start.fleet.time_s());
  key.Add(static_cast<double>(present.start.executed.size()));
  key.Add(static_cast<double>(present.start.in_force.run));
  for (const auto& [agent, pose] : present.start.fleet.poses()) {
    key.Add(agent);
    for (const double value :
         {pose.position.lon_deg, pose.position.lat_deg, pose.heading_rad,
          pose.time_s, pose.energy_left_j}) {
      key.Add(value);
    }
  }
  return key.Hex();
}

std::shared_ptr<const kg_compiler::Compilation> Compile(
    StartState start, const kg_mission::Mission& mission,
    std::uint64_t world_version, kg_compiler::MissionCompiler* compiler) {
  start.fleet.Follow(mission);
  const int first = FirstWindowToPlan(start, mission);
  if (first >= static_cast<int>(mission.windows.size())) {
    throw InputError("the mission has ended: no window is left to plan");
  }
  return StartFrom(start, *compiler->Compile(mission, world_version, first));
}

}  // namespace

std::shared_ptr<const WhatIf::Base> WhatIf::PlanPresent(
    const Present& present) {
  const std::string key = KeyOf(present);
  if (base_ != nullptr && base_->key == key) return base_;
  kg_compiler::MissionCompiler compiler = present.compiler;
  CompiledPlan world;
  world.compilation =
      Compile(present.start, kg_mission::ReadMission(*present.facts),
              present.facts->world_version(), &compiler);
  world.planned = kg_selector::PlanMission(
      *world.compilation, base_ ? &base_->world.planned : nullptr);
  base_ = std::make_shared<const Base>(
      Base{key, std::move(world), std::move(compiler)});
  return base_;
}

// Processing of one question.
class WhatIf::Inquiry {
 public:
  Inquiry(WhatIf* what_if, const Present& present,
          const WhatIfQuestion& question)
      : what_if_(what_if), present_(present), question_(question) {
    if (question.time_limit_s > 0.0) limit_s_ = question.time_limit_s;
    answer_.world_version = present.facts->world_version();
  }

  WhatIfAnswer Run() {
    try {
      if (Stage()) Answer();
    } catch (const std::runtime_error& error) {  // Bad input, or no threads.
      answer_.errors.push_back(error.what());
    }
    answer_.ok = answer_.errors.empty();
    answer_.text = WhatIfText(answer_);
    return std::move(answer_);
  }

 private:
  // Stages like a real update; false = rejected.
  bool Stage() {
    fork_ = kg_core::Store::Fork(present_.facts);
    kg_core::Transaction transaction = fork_->Begin();
    answer_.errors = kg_mission::StageUpdateWithFiles(
                         question_.update, *what_if_->files_, transaction)
                         .judgement.reasons;
    if (!answer_.errors.empty()) return false;
    mission_ = kg_mission::ReadMission(transaction.view());
    const std::size_t changes =
        transaction.added().size() + transaction.removed().size();
    transaction.Commit(kg_core::WorldChange::kYes);
    EndStage("facts", changes);
    return true;
  }

  void Answer() {
    const std::shared_ptr<const Base> base = what_if_->PlanPresent(present_);
    EndStage("base", base->world.planned.members.size());
    kg_compiler::MissionCompiler compiler = base->compiler;
    CompiledPlan then;
    then.compilation =
        Compile(present_.start, mission_, fork_->world_version(), &compiler);
    EndStage("compile", then.compilation->dirty.size());
    then.planned =
        kg_selector::PlanMission(*then.compilation, &base->world.planned);
    EndStage("plan", then.planned.plan.committed.size());
    const EdgePrices prices(base->world.planned, then);
    ComparePlans(base->world, then, prices, &answer_);
    answer_.plan.run = LoadState(*present_.facts).plan_run + 1;
    EndStage("compare", answer_.edges);
    if (question_.query.empty()) return;
    RecordWorlds(base->world, then, prices);
    RunQuery();
    EndStage("query", 1);
  }

  void RecordWorlds(const CompiledPlan& now, const CompiledPlan& then,
                    const EdgePrices& prices) {
    kg_core::Transaction transaction = fork_->Begin();
    HypotheticalRun run;
    run.number = answer_.plan.run;
    run.executed = present_.start.executed;
    run.graph = kWhatIfPlan;
    RecordCompiledPlan(then, run, &transaction);
    run.number -= 1;
    run.graph = kPresentPlan;
    RecordCompiledPlan(now, run, &transaction);
    RecordPrices(now.planned, prices, kRepriced, &transaction);
    transaction.Commit(kg_core::WorldChange::kNo);
  }

  void RunQuery() {
    kg_core::QueryLimits limits;
    limits.seconds = std::max(0.1, limit_s_ - watch_.Elapsed_s());
    const kg_core::QueryResult result =
        kg_core::RunQuery(*fork_->Read(), question_.query,
                          kg_core::DefaultDataset(kg_core::kPlanGraphPrefix +
                                                  std::string(kWhatIfPlan)),
                          limits);
    const bool is_graph =
        result.form == kg_core::QueryResult::Form::kConstruct ||
        result.form == kg_core::QueryResult::Form::kDescribe;
    answer_.result = is_graph ? kg_core::TriplesToTurtle(result.triples)
                              : kg_core::ResultFormats().front().write(result);
    answer_.text = kg_core::ToTextTable(result);  // Appended after the rest.
  }

  void EndStage(const std::string& stage, std::size_t count) {
    const double now_s = watch_.Elapsed_s();
    answer_.stages.push_back({stage, now_s - last_s_, count});
    last_s_ = now_s;
    if (!(now_s <= limit_s_)) {
      throw InputError("the time limit of " + std::to_string(limit_s_) +
                       " s was over after " + std::to_string(now_s) +
                       " s, at the end of stage \"" + stage + "\"");
    }
  }

  WhatIf* what_if_;
  const Present& present_;
  const WhatIfQuestion& question_;
  double limit_s_ = kDefaultLimit_s;
  const kg_base::Stopwatch watch_;
  double last_s_ = 0.0;
  std::unique_ptr<kg_core::Store> fork_;
  kg_mission::Mission mission_;
  WhatIfAnswer answer_;
};

WhatIfAnswer WhatIf::Ask(const Present& present,
                         const WhatIfQuestion& question) {
  return Inquiry(this, present, question).Run();
}

}  // namespace kg_engine
