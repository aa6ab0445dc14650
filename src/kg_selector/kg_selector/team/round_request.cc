#include "kg_selector/team/round_request.h"

#include <algorithm>
#include <cmath>

#include "kg_base/common/input_error.h"

namespace kg_selector {
namespace {

void AddPrices(const std::string& agent, const PlanRequest& ask,
               RoundRequest* request) {
  for (const WaypointPrice& price : ask.waypoint_prices) {
    request->prices.push_back(
        {agent, price.window, price.waypoint, "", price.price});
  }
  for (const auto& [event, price] : ask.event_prices) {
    request->prices.push_back({agent, -1, 0, event, price});
  }
}

void TakePrice(const VisitPrice& price, PlanRequest* ask) {
  if (!std::isfinite(price.price) || !(price.price >= 0.0)) {
    throw kg_base::InputError("Price.price must be a finite number >= 0");
  }
  if (!price.event.empty()) {
    ask->event_prices[price.event] = price.price;
    return;
  }
  ask->waypoint_prices.push_back({price.window, price.waypoint, price.price});
}

void TakeCooling(const CoolingConstraint& cooling, AskedOf* asked) {
  asked->separation_m = cooling.separation_m;
  asked->ask.full_events.insert(cooling.full_events.begin(),
                                cooling.full_events.end());
  if (cooling.track.empty()) return;
  Pathlet pathlet;
  pathlet.agent = cooling.by_agent;
  pathlet.track = cooling.track;
  asked->ask.around.push_back(pathlet);
}

}  // namespace

bool HasEnded(const RoundRequest& request, const RunEnd& end) {
  return end.cycle == request.cycle && end.run >= request.run &&
         end.time_s >= request.time_s;
}

void AddAsk(const std::string& agent, const PlanRequest& ask,
            const TeamRules& rules, RoundRequest* request) {
  request->asked.push_back(agent);
  CoolingConstraint cooling;
  cooling.agent = agent;
  cooling.separation_m = rules.separation_is_hard ? rules.separation_m : 0.0;
  cooling.factor = 0.0;
  cooling.expires_s = request->time_s;
  cooling.full_events.assign(ask.full_events.begin(), ask.full_events.end());
  for (const Pathlet& pathlet : ask.around) {
    cooling.by_agent = pathlet.agent;
    cooling.track = pathlet.track;
    request->cooling.push_back(cooling);
  }
  if (ask.around.empty() && !ask.full_events.empty()) {
    // Full events, regardless of the visitors.
    request->cooling.push_back(cooling);
  }
  AddPrices(agent, ask, request);
}

std::optional<AskedOf> AskOf(const RoundRequest& request,
                             const std::string& agent) {
  if (std::count(request.asked.begin(), request.asked.end(), agent) == 0) {
    return std::nullopt;
  }
  AskedOf asked;
  for (const CoolingConstraint& cooling : request.cooling) {
    if (cooling.agent == agent) TakeCooling(cooling, &asked);
  }
  for (const VisitPrice& price : request.prices) {
    if (price.agent.empty() || price.agent == agent) {
      TakePrice(price, &asked.ask);
    }
  }
  return asked;
}

}  // namespace kg_selector
