// The team's coordination: collects all agents' candidates of one cycle,
// requests others as the team mode requires, round by round, and commits one
// plan. Only MakeCoordinator() depends on the mode.

#ifndef KG_ENGINE_PLANNING_TEAM_SELECTOR_H_
#define KG_ENGINE_PLANNING_TEAM_SELECTOR_H_

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_selector/team/agent_candidates.h"
#include "kg_selector/team/committed_plan.h"
#include "kg_selector/team/coordinator.h"
#include "kg_selector/team/round_request.h"

namespace kg_engine {

// The team's planning task in a cycle.
struct TeamTask {
  std::uint64_t world_version = 0;
  std::uint64_t cycle = 0;
  std::vector<std::string> agents;  // ex:id.
  kg_selector::TeamRules rules;
};
TeamTask ToTeamTask(const kg_compiler::Compilation& compilation,
                    std::uint64_t cycle);

// Output of a step: a request to replan, or the plan and the end of its run.
struct SelectorAnswer {
  std::optional<kg_selector::RoundRequest> request;
  std::optional<kg_selector::RunEnd> end;
  std::optional<kg_selector::CommittedPlan> plan;
};

class TeamSelector {
 public:
  // A new cycle begins. Throws kg_base::InputError (unknown mode, ...).
  SelectorAnswer Take(const TeamTask& task);
  // Accepts candidates in any order, also before the task of their cycle.
  SelectorAnswer Take(const kg_selector::AgentCandidates& candidates);
  // Runs get numbers above this one: the number of the last run known. Nothing
  // is decided before it is. If the run under way gets another number by this,
  // its last request is repeated under it: the requests and the end of a run
  // are matched by number.
  SelectorAnswer KnowRun(std::uint64_t run);

  // Agents waited for, and the time since which nothing has arrived [Unix s];
  // empty = none.
  std::vector<std::string> WaitingFor() const;
  double waiting_since_s() const { return waiting_since_s_; }
  // Proceeds without the agents waited for.
  SelectorAnswer GiveUpWaiting();

  // The planner of an agent has died. One that dies kMaxDeaths times without an
  // answer in between is not waited for, in this cycle and the next ones, until
  // it answers: what makes it die is probably the input itself.
  static constexpr int kMaxDeaths = 2;
  SelectorAnswer CountDeath(const std::string& agent);
  // Deaths since the agent's last answer.
  int Deaths(const std::string& agent) const;
  // The input that the planners of this cycle work on, for the log.
  std::string LastInput() const;

 private:
  // Data of an agent's last answer, apart from its pathlets.
  struct Offered {
    std::string agent_iri;
    std::string note;
  };

  void Begin(std::unique_ptr<kg_selector::Coordinator> team);
  void DropDeadPlanners();
  void Offer(const kg_selector::AgentCandidates& candidates);
  SelectorAnswer Step();
  kg_selector::RoundRequest Ask();
  kg_selector::RunEnd End() const;
  kg_selector::CommittedPlan Plan();
  template <typename Value>
  Value Header() const;

  std::optional<TeamTask> task_;
  std::unique_ptr<kg_selector::Coordinator> team_;
  // Round 0 answers of the newest cycle, by agent: kept for a restart of the
  // coordination.
  std::map<std::string, kg_selector::AgentCandidates> unmasked_;
  std::map<std::string, Offered> offered_;  // By agent.
  std::map<std::string, int> deaths_;       // By agent; see Deaths().
  kg_selector::RoundRequest request_;       // Last.
  std::uint32_t round_ = 0;
  std::uint64_t run_ = 0;       // Current or just finished run.
  std::uint64_t last_run_ = 0;  // Highest finished run known.
  bool knows_last_run_ = false;
  bool finished_ = false;
  std::vector<kg_selector::Pathlet> last_plan_;  // Previous committed plan.
  double began_s_ = 0.0;                         // Begin of the cycle [Unix s].
  double complete_s_ = 0.0;  // Time when all round 0 answers were in.
  double waiting_since_s_ = 0.0;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_PLANNING_TEAM_SELECTOR_H_
