// For benchmarks: a synthetic mission-like graph as N-Triples.
//
// Per 100,000 triples: 6,000 waypoints with WKT, 8,600 edges between neighbours
// with costs, 2,000 assignments, and a provenance graph of 10,000 entities,
// each derived from one or two older ones. A given block number always yields
// the same text.

#ifndef KG_CORE_RDF_TESTING_BENCH_GRAPH_H_
#define KG_CORE_RDF_TESTING_BENCH_GRAPH_H_

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <utility>

#include "kg_core/rdf/namespaces.h"

namespace kg_core {

inline constexpr int kWaypoints = 6000;
inline constexpr int kEdges = 8600;
inline constexpr int kAssignments = 2000;
inline constexpr int kEntities = 10000;

class BenchBlock {
 public:
  explicit BenchBlock(int number)
      : number_(std::to_string(number) + "_"), random_(number) {}

  std::string Text() {
    for (int i = 0; i < kWaypoints; ++i) AddWaypoint(i);
    for (int i = 0; i < kEdges; ++i) AddEdge(i);
    for (int i = 0; i < kAssignments; ++i) AddAssignment(i);
    for (int i = 0; i < kEntities; ++i) AddEntity(i);
    return std::move(text_);
  }

 private:
  int Pick(int n) { return static_cast<int>(random_() % n); }
  std::string Ex(const std::string& kind, int i) const {
    return "<" + (kEx + kind) + number_ + std::to_string(i) + ">";
  }
  static std::string Ex(const std::string& name) {
    return "<" + (kEx + name) + ">";
  }
  static std::string Typed(const std::string& text, const std::string& type) {
    return "\"" + text + "\"^^<" + type + ">";
  }
  static std::string Number(double value) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.6e", value);
    return Typed(text, kXsd + std::string("double"));
  }
  void Add(const std::string& s, const std::string& p, const std::string& o) {
    text_ += s + " " + p + " " + o + " .\n";
  }
  void AddType(const std::string& s, const std::string& type) {
    Add(s, "<" + (kRdf + std::string("type>")), Ex(type));
  }

  void AddWaypoint(int i) {
    const std::string waypoint = Ex("waypoint/", i);
    char point[64];
    std::snprintf(point, sizeof(point), "POINT (%.4f %.4f)",
                  -98.0 + Pick(200000) * 1e-4, 18.0 + Pick(130000) * 1e-4);
    AddType(waypoint, "Waypoint");
    Add(waypoint, "<" + (kGeo + std::string("asWKT>")),
        Typed(point, kGeo + std::string("wktLiteral")));
    Add(waypoint, Ex("inWindow"), Ex("window/" + std::to_string(i % 7)));
  }
  void AddEdge(int i) {
    const std::string edge = Ex("edge/", i);
    const int from = Pick(kWaypoints);
    AddType(edge, "TraverseEdge");
    Add(edge, Ex("fromWaypoint"), Ex("waypoint/", from));
    Add(edge, Ex("toWaypoint"),
        Ex("waypoint/", (from + 1 + Pick(20)) % kWaypoints));
    Add(edge, Ex("cost"), Number(Pick(1000000) * 1e-3));
    Add(edge, Ex("duration"), Number(600.0 * Pick(144)));
  }
  void AddAssignment(int i) {
    const std::string assignment = Ex("assignment/", i);
    AddType(assignment, "Assignment");
    Add(assignment, Ex("assignedAgent"), Ex("agent/" + std::to_string(i % 12)));
    Add(assignment, Ex("assignedWaypoint"), Ex("waypoint/", Pick(kWaypoints)));
    Add(assignment, Ex("inWindow"), Ex("window/" + std::to_string(i % 7)));
  }
  void AddEntity(int i) {
    const std::string entity = Ex("entity/", i);
    const std::string derived = "<" + (kProv + std::string("wasDerivedFrom>"));
    Add(entity, "<" + (kRdf + std::string("type>")),
        "<" + (kProv + std::string("Entity>")));
    const int first = i - 1 - Pick(3);
    const int second = Pick(i + 1);
    if (first >= 0) Add(entity, derived, Ex("entity/", first));
    if (second < first) Add(entity, derived, Ex("entity/", second));
  }

  const std::string number_;
  std::mt19937 random_;
  std::string text_;
};

// Passes the text to `write` in blocks of whole lines, about 100,000 triples
// each.
inline void WriteBenchGraph(
    std::size_t triples, const std::function<void(const std::string&)>& write) {
  std::size_t left = triples;
  for (int number = 0; left > 0; ++number) {
    std::string text = BenchBlock(number).Text();
    std::size_t end = 0;
    for (; left > 0 && end < text.size(); --left) {
      end = text.find('\n', end) + 1;
    }
    text.resize(end);
    write(text);
  }
}

}  // namespace kg_core

#endif  // KG_CORE_RDF_TESTING_BENCH_GRAPH_H_
