# Hypothesis: every agent's energy budget is reduced by 30 %.
# Use with what_if_energy_budget.rq.
PREFIX ex: <http://example.org/mission/>
DELETE { ?can ex:energyBudget ?budget_wh }
INSERT { ?can ex:energyBudget ?less_wh }
WHERE {
  ?can a ex:AgentCapabilities ; ex:energyBudget ?budget_wh .
  BIND(0.7 * ?budget_wh AS ?less_wh)
}
