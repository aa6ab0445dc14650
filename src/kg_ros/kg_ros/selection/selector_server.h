// The team's coordination, without ROS topics: collects everybody's candidates
// of one cycle, asks for others as the team's mode wants them, round by round,
// and commits one plan. Which mode that is, only MakeCoordinator() knows.

#ifndef KG_ROS_SELECTION_SELECTOR_SERVER_H_
#define KG_ROS_SELECTION_SELECTOR_SERVER_H_

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kg_msgs/Assignments.h"
#include "kg_msgs/Candidates.h"
#include "kg_msgs/CoordinationRules.h"
#include "kg_msgs/Rejections.h"
#include "kg_selector/team/coordinator.h"

namespace kg_ros {

// What is to be said after a step.
struct SelectorAnswer {
  std::optional<kg_msgs::Rejections> rejections;
  std::optional<kg_msgs::Assignments> assignments;
};

class SelectorServer {
 public:
  // A new cycle begins. Throws kg_core::InputError (unknown mode, ...).
  SelectorAnswer Take(const kg_msgs::CoordinationRules& message);
  // In any order, also before the rules of their cycle are here. Throws
  // kg_core::InputError, and nothing has changed, if they make no sense.
  SelectorAnswer Take(const kg_msgs::Candidates& message);
  // Runs get numbers above this one: the number of the last run known. Nothing
  // is decided before it is.
  SelectorAnswer KnowRun(std::uint64_t run);

  // Who is waited for, since when nothing has come [unix s]; empty = nobody.
  std::vector<std::string> WaitingFor() const;
  double waiting_since_s() const { return waiting_since_s_; }
  // Goes on without those who are waited for.
  SelectorAnswer GiveUpWaiting();

 private:
  void Begin(std::unique_ptr<kg_selector::Coordinator> team);
  void Offer(const kg_msgs::Candidates& message,
             kg_selector::AgentOffer candidates);
  SelectorAnswer Step();
  kg_msgs::Rejections Ask();
  kg_msgs::Rejections End() const;
  kg_msgs::Assignments Plan();
  kg_msgs::Assignment Assign(const kg_selector::Pathlet& pathlet) const;
  template <typename Message>
  Message Header() const;

  std::optional<kg_msgs::CoordinationRules> rules_;
  kg_selector::TeamRules team_rules_;
  std::unique_ptr<kg_selector::Coordinator> team_;
  // Round 0 of the newest cycle heard of, by agent: kept for a fresh start.
  std::map<std::string, kg_msgs::Candidates> unmasked_;
  // The last message of every agent.
  std::map<std::string, kg_msgs::Candidates> offered_;
  // The message behind every pathlet that was offered: by agent, and by the
  // places it goes by, on which costs and track depend alone.
  using Places = std::vector<std::uint32_t>;
  std::map<std::pair<std::string, Places>, kg_msgs::Pathlet> pathlets_;
  std::uint32_t round_ = 0;
  std::uint64_t run_ = 0;       // Under way or just finished.
  std::uint64_t last_run_ = 0;  // The highest finished one heard of.
  bool knows_last_run_ = false;
  bool finished_ = false;
  std::vector<kg_selector::Pathlet> last_plan_;  // Committed before this one.
  double began_s_ = 0.0;                         // Unix seconds; of the cycle.
  double complete_s_ = 0.0;  // When everybody's round 0 was here.
  double waiting_since_s_ = 0.0;
};

}  // namespace kg_ros

#endif  // KG_ROS_SELECTION_SELECTOR_SERVER_H_
