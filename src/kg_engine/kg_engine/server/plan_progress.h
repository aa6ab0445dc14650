// Progress of the current cycle's plan: the parts that have arrived, whether it
// is complete, and its record.

#ifndef KG_ENGINE_SERVER_PLAN_PROGRESS_H_
#define KG_ENGINE_SERVER_PLAN_PROGRESS_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kg_engine/facts/plan_facts.h"
#include "kg_engine/planning/agent_graph.h"
#include "kg_selector/team/committed_plan.h"
#include "kg_selector/team/round_request.h"

namespace kg_engine {

class PlanProgress {
 public:
  using Key = std::pair<std::string, int>;  // Agent's ex:id, window.

  // Starts a new cycle: answers to older ones are dropped and counted from now
  // on.
  void Begin(std::uint64_t cycle);

  // False if the value belongs to another cycle.
  bool Take(const kg_selector::CommittedPlan& plan);
  bool Take(const kg_selector::RoundRequest& request);
  bool Take(const kg_selector::RunEnd& end);
  bool Take(const AgentGraph& graph);

  // The plan, once, when it, the end of the same run and the request of its
  // last round are here, in whichever order they came.
  std::optional<kg_selector::CommittedPlan> TakeFinishedPlan();
  // Record of a plan that was taken, with the data that arrived for it. The
  // caller adds times and executed stops.
  PlanRecord MakeRecord(const kg_selector::CommittedPlan& plan) const;

  const std::vector<kg_selector::RecordedRejection>& rejections() const {
    return end_.rejections;
  }
  // At which agents were last asked to plan; as in their requests.
  std::vector<kg_selector::VisitPrice> prices() const {
    return RequestsOf(last_asked_run_).prices;
  }

  // Graphs of this cycle, by agent and window.
  const std::map<Key, AgentGraph>& graphs() const { return graphs_; }
  // Hash of the agent's graph of the previous window; empty if not received.
  std::string HashBefore(const AgentGraph& graph) const;
  // The next graph not yet recorded.
  const AgentGraph* NextUnrecorded();
  std::uint64_t dropped() const { return dropped_; }

 private:
  // Requests sent to the agents in one planning run.
  struct RunRequests {
    std::uint32_t last_round = 0;
    // Latest cooling constraint by cooled agent and committed agent.
    std::map<std::pair<std::string, std::string>,
             kg_selector::CoolingConstraint>
        cooling;
    std::vector<kg_selector::VisitPrice> prices;  // Last round.
  };

  template <typename Value>
  bool IsCurrent(const Value& value);
  bool IsFinished() const;
  // Requests of a run; empty if no agent was asked to plan again.
  RunRequests RequestsOf(std::uint64_t run) const;

  std::uint64_t cycle_ = 0;
  std::uint64_t dropped_ = 0;
  std::optional<kg_selector::CommittedPlan> plan_;
  kg_selector::RunEnd end_;
  // Requests of this cycle by run: a restarted selector or a reconnected
  // planner begins another run of the same cycle.
  std::map<std::uint64_t, RunRequests> requests_;
  std::uint64_t last_asked_run_ = 0;
  std::map<Key, AgentGraph> graphs_;
  std::vector<Key> unrecorded_;
};

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_PLAN_PROGRESS_H_
