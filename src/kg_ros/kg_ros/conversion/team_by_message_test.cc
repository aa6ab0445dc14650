// A team whose planners and selector exchange only serialized messages,
// delayed, duplicated and reordered: it commits the same plan as a single
// process, in every mode.

#include <deque>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_engine/planning/agent_planner.h"
#include "kg_engine/planning/team_selector.h"
#include "kg_engine/server/mission_server.h"
#include "kg_engine/server/testing/test_mission.h"
#include "kg_engine/server/testing/test_team.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/conversion/tensor_conversion.h"
#include "kg_selector/team/coordinator.h"
#include "kg_selector/team/plan_mission.h"
#include "kg_selector/team/team_modes.h"
#include "ros/serialization.h"

namespace kg_ros {
namespace {

using kg_compiler::Compilation;

template <typename Message>
Message ByWire(const Message& message) {
  const ros::SerializedMessage bytes =
      ros::serialization::serializeMessage(message);
  Message copy;
  ros::serialization::deserializeMessage(bytes, copy);
  return copy;
}

class Wire {
 public:
  Wire(const Compilation& compilation, std::uint64_t cycle, unsigned seed)
      : random_(seed) {
    for (const kg_compiler::SeamRules& rules : compilation.rules) {
      Prepare(compilation, rules, cycle);
    }
    selector_.KnowRun(4);
    rules_ = ByWire(ToMessage(CoordinationOf(compilation, cycle)));
    for (auto& [agent, planner] : planners_) {
      Post(ToMessage(planner.Plan().candidates));
    }
    Hear(selector_.Take(ToTask(rules_)));
    while (!letters_.empty()) Deliver();
  }

  // After the end of the run, how many requests would still be answered.
  int AnsweredTooLate() {
    int answered = 0;
    for (const kg_msgs::RoundRequest& request : requests_) {
      for (auto& [agent, planner] : planners_) {
        answered += planner.PlanAgain(FromMessage(request)).has_value();
      }
    }
    return answered;
  }

  const kg_msgs::Assignments& plan() const { return plan_; }
  int asked() const { return asked_; }
  int plans() const { return plans_; }

 private:
  struct Letter {
    std::string to;  // Empty: the selector.
    std::variant<kg_msgs::Candidates, kg_msgs::RoundRequest,
                 kg_msgs::Rejections>
        message;
  };

  void Prepare(const Compilation& compilation,
               const kg_compiler::SeamRules& rules, std::uint64_t cycle) {
    using kg_compiler::Layer;
    kg_engine::AgentPlanner& planner = planners_[rules.agent_id];
    planner.Take(FromMessage(ByWire(ToMessage(rules, cycle))), cycle);
    for (const auto& field : compilation.fields) {
      planner.Take(std::make_shared<const kg_compiler::WorkField>(
          FromMessage(ByWire(ToMessage(*field, compilation.world_version)))));
    }
    for (const auto& tensor : compilation.tensors) {
      if (tensor->agent_iri != rules.agent_iri) continue;
      const kg_msgs::MissionTensor message =
          ToMessage(*tensor, rules.agent_id, compilation.world_version,
                    {Layer::kFused, Layer::kFeasibility, Layer::kAttenuation});
      planner.Take(std::make_shared<const kg_compiler::MissionTensor>(
          FromMessage(ByWire(message))));
    }
    ASSERT_TRUE(planner.IsComplete()) << planner.Missing();
  }

  void Post(const kg_msgs::Candidates& candidates) {
    for (unsigned i = 0; i <= random_() % 2; ++i) {
      letters_.push_back({"", ByWire(candidates)});
    }
  }
  template <typename Message>
  void PostToPlanners(const Message& message) {
    for (const auto& [agent, planner] : planners_) {
      letters_.push_back({agent, ByWire(message)});
      if (random_() % 3 == 0) letters_.push_back(letters_.back());
    }
  }

  void Deliver() {
    std::swap(letters_[random_() % letters_.size()], letters_.back());
    const Letter letter = std::move(letters_.back());
    letters_.pop_back();
    std::visit([&](const auto& message) { Read(letter.to, message); },
               letter.message);
  }

  void Read(const std::string& /*selector*/,
            const kg_msgs::Candidates& candidates) {
    Hear(selector_.Take(FromMessage(candidates)));
  }
  void Read(const std::string& agent, const kg_msgs::Rejections& rejections) {
    planners_.at(agent).Take(FromMessage(rejections));
  }
  void Read(const std::string& agent, const kg_msgs::RoundRequest& request) {
    const auto answer = planners_.at(agent).PlanAgain(FromMessage(request));
    if (!answer) return;
    EXPECT_TRUE(answer->graphs.empty());
    Post(ToMessage(answer->candidates));
  }

