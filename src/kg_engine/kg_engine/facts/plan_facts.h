// A plan as facts: the results of planners and selector. The run's own graph
// (ex:graph/plan/<run>) holds the facts of this run only and is deleted with
// it; the provenance graph keeps the facts that later runs may refer to. The
// compiler reads neither, so an assignment never triggers its own
// recompilation.
//
//   ex:plan\/7               a ex:PlanRun ; ex:worldVersion ; ex:status ; ...
//   ex:plan\/7\/select       a ex:SelectRun ; prov:wasInformedBy the planners
//   ex:plan\/7\/alpha\/w2    a ex:Assignment ; ex:forAgent ; ex:forWindow ;
//       ex:waypointWKT ; ex:pathWKT ; ex:pathTimes ; ex:reward ; ex:costHours ;
//       ... ; prov:wasGeneratedBy ; prov:wasDerivedFrom
//   ex:plan\/7\/rejection\/0 a ex:Rejection ; ex:lostTo ; ex:cooling ...
//   ex:plan\/7\/cooling\/0   a ex:CoolingConstraint ; ex:forAgent ;
//       ex:cooledBy ; ex:expires ...
//   ex:plan\/7\/price\/0     a ex:Price ; ex:ofWaypoint or ex:visits ;
//       ex:price ; ...

#ifndef KG_ENGINE_FACTS_PLAN_FACTS_H_
#define KG_ENGINE_FACTS_PLAN_FACTS_H_

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/rdf/term.h"
#include "kg_engine/facts/nav_graph_facts.h"
#include "kg_engine/state/executed_stops.h"
#include "kg_selector/team/committed_plan.h"
#include "kg_selector/team/round_request.h"

namespace kg_engine {

struct PlanRecord {
  kg_selector::CommittedPlan plan;
  std::vector<kg_selector::RecordedRejection> rejections;
  // Constraints of all rounds, each pair of agents once.
  std::vector<kg_selector::CoolingConstraint> cooling;
  std::vector<kg_selector::VisitPrice> prices;  // Prices of the last round.
  std::vector<ExecutedVisit> executed;
  // By agent's ex:id and window.
  std::map<std::pair<std::string, int>, NavGraphStamp> nav_graphs;
  double started_s = 0.0;  // Unix seconds.
  double ended_s = 0.0;
};

// The run, its assignments, rejections and cooling constraints, for its own
// graph and the provenance graph.
std::vector<kg_core::Statement> PlanStatements(
    const PlanRecord& record, const kg_compiler::Compilation& compilation);

}  // namespace kg_engine

#endif  // KG_ENGINE_FACTS_PLAN_FACTS_H_
