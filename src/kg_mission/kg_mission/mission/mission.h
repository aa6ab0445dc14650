// The mission as typed values: facts read once at the boundary of the knowledge
// graph and converted to SI units. Every value type has the IRI of its fact
// (`iri`), so that compiled results can cite it.

#ifndef KG_MISSION_MISSION_MISSION_H_
#define KG_MISSION_MISSION_MISSION_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kg_base/geo/lon_lat.h"
#include "kg_base/geo/wkt.h"
#include "kg_base/raster/resample.h"
#include "kg_core/facts/source_file.h"
#include "kg_mission/mission/constraint_kind.h"
#include "kg_mission/mission/option_names.h"

namespace kg_mission {

// ex:TimeWindow. Windows of a mission are ordered by index, zero-based.
struct TimeWindow {
  std::string iri;
  int index = 0;
  double begin_s = 0.0;     // time:hasBeginning, unix seconds.
  double end_s = 0.0;       // time:hasEnd, or begin + ex:durationHours.
  double confidence = 1.0;  // w_t in [0, 1].
  double duration_s() const { return end_s - begin_s; }
};

// ex:AgentCapabilities.
struct Capabilities {
  std::string iri;
  double cruise_mps = 0.0;      // ex:cruiseSpeedKts, through water.
  double max_mps = 0.0;         // ex:maxSpeedKts.
  double energy_per_m_j = 0.0;  // ex:energyPerKm [Wh/km], through water.
  double hotel_load_w = 0.0;    // ex:hotelLoadW.
  double boost_gain = 1.0;      // ex:boostGain (A17).
  std::optional<double> base_travel_m;  // ex:baseTravel [km], per window.
  double energy_budget_j = 0.0;         // ex:energyBudget [Wh], whole mission.
  double sensor_radius_m = 0.0;  // ex:sensorRadiusKm: footprint of a visit.
};

enum class Normalisation { kMax, kMinMax, kPercentile };
enum class ConfidenceMode { kPost, kPre, kHorizon };  // A1.
enum class FrontOperator { kSobel, kCentral };        // A16.
// Divisor of a value layer before its weight is applied (A16): its largest open
// value in the window, a range stated as a fact, or none.
enum class LayerScale { kWindow, kFixed, kNone };
enum class SoftOverlap { kProduct, kMin };  // A10.

// ex:Policy. Weights are dimensionless; lambdas turn costs into reward units.
struct Policy {
  std::string iri;
  std::string name;
  double alpha_base = 1.0;             // Eq. 1, weight of B_t.
  std::map<std::string, double> beta;  // Eq. 1, keyed by prior layer IRI.
  double beta_poi = 0.0;               // Weight of the event bumps (A42).
  double gamma_front = 0.0;            // Eq. 1, weight of F(B_t).
  double lambda_time_per_s = 0.0;      // ex:lambda_time, per hour.
  double lambda_energy_per_j = 0.0;    // ex:lambda_energy, per Wh.
  double lambda_risk = 0.0;            // Per hour at hazard 1, see SeamRules.
  double lambda_uncertainty = 0.0;     // Multiplies (1 - w).
  // ex:lambda_turn: per radian between the start heading and the course on
  // which the agent leaves its start.
  double lambda_turn_per_rad = 0.0;
  // Reward per second and unit of a cost field, keyed by SourceQuantity::name
  // (ex:lambda_waveHeight, ...); absent = no cost.
  std::map<std::string, double> lambda_fields;
  std::map<std::string, double> soft_overrides;  // Keyed by constraint IRI.
  // IRI of the ex:PriorWeight or ex:SoftOverride that defines an entry of beta
  // or soft_overrides, with the same key.
  std::map<std::string, std::string> weight_iris;
  std::string value_kind = "delta_sst";               // ex:valueKind (A29).
  Normalisation normalisation = Normalisation::kMax;  // A5.
  ConfidenceMode confidence_mode = ConfidenceMode::kPost;  // A1.
  FrontOperator front_operator = FrontOperator::kSobel;    // ex:frontOperator.
  LayerScale layer_scale = LayerScale::kWindow;            // ex:layerScale.
  SoftOverlap soft_overlap = SoftOverlap::kProduct;        // ex:softOverlap.
  // ex:paperLiteral: follow the paper's steps literally. Layers are not scaled,
  // V is not clamped, w_t and both masks are applied before N, and N is min-max
  // over all water cells.
  bool paper_literal = false;
  double hazard_range_m = 10e3;  // ex:hazardRangeKm: hazard falls to 1/e.
  // ex:isolationWeight (A20), part of the hazard.
  double isolation_weight = 0.05;
  // ex:riskBudgetHours: upper bound on the hazard-weighted time over the
  // horizon; [h] in facts, [s] here.
  std::optional<double> hazard_budget_s = std::nullopt;
  bool diverse_paths = false;  // ex:pathChoice "diverse", else "best".
  int minimum_difference = 1;  // ex:minimumDifference [windows], when diverse.
  double churn_weight = 0.0;   // ex:churnWeight (A34), reward per window.
};

// Mobility model, which determines the energy to hold station. Gliders and
// fixed-wing aircraft hold station by moving against the field at its speed, at
// no cost where it is calm. Hovering vehicles spend at least their cruise power
// to stay aloft.
enum class Mobility { kGlider, kFixedWing, kHover };

// ex:Agent with its policy and capabilities.
struct Agent {
  std::string iri;
  std::string id;  // ex:id; names topics, so [a-z][a-z0-9_]*.
  Mobility mobility = Mobility::kGlider;  // ex:mobility.
  Policy policy;
  Capabilities capabilities;
  kg_base::LonLat start;  // Position of the ex:AgentState to start from.
  double start_heading_rad = 0.0;  // Clockwise from north.
  std::string start_iri;
  // ex:energyRemaining of that state; if stated, used instead of
  // energy_budget_j.
  std::optional<double> start_energy_j = std::nullopt;
  // ex:mustAvoid (A11): soft constraints that are hard for this agent, keyed by
  // IRI, with the sources: the agent's IRI if asserted, and the IRIs of the
  // inferences (rules/reasons.h) that conclude it.
  std::map<std::string, std::vector<std::string>> must_avoid;
};

// ex:gridRef: a raster in a file. It holds the values of a prior, or a mask
// (nonzero = inside; no data = outside).
struct RasterRef {
  std::string file_iri;  // An ex:SourceFile of the mission.
  std::string variable;
  int time_index = 0;  // For variables with a time axis.
  kg_base::Resampling resampling =
      kg_base::Resampling::kNone;  // ex:resampling (A54).
};

enum class BufferMetric { kEuclidean, kChebyshev };  // A15.

// ex:Constraint: an area, the land of the work field (ex:gridRef "land"), or a
// mask read from a file.
struct Constraint {
  std::string iri;
  ConstraintKind kind = ConstraintKind::kNoGo;
  std::optional<kg_base::Geometry>
      area;  // Exactly one of area, is_land and mask.
  bool is_land = false;
  std::optional<RasterRef> mask;
  double buffer_cells = 0.0;  // ex:bufferCells (A15).
  BufferMetric buffer_metric = BufferMetric::kEuclidean;  // ex:bufferMetric.
  double attenuation = 1.0;         // Soft constraints: factor inside (A10).
  std::vector<int> windows;         // ex:appliesIn; empty = all (A28).
  std::vector<std::string> agents;  // ex:appliesTo, IRIs; empty = all.
  bool AppliesTo(const std::string& agent_iri, int window) const;
};

// ex:PriorLayer: a spatial preference, 1 inside its area, 0 outside, with an
// optional soft edge; or an unscaled raster (no data counts as 0; values may be
// negative).
struct PriorLayer {
  std::string iri;
  std::string name;
  std::optional<kg_base::Geometry> area;  // Exactly one of area and raster.
  double edge_m = 0.0;              // ex:edgeKm: Gaussian fall-off outside.
  std::vector<int> windows;         // Empty = all.
  std::vector<std::string> agents;  // Empty = all.
  std::optional<RasterRef> raster = std::nullopt;  // ex:gridRef.
};

// ex:Event: a discrete point of interest in space and time.
struct Event {
  std::string iri;
  kg_base::LonLat position;
  double value = 0.0;        // Reward of a visit, multiplied by confidence.
  int capacity = 1;          // Number of distinct agents rewarded.
  double radius_m = 0.0;     // ex:radiusKm: bump sigma, visit distance.
  std::vector<int> windows;  // ex:forWindow and later ones until expiry.
};

// The kinds of value layer, as functions of the temperature T (A14).
inline constexpr char kDifferenceKind[] = "delta_sst";  // |T(t) - T(t-1 day)|.
inline constexpr char kPlainKind[] = "sst";             // T.
inline constexpr char kFrontnessKind[] = "frontness";   // |grad T| per km.

// ex:ValueLayer of a window: how B_t is computed from files.
struct ValueLayer {
  std::string iri;
  int window = 0;
  std::string kind;      // One of the kinds above.
  std::string file_iri;  // prov:wasDerivedFrom, an ex:SourceFile.
  int time_index = 0;    // In that file; delta_sst: |this - previous|.
  int previous_time_index = 0;
  // ex:fullScale, ex:frontFullScale: divisors used by LayerScale::kFixed for
  // the layer [its unit] and for its frontness [unit per km].
  std::optional<double> full_scale = std::nullopt;
  std::optional<double> front_full_scale = std::nullopt;
  kg_base::Resampling resampling =
      kg_base::Resampling::kNone;  // ex:resampling (A54).
  // sosa:resultTime of step time_index, Unix seconds.
  std::optional<double> time_s = std::nullopt;
};

// ex:WorkField (ex:CurrentField) of a window.
struct WorkFieldRef {
  std::string iri;
  int window = 0;
  std::string file_iri;
  int first_time_index = 0;  // Slices that cover the window.
  int last_time_index = 0;
};

// ex:CostField of a window: a scalar encountered along the flight
// (source_quantities.h).
struct CostFieldRef {
  std::string iri;
  int window = 0;
  std::string quantity;  // SourceQuantity::name, by sosa:observedProperty.
  std::string file_iri;
  int first_time_index = 0;  // Slices that cover the window.
  int last_time_index = 0;
  kg_base::Resampling resampling =
      kg_base::Resampling::kNone;  // ex:resampling (A54).
};

// Options of team coordination: properties of ex:Mission.
struct CoordinationFacts {
  std::string mode = kTeamModeNames[0];  // ex:teamMode, see option_names.h.
  // ex:gapGoal: relative gap to the bound (fraction of the bound) at which no
  // further round is run.
  double gap_goal = 0.01;
  double auction_epsilon = 0.05;             // ex:auctionEpsilon, reward.
  double select_limit_s = 2.0;               // ex:selectTimeLimitS.
  std::string fairness = kFairnessNames[0];  // ex:fairness.
  double fairness_weight = 0.0;              // ex:fairnessWeight, reward.
  double separation_m = 0.0;                 // ex:minimumSeparationKm.
  bool separation_is_hard = true;            // ex:separationIsHard.
  double separation_weight = 0.0;            // ex:separationWeight, when soft.
  int candidates_per_agent = 10;             // ex:candidatesPerAgent (K).
  int waypoints_per_window = 20;    // ex:waypointsPerWindow, at most 20.
  double waypoint_spacing_m = 0.0;  // ex:waypointSpacingKm; PR's disc.
  int max_rounds = 8;               // ex:maxCoolingRounds.
  // ex:movementMode (A22): "hops" visits one waypoint per window, "edges" a
  // path of several waypoints within a window.
  std::string movement_mode = kMovementModeNames[0];
};
bool operator==(const CoordinationFacts& a, const CoordinationFacts& b);

struct Mission {
  std::string iri;
  std::string name;
  std::vector<TimeWindow> windows;      // Sorted by index, contiguous from 0.
  std::vector<Agent> agents;            // Sorted by id.
  std::vector<Constraint> constraints;  // Sorted by IRI, as all below.
  std::vector<PriorLayer> priors;
  std::vector<Event> events;
  std::vector<ValueLayer> value_layers;
  std::vector<WorkFieldRef> work_fields;
  std::vector<CostFieldRef> cost_fields;
  std::map<std::string, kg_core::SourceFile> files;  // Keyed by IRI.
  CoordinationFacts coordination;

  const Agent* FindAgent(const std::string& iri) const;
};

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_MISSION_H_
