#include "kg_ros/conversion/ask_conversion.h"

#include <algorithm>
#include <cmath>

#include "kg_core/base/input_error.h"
#include "kg_ros/conversion/plan_conversion.h"

namespace kg_ros {
namespace {

using kg_selector::Pathlet;
using kg_selector::PlanRequest;

void AddPrices(const std::string& agent, const PlanRequest& ask,
               kg_msgs::Rejections* message) {
  for (const kg_selector::WaypointPrice& price : ask.waypoint_prices) {
    message->prices.emplace_back();
    message->prices.back().agent = agent;
    message->prices.back().window = price.window;
    message->prices.back().waypoint = price.waypoint;
    message->prices.back().price = price.price;
  }
  for (const auto& [event, price] : ask.event_prices) {
    message->prices.emplace_back();
    message->prices.back().agent = agent;
    message->prices.back().window = -1;
    message->prices.back().event = event;
    message->prices.back().price = price;
  }
}

void TakePrice(const kg_msgs::Price& price, PlanRequest* ask) {
  if (!std::isfinite(price.price) || !(price.price >= 0.0)) {
    throw kg_core::InputError("Price.price must be a finite number >= 0");
  }
  if (!price.event.empty()) {
    ask->event_prices[price.event] = price.price;
    return;
  }
  ask->waypoint_prices.push_back(
      {price.window, static_cast<int>(price.waypoint), price.price});
}

void TakeCooling(const kg_msgs::Cooling& cooling, AskedOf* asked) {
  asked->separation_m = cooling.separation_m;
  asked->ask.full_events.insert(cooling.full_events.begin(),
                                cooling.full_events.end());
  if (cooling.track.empty()) return;
  Pathlet pathlet;
  pathlet.agent = cooling.by_agent;
  pathlet.track = FromMessage(cooling.track);
  asked->ask.around.push_back(pathlet);
}

}  // namespace

void AddAsk(const std::string& agent, const PlanRequest& ask,
            const kg_selector::TeamRules& rules, kg_msgs::Rejections* message) {
  message->asked.push_back(agent);
  kg_msgs::Cooling cooling;
  cooling.agent = agent;
  cooling.separation_m = rules.separation_is_hard ? rules.separation_m : 0.0;
  cooling.factor = 0.0;
  cooling.expires = message->header.stamp;
  cooling.full_events.assign(ask.full_events.begin(), ask.full_events.end());
  for (const Pathlet& pathlet : ask.around) {
    cooling.by_agent = pathlet.agent;
    cooling.track = ToMessage(pathlet.track);
    message->cooling.push_back(cooling);
  }
  if (ask.around.empty() && !ask.full_events.empty()) {
    message->cooling.push_back(cooling);  // Full, whoever it was.
  }
  AddPrices(agent, ask, message);
}

std::optional<AskedOf> AskOf(const kg_msgs::Rejections& message,
                             const std::string& agent) {
  if (std::count(message.asked.begin(), message.asked.end(), agent) == 0) {
    return std::nullopt;
  }
  AskedOf asked;
  for (const kg_msgs::Cooling& cooling : message.cooling) {
    if (cooling.agent == agent) TakeCooling(cooling, &asked);
  }
  for (const kg_msgs::Price& price : message.prices) {
    if (price.agent.empty() || price.agent == agent) {
      TakePrice(price, &asked.ask);
    }
  }
  return asked;
}

}  // namespace kg_ros
