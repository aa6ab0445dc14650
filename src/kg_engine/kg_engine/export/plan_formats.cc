#include "kg_engine/export/plan_formats.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "kg_base/common/date_time.h"

namespace kg_engine {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kGotoReached_m = 10;  // Default of the format.

// Seven decimals, as in the facts: 1 cm.
double Rounded(double degrees) { return std::round(degrees * 1e7) / 1e7; }

Json Coordinates(const kg_base::LonLat& position) {
  return {Rounded(position.lon_deg), Rounded(position.lat_deg)};
}

Json Coordinates(const Track& part) {
  Json line = Json::array();
  for (const auto& point : part) line.push_back(Coordinates(point.position));
  return line;
}

Json Times(const Track& part) {
  Json times = Json::array();
  for (const auto& point : part) {
    times.push_back(kg_base::FormatDateTime(point.time_s));
  }
  return times;
}

template <typename Of>
Json OneOrMany(const std::vector<Track>& parts, Of of) {
  if (parts.size() == 1) return of(parts[0]);
  Json all = Json::array();
  for (const Track& part : parts) all.push_back(of(part));
  return all;
}

Json Feature(const char* type, Json coordinates, Json properties) {
  return {{"type", "Feature"},
          {"geometry", {{"type", type}, {"coordinates", coordinates}}},
          {"properties", properties}};
}

Json TrackFeature(const PlannedAgent& agent) {
  double hours = 0.0, wh = 0.0, reward = 0.0, seam_cost = 0.0;
  for (const PlannedStop& stop : agent.stops) {
    hours += stop.travel_h;
    wh += stop.energy_wh;
    reward += stop.reward;
    seam_cost += stop.seam_cost;
  }
  return Feature(
      agent.parts.size() == 1 ? "LineString" : "MultiLineString",
      OneOrMany(agent.parts, [](const Track& t) { return Coordinates(t); }),
      {{"kind", "track"},
       {"agent", agent.id},
       {"agent_iri", agent.iri},
       {"reward", reward},
       {"seam_cost", seam_cost},
       {"travel_hours", hours},
       {"energy_wh", wh},
       {"coordTimes", OneOrMany(agent.parts, Times)}});
}

Json StopFeature(const PlannedAgent& agent, const PlannedStop& stop) {
  Json properties = {{"kind", "waypoint"},
                     {"agent", agent.id},
                     {"window", stop.window},
                     {"status", stop.status},
                     {"reward", stop.reward},
                     {"seam_cost", stop.seam_cost},
                     {"travel_hours", stop.travel_h},
                     {"energy_wh", stop.energy_wh},
                     {"risk_hours", stop.risk_h},
                     {"events", stop.events}};
  if (std::isfinite(stop.time_s)) {
    properties["time"] = kg_base::FormatDateTime(stop.time_s);
  }
  return Feature("Point", Coordinates(stop.position), properties);
}

std::string XmlText(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        // XML 1.0 has no control characters but these three.
        safe += static_cast<unsigned char>(c) >= 0x20 || c == '\n' ||
                        c == '\t' || c == '\r'
                    ? c
                    : '?';
    }
  }
  return safe;
}

std::string Attributes(const kg_base::LonLat& position) {
  char text[96];
  // GPX wants longitudes below 180.
  const double lon_deg = position.lon_deg >= 180.0 ? -180.0 : position.lon_deg;
  std::snprintf(text, sizeof text, "lat=\"%.7f\" lon=\"%.7f\"",
                position.lat_deg, lon_deg);
  return text;
}

std::string TimeTag(double time_s) {
  if (!std::isfinite(time_s)) return "";
  return "<time>" + kg_base::FormatDateTime(time_s) + "</time>";
}

std::string GpxWaypoint(const PlannedAgent& agent, const PlannedStop& stop) {
  return "  <wpt " + Attributes(stop.position) + ">" + TimeTag(stop.time_s) +
         "<name>" + XmlText(agent.id) + " w" + std::to_string(stop.window) +
         "</name><type>" + XmlText(stop.status) + "</type></wpt>\n";
}

// Executed stops are omitted: what is left to fly.
std::vector<PlannedStop> RemainingStops(const PlannedAgent& agent) {
  std::vector<PlannedStop> stops;
  for (const PlannedStop& stop : agent.stops) {
    if (stop.status == "planned") stops.push_back(stop);
  }
  return stops;
}

std::string GpxRoute(const PlannedAgent& agent) {
  const std::vector<PlannedStop> stops = RemainingStops(agent);
  if (stops.empty()) return "";
  std::string text = "  <rte>\n    <name>" + XmlText(agent.id) + "</name>\n";
  for (const PlannedStop& stop : stops) {
    text += "    <rtept " + Attributes(stop.position) + ">" +
            TimeTag(stop.time_s) + "<name>" + XmlText(agent.id) + " w" +
            std::to_string(stop.window) + "</name></rtept>\n";
  }
  return text + "  </rte>\n";
}

