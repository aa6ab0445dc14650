#include "kg_mission/mission/area_reader.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/units.h"
#include "kg_core/facts/literals.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/choice.h"
#include "kg_mission/mission/layer_reader.h"

namespace kg_mission {
namespace {

using kg_core::Ex;

constexpr double kDefaultEventRadiusKm = 10.0;

constexpr NamedChoice<BufferMetric> kBufferMetrics[] = {
    {"euclidean", BufferMetric::kEuclidean},
    {"chebyshev", BufferMetric::kChebyshev}};

kg_base::Geometry ReadArea(const FactEntity& entity) {
  kg_base::Geometry area = entity.Wkt();
  if (!area.IsArea()) {
    entity.Refuse(kg_core::GeoTerm("asWKT"), "POLYGON or MULTIPOLYGON");
  }
  return area;
}

double Expiry_s(const FactEntity& entity, double begin_s) {
  const std::optional<kg_core::Term> expiry = entity.One(Ex("expiresAfter"));
  if (const auto time_s = kg_core::UnixSeconds(*expiry)) return *time_s;
  if (const auto duration_s = kg_core::DurationSeconds(*expiry)) {
    return begin_s + *duration_s;
  }
  entity.Refuse(Ex("expiresAfter"), "an xsd:dateTime or xsd:duration");
}

// A42: without an expiry, the windows of an event are those it names; with one,
// all windows from the first named one that begin before the expiry.
std::vector<int> EventWindows(const WindowCalendar& calendar,
                              const FactEntity& entity) {
  const std::vector<int> named = calendar.FindWindows(entity, Ex("forWindow"));
  if (named.empty()) entity.Refuse(Ex("forWindow"), "at least one window");
  std::vector<int> windows;
  if (!entity.One(Ex("expiresAfter"))) {
    std::copy_if(named.begin(), named.end(), std::back_inserter(windows),
                 [&](int window) { return calendar.IsPlanned(window); });
    return windows;
  }
  if (!calendar.IsPlanned(named.front())) return windows;
  const double expiry_s =
      Expiry_s(entity, calendar.planned()[named.front()].begin_s);
  for (const TimeWindow& window : calendar.planned()) {
    if (window.index >= named.front() && window.begin_s < expiry_s) {
      windows.push_back(window.index);
    }
  }
  return windows;
}

}  // namespace

Constraint ReadConstraint(const WindowCalendar& calendar,
                          const FactEntity& entity) {
  Constraint constraint;
  constraint.iri = entity.iri();
  constraint.kind =
      Choice(entity, Ex("kind"), kConstraintEffects, ConstraintKind::kNoGo);
  constraint.is_land = entity.Text(Ex("gridRef"), "") == kLandRef;
  if (!constraint.is_land) constraint.mask = ReadRasterRef(entity);
  if (!constraint.is_land && !constraint.mask) {
    constraint.area = ReadArea(entity);
  }
  constraint.buffer_cells = entity.Number(Ex("bufferCells"), 0.0);
  constraint.buffer_metric = Choice(entity, Ex("bufferMetric"), kBufferMetrics,
                                    constraint.buffer_metric);
  constraint.attenuation = entity.Number(Ex("attenuation"), 1.0);
  // A cooling constraint has its own properties for window and agent.
  const bool is_cooling = entity.One(Ex("expires")).has_value();
  const kg_core::Term window_property =
      Ex(is_cooling ? "forWindow" : "appliesIn");
  constraint.windows =
      calendar.Alive(entity, calendar.FindWindows(entity, window_property));
  constraint.agents = entity.Iris(Ex(is_cooling ? "forAgent" : "appliesTo"));
  return constraint;
}

PriorLayer ReadPrior(const WindowCalendar& calendar, const FactEntity& entity) {
  PriorLayer prior;
  prior.iri = entity.iri();
  prior.name = entity.Text(Ex("name"));
  prior.raster = ReadRasterRef(entity);
  if (!prior.raster) prior.area = ReadArea(entity);
  if (prior.raster && entity.One(Ex("edgeKm"))) {
    entity.Refuse(Ex("edgeKm"), "none: only an area has an edge");
  }
  prior.edge_m = kg_base::KmToMetres(entity.Number(Ex("edgeKm"), 0.0));
  prior.windows =
      calendar.Alive(entity, calendar.FindWindows(entity, Ex("appliesIn")));
  prior.agents = entity.Iris(Ex("appliesTo"));
  return prior;
}

Event ReadEvent(const WindowCalendar& calendar, const FactEntity& entity) {
  Event event;
  event.iri = entity.iri();
  event.position = entity.Position();
  event.value = entity.Number(Ex("value"));
  event.capacity = entity.Integer(Ex("capacity"), event.capacity);
  event.radius_m =
      kg_base::KmToMetres(entity.Number(Ex("radiusKm"), kDefaultEventRadiusKm));
  event.windows = EventWindows(calendar, entity);
  if (!event.windows.empty()) {
    event.windows = calendar.Alive(entity, std::move(event.windows));
  }
  if (event.windows == std::vector<int>{WindowCalendar::kNoWindow}) {
    event.windows.clear();
  }
  return event;
}

}  // namespace kg_mission