  void Hear(const kg_engine::SelectorAnswer& said) {
    if (said.plan) plan_ = ByWire(ToMessage(*said.plan));
    plans_ += said.plan.has_value();
    asked_ += said.request.has_value();
    if (said.request) {
      requests_.push_back(ByWire(ToMessage(*said.request)));
      PostToPlanners(requests_.back());
    }
    if (said.end) PostToPlanners(ToMessage(*said.end));
  }

  std::mt19937 random_;
  std::map<std::string, kg_engine::AgentPlanner> planners_;
  kg_engine::TeamSelector selector_;
  kg_msgs::CoordinationRules rules_;
  std::deque<Letter> letters_;
  std::vector<kg_msgs::RoundRequest> requests_;
  kg_msgs::Assignments plan_;
  int asked_ = 0;
  int plans_ = 0;
};

class TeamByMessageTest : public testing::TestWithParam<const char*> {
 protected:
  TeamByMessageTest() {
    server_ = kg_engine::StartTestServer(folder_);
    kg_core::FactUpdate join;
    join.author = "operator";
    join.turtle = kg_engine::kSecondAgent;
    join.set = {{"ex:mission", "ex:minimumSeparationKm", "5"},
                {"ex:mission", "ex:gapGoal", "0"}};
    Apply(join);
  }

  void Apply(const kg_core::FactUpdate& update) {
    const kg_engine::Decision decision = server_->Apply(update);
    ASSERT_TRUE(decision.accepted) << decision.reasons.at(0);
  }

  void ChooseBy(const std::string& mode) {
    kg_core::FactUpdate choose;
    choose.author = "operator";
    choose.set = {{"ex:mission", "ex:teamMode", "\"" + mode + "\""}};
    Apply(choose);
  }

  kg_base::TemporaryFolder folder_;
  std::unique_ptr<kg_engine::MissionServer> server_;
};

bool IsAvailable(const std::string& mode) {
  kg_selector::TeamRules rules;
  rules.mode = mode;
  try {
    kg_selector::MakeCoordinator(rules, {"alpha"});
    return true;
  } catch (const kg_base::InputError&) {
    return false;
  }
}

TEST(TeamByMessage, GreedyIsAlwaysThere) { EXPECT_TRUE(IsAvailable("greedy")); }

TEST_P(TeamByMessageTest, CommitsWhatOneProcessPlans) {
  if (!IsAvailable(GetParam())) GTEST_SKIP() << "no such mode";
  ChooseBy(GetParam());
  const auto compilation = server_->BeginCycle();
  const kg_selector::PlannedMission planned =
      kg_selector::PlanMission(*compilation, nullptr);
  const kg_msgs::Assignments expected =
      ToMessage(kg_selector::ToCommittedPlan(planned));
  ASSERT_EQ(expected.assignments.size(), 2u);
  for (unsigned seed = 0; seed < 10; ++seed) {
    Wire wire(*compilation, server_->cycle(), seed);
    const kg_msgs::Assignments& plan = wire.plan();
    EXPECT_EQ(wire.plans(), 1);
    EXPECT_GT(wire.asked(), 0);
    EXPECT_EQ(wire.AnsweredTooLate(), 0);
    EXPECT_EQ(plan.mode, GetParam());
    EXPECT_EQ(plan.rounds, expected.rounds);
    EXPECT_EQ(plan.unassigned, expected.unassigned);
    EXPECT_NEAR(plan.bound, expected.bound, 1e-9);
    EXPECT_NEAR(plan.reward, expected.reward, 1e-9);
    EXPECT_NEAR(plan.seam_cost, expected.seam_cost, 1e-9);
    ASSERT_EQ(plan.assignments.size(), expected.assignments.size());
    for (std::size_t i = 0; i < plan.assignments.size(); ++i) {
      EXPECT_EQ(plan.assignments[i].agent, expected.assignments[i].agent);
      EXPECT_EQ(plan.assignments[i].pathlet.visits,
                expected.assignments[i].pathlet.visits);
      EXPECT_EQ(plan.assignments[i].pathlet.energy_j,
                expected.assignments[i].pathlet.energy_j);
    }
    EXPECT_GE(plan.bound, plan.reward - plan.seam_cost - 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, TeamByMessageTest,
                         testing::Values("greedy", "auction", "priced",
                                         "exact"),
                         [](const auto& info) {
                           return std::string(info.param);
                         });

}  // namespace
}  // namespace kg_ros
