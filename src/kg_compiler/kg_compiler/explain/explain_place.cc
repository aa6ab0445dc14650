#include "kg_compiler/explain/explain_place.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "kg_base/common/join_strings.h"
#include "kg_base/common/units.h"
#include "kg_base/geo/geodesy.h"
#include "kg_base/geo/wkt.h"
#include "kg_compiler/data_plane/distance_transform.h"
#include "kg_compiler/data_plane/masks.h"
#include "kg_compiler/traversal/traversal.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_compiler {
namespace {

using kg_base::kInfinity;
// Largest number of times that the search doubles the window's length.
constexpr int kMaxDoublings = 5;

std::string Hours(double seconds) {
  return Short(seconds / kg_base::kSecondsPerHour) + " h";
}

class Place {
 public:
  Place(const PlaceQuestion& question, const CitedFacts& facts)
      : in_(question),
        facts_(facts),
        rasters_(*question.tensor.rasters),
        active_(FindActiveFacts(*in_.tensor.mission, *in_.tensor.agent,
                                *in_.tensor.window)),
        open_(OpenCells(rasters_, active_.constraints)) {
    for (const auto& field : in_.seam.compilation->fields) {
      if (field->window == in_.seam.window->window) field_ = &field->field;
    }
  }

  std::optional<Explanation> Explain() {
    const std::optional<kg_base::Cell> cell = rasters_.grid.CellAt(in_.place);
    if (!cell) return OffTheGrid();
    cell_ = *cell;
    if (!open_[rasters_.grid.Index(cell_)]) return Forbidden();
    if (field_ == nullptr || CanBeFlownTo()) return std::nullopt;
    if (std::optional<Explanation> far = TooFar()) return far;
    return Unholdable();
  }

 private:
  Explanation Named(const char* verdict, const char* unit,
                    const std::string& why) const {
    Explanation explanation;
    explanation.verdict = verdict;
    explanation.unit = unit;
    explanation.text = in_.tensor.agent->id + " cannot be at " +
                       kg_base::PointWkt(in_.place) + " in window " +
                       std::to_string(in_.tensor.window->index) + ": " + why;
    return explanation;
  }

  Explanation OffTheGrid() const {
    Explanation explanation =
        Named("forbidden", "m", "it lies outside of the work field's grid.");
    explanation.parts.push_back({0.0, "grid", facts_.Layer(rasters_.field_iri),
                                 "the grid ends before it"});
    return explanation;
  }

  // Areas -------------------------------------------------------------------

  double MetresToOpen(const kg_base::Mask& open) const {
    const double d_m =
        DistanceTo_m(rasters_.grid, open)[rasters_.grid.Index(cell_)];
    return std::isfinite(d_m) ? d_m : 0.0;
  }

  Explanation Forbidden() const {
    Explanation explanation = Named("forbidden", "m", "");
    // Add the constraints one by one: each contributes the increase of the
    // distance to the nearest open cell.
    std::vector<ActiveConstraint> so_far;
    double before_m = MetresToOpen(OpenCells(rasters_, {}));
    std::vector<std::string> names;
    if (rasters_.land[rasters_.grid.Index(cell_)]) {
      explanation.parts.push_back({before_m, "M_hard(land)",
                                   facts_.Layer(rasters_.field_iri),
                                   facts_.NoData(rasters_.field_iri)});
      names.push_back("land");
    }
    for (const ActiveConstraint& constraint : active_.constraints) {
      if (!constraint.forbids() || !Holds(constraint)) continue;
      so_far.push_back(constraint);
      const double after_m = MetresToOpen(OpenCells(rasters_, so_far));
      const std::string iri = kg_core::AbbreviateIri(constraint.fact->iri);
      explanation.parts.push_back(
          {after_m - before_m, "M_hard(" + iri + ")",
           facts_.Constraint(*in_.tensor.agent, constraint),
           "forbidden by " + iri});
      before_m = after_m;
      names.push_back(iri);
    }
    explanation.value = before_m;
    explanation.text += "it is forbidden by " + kg_base::JoinStrings(names) +
                        ", " + Short(before_m / kg_base::kMetresPerKm) +
                        " km from the nearest open water.";
    return explanation;
  }

  bool Holds(const ActiveConstraint& constraint) const {
    return ConstraintExtent(rasters_, constraint)[rasters_.grid.Index(cell_)] !=
           0;
  }

  // Ways ----------------------------------------------------------------------

  double Window_s() const {
    return in_.seam.window->end_s - in_.seam.window->begin_s;
  }
  double Allowed_s() const {
    return std::min(Window_s(), in_.seam.window->base_travel_m /
                                    in_.seam.rules->motion.cruise_mps);
  }
  VoyageRequest From(kg_base::LonLat source) const {
    return {{field_, &open_, nullptr},
            in_.seam.rules->motion,
            {source, in_.seam.window->begin_s, in_.seam.window->end_s,
             in_.seam.window->base_travel_m},
            {}};
  }

  bool CanBeFlownTo() const {
    return std::any_of(
        in_.sources.begin(), in_.sources.end(), [&](kg_base::LonLat source) {
          const VoyageRequest voyage = From(source);
          return Traverse(voyage, ComputeReach(voyage), in_.place).has_value();
        });
  }