std::string GpxTrack(const PlannedAgent& agent) {
  std::string text = "  <trk>\n    <name>" + XmlText(agent.id) + "</name>\n";
  for (const Track& part : agent.parts) {
    text += "    <trkseg>\n";
    for (const auto& point : part) {
      text += "      <trkpt " + Attributes(point.position) + ">" +
              TimeTag(point.time_s) + "</trkpt>\n";
    }
    text += "    </trkseg>\n";
  }
  return text + "  </trk>\n";
}

std::string GotoArguments(std::size_t waypoints) {
  return "<start:b_arg>\n"
         "  b_arg: num_legs_to_run(nodim) -2  # once through the list\n"
         "  b_arg: start_when(enum) 0         # BAW_IMMEDIATELY\n"
         "  b_arg: list_stop_when(enum) 7     # BAW_WHEN_WPT_DIST\n"
         "  b_arg: list_when_wpt_dist(m) " +
         std::to_string(kGotoReached_m) +
         "   # a waypoint is reached within this\n"
         "  b_arg: initial_wpt(enum) 0        # the first\n"
         "  b_arg: num_waypoints(nodim) " +
         std::to_string(waypoints) + "\n<end:b_arg>\n\n";
}

std::string GotoWaypoints(const std::vector<PlannedStop>& stops) {
  std::string lines;
  for (const PlannedStop& stop : stops) {
    lines += DegreesAndMinutes(stop.position.lon_deg) + " " +
             DegreesAndMinutes(stop.position.lat_deg) + "  # w" +
             std::to_string(stop.window);
    if (std::isfinite(stop.time_s)) {
      lines += " by " + kg_base::FormatDateTime(stop.time_s);
    }
    lines += "\n";
  }
  return lines;
}

}  // namespace

std::string ToGeoJson(const PlanTracks& plan) {
  Json features = Json::array();
  for (const PlannedAgent& agent : plan.agents) {
    if (!agent.parts.empty()) features.push_back(TrackFeature(agent));
    for (const PlannedStop& stop : agent.stops) {
      features.push_back(StopFeature(agent, stop));
    }
  }
  const Json all = {{"type", "FeatureCollection"},
                    {"plan_run", plan.run_iri},
                    {"world_version", plan.world_version},
                    {"status", plan.status},
                    {"features", features}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string ToGpx(const PlanTracks& plan) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<gpx version=\"1.1\" creator=\"kg/export\" "
      "xmlns=\"http://www.topografix.com/GPX/1/1\">\n"
      "  <metadata><name>" +
      XmlText(plan.mission_name) + "</name><desc>" + XmlText(plan.run_iri) +
      ", world version " + std::to_string(plan.world_version) +
      "</desc></metadata>\n";
  for (const PlannedAgent& agent : plan.agents) {
    for (const PlannedStop& stop : agent.stops) {
      text += GpxWaypoint(agent, stop);
    }
  }
  for (const PlannedAgent& agent : plan.agents) text += GpxRoute(agent);
  for (const PlannedAgent& agent : plan.agents) text += GpxTrack(agent);
  return text + "</gpx>\n";
}

std::string DegreesAndMinutes(const double degrees) {
  constexpr long long kMinuteParts = 10000;
  constexpr long long kDegreeParts = 60 * kMinuteParts;
  const long long parts =
      std::llround(std::abs(degrees) * static_cast<double>(kDegreeParts));
  const long long minute_parts = parts % kDegreeParts;
  char text[32];
  std::snprintf(text, sizeof text, "%s%lld%02lld.%04lld",
                degrees < 0.0 && parts > 0 ? "-" : "", parts / kDegreeParts,
                minute_parts / kMinuteParts, minute_parts % kMinuteParts);
  return text;
}

std::vector<std::string> ToGotoLists(const PlanTracks& plan,
                                     const PlannedAgent& agent) {
  const std::vector<PlannedStop> stops = RemainingStops(agent);
  const std::size_t lists =
      (stops.size() + kMaxGotoWaypoints - 1) / kMaxGotoWaypoints;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < lists; ++i) {
    const auto begin =
        stops.begin() + static_cast<std::ptrdiff_t>(i * kMaxGotoWaypoints);
    const auto left = static_cast<std::size_t>(stops.end() - begin);
    const auto end =
        begin + static_cast<std::ptrdiff_t>(std::min(left, kMaxGotoWaypoints));
    texts.push_back(std::string("behavior_name=goto_list\n") + kGotoAuthor +
                    agent.id + ": " + plan.run_iri + ", world version " +
                    std::to_string(plan.world_version) + ", list " +
                    std::to_string(i + 1) + " of " + std::to_string(lists) +
                    "\n\n" + GotoArguments(std::min(left, kMaxGotoWaypoints)) +
                    "<start:waypoints>\n"
                    "# LONGITUDE LATITUDE, DDDMM.mmmm\n" +
                    GotoWaypoints({begin, end}) + "<end:waypoints>\n");
  }
  return texts;
}

}  // namespace kg_engine
