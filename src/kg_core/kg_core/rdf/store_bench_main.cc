// Benchmark of the store, its queries, updates and validation on a mission-like
// graph, compared with other stores in the same run.
//
//   store_bench [--quick] [--triples=100000,1000000]
//
// KG_STORE_BENCH_PEERS names the others: "name=largest size=command" each, with
// ";" between; scripts/bench.sh sets it. A command gets the N-Triples file and
// the file of queries ("name<TAB>query"), and prints "name<TAB>milliseconds
// <TAB>rows" for load, each query and update, and "memory<TAB>bytes<TAB>0".
// Exits with 1 if a peer returns a different number of rows, since one of the
// two must then be wrong.
//
// Prints one line per target: name, goal, measured value, the peers' values,
// met or missed. All times are medians except load and reopening. A durable
// update is measured alternating with an fsync on the same file system; the
// update compared with peers is in memory, as theirs are.

#include <fcntl.h>
#include <malloc.h>
#include <stdio.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "kg_base/common/temporary_folder.h"
#include "kg_base/common/testing/bench_report.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/store.h"
#include "kg_core/rdf/testing/bench_graph.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/shacl/changes.h"
#include "kg_core/shacl/shapes.h"
#include "kg_core/shacl/validation.h"
#include "kg_core/sparql/query_engine.h"

namespace kg_core {
namespace {

using kg_base::Median;
using kg_base::Seconds;

struct Query {
  const char* name;
  const char* text;
  double goal_ms;  // 0: no slower than the fastest peer.
};

const char kPrologue[] =
    "PREFIX ex: <http://example.org/mission/> "
    "PREFIX prov: <http://www.w3.org/ns/prov#> "
    "PREFIX geo: <http://www.opengis.net/ont/geosparql#> ";
const Query kQueries[] = {
    {"point query",
     "SELECT ?p ?o { <http://example.org/mission/waypoint/0_42> "
     "?p ?o }",
     0.030},
    {"three-way join",
     "SELECT ?to ?wkt ?cost { ?e ex:fromWaypoint "
     "<http://example.org/mission/waypoint/0_42> ; ex:toWaypoint ?to ; "
     "ex:cost ?cost . ?to geo:asWKT ?wkt }",
     0.041},
    {"closure",
     "SELECT ?x { <http://example.org/mission/entity/0_9999> "
     "prov:wasDerivedFrom+ ?x }",
     2.9},
    {"join of all",
     "SELECT ?a ?w { ?a ex:assignedAgent "
     "<http://example.org/mission/agent/3> ; "
     "ex:assignedWaypoint ?p . ?p ex:inWindow ?w }",
     0.0},
    {"group of all",
     "SELECT ?w (COUNT(?p) AS ?n) { ?p a ex:Waypoint ; "
     "ex:inWindow ?w } GROUP BY ?w",
     0.0},
};

const char kShapes[] = R"ttl(
  ex:WaypointShape a sh:NodeShape ; sh:targetClass ex:Waypoint ;
    sh:property [ sh:path geo:asWKT ; sh:minCount 1 ; sh:maxCount 1 ;
                  sh:datatype geo:wktLiteral ] ;
    sh:property [ sh:path ex:inWindow ; sh:minCount 1 ; sh:nodeKind sh:IRI ] .
  ex:EdgeShape a sh:NodeShape ; sh:targetClass ex:TraverseEdge ;
    sh:property [ sh:path ex:cost ; sh:minCount 1 ; sh:maxCount 1 ;
                  sh:datatype xsd:double ; sh:minInclusive 0 ] ;
    sh:property [ sh:path ex:toWaypoint ; sh:class ex:Waypoint ] .
)ttl";

double Milliseconds(const std::function<void()>& work) {
  return 1e3 * Seconds(work);
}

double MedianMilliseconds(const std::function<void()>& work) {
  std::vector<double> times;
  double sum = 0.0;
  while (times.size() < 5 || sum < 500.0) {
    times.push_back(Milliseconds(work));
    sum += times.back();
  }
  return Median(times);
}

std::size_t HeapBytes() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

double Load() {
  double load = 0.0;
  std::ifstream("/proc/loadavg") >> load;
  return load;
}

struct Figure {
  double value = 0.0;  // Milliseconds, or bytes.
  long rows = 0;
};
using Figures = std::map<std::string, Figure>;

struct Peer {
  std::string name;
  std::size_t largest = 0;
  std::string command;
};

std::vector<Peer> PeersOfEnvironment() {
  std::vector<Peer> peers;
  const char* text = std::getenv("KG_STORE_BENCH_PEERS");
  std::istringstream entries(text == nullptr ? "" : text);
  for (std::string entry; std::getline(entries, entry, ';');) {
    const std::size_t first = entry.find('=');
    const std::size_t second = entry.find('=', first + 1);
    peers.push_back({entry.substr(0, first),
                     std::stoul(entry.substr(first + 1)),
                     entry.substr(second + 1)});
  }
  return peers;
}

// Runs a peer and parses its output; figures that it did not print are absent.
Figures AskPeer(const Peer& peer, const std::string& graph,
                const std::string& queries) {
  Figures figures;
  const std::string command = peer.command + " " + graph + " " + queries;
  FILE* output = popen(command.c_str(), "r");
  if (output == nullptr) return figures;
  char line[256];
  while (std::fgets(line, sizeof(line), output) != nullptr) {
    std::istringstream fields(line);
    std::string name;
    Figure figure;
    std::getline(fields, name, '\t');
    if (fields >> figure.value >> figure.rows) figures[name] = figure;
  }
  if (pclose(output) != 0) std::printf("  %s failed\n", peer.name.c_str());
  return figures;
}

// All measurements for one graph size, then the table.
class Bench {
 public:
  Bench(std::size_t triples, std::vector<Peer> peers)
      : triples_(triples), store_path_(folder_ / "store.db") {
    std::ofstream file(graph_path());
    WriteBenchGraph(triples, [&](const std::string& text) { file << text; });
    std::ofstream queries(queries_path());
    for (const Query& query : kQueries) {
      queries << query.name << '\t' << kPrologue << query.text << '\n';
    }
    peers_ = std::move(peers);
  }

