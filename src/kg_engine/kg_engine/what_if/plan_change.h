// The difference between the plans of two worlds, as answered by kg/what_if.

#ifndef KG_ENGINE_WHAT_IF_PLAN_CHANGE_H_
#define KG_ENGINE_WHAT_IF_PLAN_CHANGE_H_

#include "kg_engine/what_if/edge_prices.h"
#include "kg_engine/what_if/what_if_answer.h"

namespace kg_engine {

// Fills dirty, plan, reward_change, energy_change_j, paths, edges... and
// changed_edges of `answer`.
void ComparePlans(const CompiledPlan& now, const CompiledPlan& then,
                  const EdgePrices& prices, WhatIfAnswer* answer);

}  // namespace kg_engine

#endif  // KG_ENGINE_WHAT_IF_PLAN_CHANGE_H_