  // Least travel time [s] from a source to the place's cell, if less than
  // `below_s`.
  double Travel_s(kg_base::LonLat source, double below_s) const {
    VoyageRequest voyage = From(source);
    voyage.departure.base_travel_m = kInfinity;
    for (int i = 0; i <= kMaxDoublings; ++i) {
      const double limit_s = std::min(below_s, std::ldexp(Window_s(), i));
      voyage.departure.deadline_s = voyage.departure.time_s + limit_s;
      const ReachMap reach = ComputeReach(voyage);
      const ReachedCell* found =
          reach.Find(static_cast<int>(rasters_.grid.Index(cell_)));
      if (found) return found->arrival_s;
      if (limit_s >= below_s) break;
    }
    return below_s;
  }

  // Nearest source first: its result bounds the search from the others.
  double LeastTravel_s() const {
    std::vector<std::pair<double, kg_base::LonLat>> sources;
    for (const kg_base::LonLat& source : in_.sources) {
      sources.emplace_back(kg_base::Distance_m(source, in_.place), source);
    }
    std::sort(sources.begin(), sources.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    const MotionModel& motion = in_.seam.rules->motion;
    const double fastest_mps =
        motion.cruise_mps + motion.boost_gain * field_->MaxSpeed_mps();
    double least_s = kInfinity;
    for (const auto& [distance_m, source] : sources) {
      if (distance_m / fastest_mps >= least_s) break;
      least_s = Travel_s(source, least_s);
    }
    return least_s;
  }

  std::optional<Explanation> TooFar() const {
    const double least_s = LeastTravel_s();
    const double allowed_s = Allowed_s();
    if (least_s < allowed_s) return std::nullopt;
    if (least_s == kInfinity) return NoWay();
    // The binding limit: the window's length or the base travel.
    const bool by_window = Window_s() <= allowed_s;
    Explanation explanation = Named(
        "unreachable", "s",
        "the fastest way found takes " + Hours(least_s) + ", " +
            Hours(least_s - allowed_s) + " more than " +
            (by_window ? "the window has" : "the base travel allows") + ".");
    explanation.value = least_s - allowed_s;
    explanation.parts = {
        {least_s, "least travel time", MotionFacts(in_.seam, facts_),
         "the fastest way found: " + Hours(least_s)},
        {-allowed_s, by_window ? "window" : "base travel / V",
         MotionFacts(in_.seam, facts_),
         (by_window ? "the window has " : "the base travel lasts ") +
             Hours(allowed_s)}};
    return explanation;
  }

  Explanation NoWay() const {
    const double looked_s = std::ldexp(Window_s(), kMaxDoublings);
    Explanation explanation = Named(
        "unreachable", "s", "no way was found within " + Hours(looked_s) + ".");
    explanation.value = looked_s - Allowed_s();
    explanation.parts = {
        {looked_s, "searched", MotionFacts(in_.seam, facts_),
         "no way takes less than " + Hours(looked_s)},
        {-Allowed_s(), "allowed", MotionFacts(in_.seam, facts_),
         "allowed are " + Hours(Allowed_s())}};
    return explanation;
  }

  // The place is reached in time, so the cause is the current there until the
  // end.
  Explanation Unholdable() const {
    const MotionModel& motion = in_.seam.rules->motion;
    double speed_mps = 0.0;
    if (const auto at = field_->grid.Locate(in_.place)) {
      // Linear between slices, so the largest speed occurs at a slice.
      for (const kg_base::FieldSlice& slice : field_->slices) {
        const auto c = field_->Sample(*at, slice.time_s);
        if (!c) continue;
        speed_mps =
            std::max(speed_mps,
                     motion.boost_gain * std::hypot(c->east_mps, c->north_mps));
      }
    }
    const bool is_strong = speed_mps > motion.max_mps;
    Explanation explanation =
        Named(is_strong ? "unholdable" : "unflyable", "m/s",
              is_strong ? "station cannot be held there until the window "
                          "ends: the current reaches " +
                              Short(speed_mps) + " m/s, the agent " +
                              Short(motion.max_mps) + " m/s."
                        : "the search reaches it, but no track to it can be "
                          "flown in the current.");
    explanation.value = speed_mps - motion.max_mps;
    explanation.parts = {
        {speed_mps, "largest |c|", facts_.Layer(rasters_.field_iri),
         "the strongest current there in the window's data"},
        {-motion.max_mps, "V_max",
         facts_.Capabilities(*in_.tensor.agent,
                             {"ex:maxSpeedKts", "ex:boostGain"}),
         "the agent's greatest speed"}};
    return explanation;
  }

  const PlaceQuestion& in_;
  const CitedFacts& facts_;
  const WindowRasters& rasters_;
  ActiveFacts active_;
  kg_base::Mask open_;
  const kg_base::VectorField* field_ = nullptr;
  kg_base::Cell cell_;
};

}  // namespace

std::optional<Explanation> WhyUnreachable(const PlaceQuestion& question,
                                          const CitedFacts& facts) {
  return Place(question, facts).Explain();
}

}  // namespace kg_compiler