  // Returns false if answers differ from those of a peer.
  bool Run() {
    std::printf("store, %zu triples, load of the machine %.1f\n", triples_,
                Load());
    for (const Peer& peer : peers_) {
      if (triples_ > peer.largest) {
        std::printf("  %s: not asked beyond %zu triples, it is too slow\n",
                    peer.name.c_str(), peer.largest);
        continue;
      }
      theirs_.emplace_back(peer.name,
                           AskPeer(peer, graph_path(), queries_path()));
    }
    MeasureLoad();
    MeasureQueries();
    MeasureUpdates();
    MeasureShacl();
    MeasureReopening();
    return same_;
  }

 private:
  std::string graph_path() const { return folder_ / "graph.nt"; }
  std::string queries_path() const { return folder_ / "queries"; }

  // Smaller is better; a goal of 0 is the fastest peer alone.
  void Print(const std::string& name, const char* unit, double goal,
             double measured, double scale = 1.0) {
    std::printf("  %-22s goal ", name.c_str());
    goal > 0.0 ? std::printf("<= %-9.4g", goal) : std::printf("%-12s", "peers");
    std::printf(" measured %-9.4g %-14s", measured, unit);
    bool met = goal <= 0.0 || measured <= goal;
    for (const auto& [peer, figures] : theirs_) {
      const auto found = figures.find(name);
      if (found == figures.end()) continue;
      const double value = found->second.value * scale;
      std::printf(" %s %.4g", peer.c_str(), value);
      met = met && measured <= value;
    }
    std::printf("  %s\n", met ? "met" : "missed");
    std::fflush(stdout);
  }

  void CheckRows(const std::string& name, long rows) {
    for (const auto& [peer, figures] : theirs_) {
      const auto found = figures.find(name);
      if (found == figures.end() || found->second.rows == rows) continue;
      std::printf("  %s: %ld rows here, %ld by %s: DIFFERENT\n", name.c_str(),
                  rows, found->second.rows, peer.c_str());
      same_ = false;
    }
  }

  void MeasureLoad() {
    std::size_t before = 0;
    const double load_ms = Milliseconds([&] {
      std::ifstream file(graph_path());
      store_.emplace(store_path_);
      before = HeapBytes();
      Transaction change = store_->Begin();
      std::string line, text;
      // Parse in blocks of 4 MiB, so that the text stays far below the parser's
      // limit.
      const auto add = [&] {
        for (const Statement& s :
             ParseTurtle(text, "graph", Iri(kFactsGraph))) {
          change.Add(s);
        }
        text.clear();
      };
      while (std::getline(file, line)) {
        text += line;
        text += '\n';
        if (text.size() > (4u << 20)) add();
      }
      add();
      change.Commit(WorldChange::kYes);
    });
    malloc_trim(0);
    const double n = static_cast<double>(store_->quad_count());
    CheckRows("load", static_cast<long>(n));
    Print("load", "us/triple", 1e6 / 514e3, load_ms * 1e3 / n, 1e3 / n);
    Print("memory", "B/triple", 130.0, (HeapBytes() - before) / n, 1.0 / n);
  }

  void MeasureQueries() {
    const auto view = store_->Read();
    Dataset dataset;
    dataset.default_graphs = {kFactsGraph};
    for (const Query& query : kQueries) {
      const std::string text = std::string(kPrologue) + query.text;
      QueryLimits limits;
      limits.seconds = 60.0;
      long rows = 0;
      const double ms = MedianMilliseconds([&] {
        rows = static_cast<long>(
            RunQuery(*view, text, dataset, limits).rows.size());
      });
      CheckRows(query.name, rows);
      Print(query.name, "ms", query.goal_ms, ms);
    }
  }

  // Changes the cost of one edge.
  static void Update(Store* store, int i) {
    const Term edge = Iri(kEx + ("edge/0_" + std::to_string(i % 1000)));
    const Term cost = Iri(kEx + std::string("cost"));
    const Term graph = Iri(kFactsGraph);
    Transaction change = store->Begin();
    change.RemoveMatching(&edge, &cost, nullptr, graph);
    change.Add({edge, cost, DoubleLiteral(1.0 + i), graph});
    change.Commit(WorldChange::kYes);
  }

  void MeasureUpdates() {
    const std::string block(4096, 'x');
    const std::string path = folder_ / "fsync";
    const int file = open(path.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
    std::vector<double> sync_ms, update_ms;
    for (int i = 0; i < 300; ++i) {
      sync_ms.push_back(Milliseconds([&] {
        if (write(file, block.data(), block.size()) < 0 || fsync(file) != 0) {
          throw std::runtime_error(path + ": cannot be written");
        }
      }));
      update_ms.push_back(Milliseconds([&] { Update(&*store_, i); }));
    }
    close(file);
    const double sync = Median(sync_ms), update = Median(update_ms);
    std::printf("  (fsync %.3f ms, durable update %.3f ms)\n", sync, update);
    Print("durable update", "fsync times", 2.0, update / sync);
    // The peers keep their stores in memory; a fork is in memory too.
    const auto fork = Store::Fork(store_->Read());
    int i = 0;
    Print("update", "ms, in memory", 0.0,
          MedianMilliseconds([&] { Update(fork.get(), i++); }));
  }

  void MeasureShacl() {
    Store vocabulary("");
    Transaction shapes_change = vocabulary.Begin();
    for (const Statement& s :
         ParseTurtle(kShapes, "shapes", Iri(kVocabGraph))) {
      shapes_change.Add(s);
    }
    const auto shapes = shacl::LoadShapes(shapes_change.view(), kVocabGraph);
    const Transaction change = ChangedEdge();
    const shacl::DataGraph data{change.view(), kFactsGraph, {kFactsGraph}};
    // The whole-graph time is normalized by the number of focus nodes.
    std::size_t nodes = 0;
    for (const auto& [id, shape] : shapes) {
      nodes += shacl::ShapeValidation(data, shapes).FocusNodes(shape).size();
    }
    const double all_ms =
        MedianMilliseconds([&] { shacl::ShapeValidation(data, shapes).Run(); });
    Print("SHACL, whole", "us/focus node", 15e3 / 23e3,
          1e3 * all_ms / static_cast<double>(nodes));
    const shacl::GraphChange diff{change.added(), change.removed()};
    const double one_ms =
        MedianMilliseconds([&] { shacl::ValidateTouched(data, shapes, diff); });
    Print("SHACL, a change", "us", 100.0, 1e3 * one_ms);
  }

  Transaction ChangedEdge() {
    const Term edge = Iri(kEx + std::string("edge/0_7"));
    const Term cost = Iri(kEx + std::string("cost"));
    Transaction change = store_->Begin();
    change.RemoveMatching(&edge, &cost, nullptr, Iri(kFactsGraph));
    change.Add({edge, cost, DoubleLiteral(5.0), Iri(kFactsGraph)});
    return change;
  }

  void MeasureReopening() {
    const double quads = static_cast<double>(store_->quad_count());
    store_.reset();
    malloc_trim(0);
    const auto file_bytes =
        static_cast<double>(std::filesystem::file_size(store_path_));
    const std::size_t before = HeapBytes();
    const double ms = Milliseconds([&] { store_.emplace(store_path_); });
    Print("file", "B/triple", 0.0, file_bytes / quads);
    Print("reopening", "s/M triples", 0.8, 1e3 * ms / quads);
    Print("memory, reopened", "B/triple", 130.0,
          (HeapBytes() - before) / quads);
  }

  const std::size_t triples_;
  const kg_base::TemporaryFolder folder_;
  const std::string store_path_;
  std::vector<Peer> peers_;
  std::vector<std::pair<std::string, Figures>> theirs_;
  std::optional<Store> store_;
  bool same_ = true;
};

}  // namespace
}  // namespace kg_core

int main(int argc, char** argv) {
  std::string sizes = "100000,1000000";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.rfind("--triples=", 0) == 0) sizes = argument.substr(10);
    if (argument == "--quick") sizes = "20000";
  }
  bool same = true;
  std::istringstream list(sizes);
  for (std::string size; std::getline(list, size, ',');) {
    const auto triples = static_cast<std::size_t>(std::stod(size));
    same &= kg_core::Bench(triples, kg_core::PeersOfEnvironment()).Run();
  }
  return same ? EXIT_SUCCESS : EXIT_FAILURE;
}
