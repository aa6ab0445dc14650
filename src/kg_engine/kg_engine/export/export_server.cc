#include "kg_engine/export/export_server.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/syntax.h"
#include "kg_core/sparql/resolve_dataset.h"
#include "kg_engine/export/atomic_file.h"
#include "kg_engine/export/cf_trajectory.h"
#include "kg_engine/export/plan_formats.h"
#include "kg_engine/export/plan_tracks.h"
#include "kg_engine/state/mission_state.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

namespace fs = std::filesystem;
using kg_base::InputError;
using kg_core::GraphView;

// Gliders know goto lists by number: goto_l10.ma to goto_l99.ma.
constexpr std::size_t kFirstGotoList = 10;
constexpr std::size_t kMaxGotoLists = 90;

// Returns the text if no path is given; else writes the file.
std::string Deliver(const std::string& path, std::string text) {
  if (path.empty()) return text;
  WriteAtomically(path, text);
  return "";
}

std::string GeoJson(const PlanTracks& plan, const std::string& path) {
  return Deliver(path, ToGeoJson(plan));
}

std::string Gpx(const PlanTracks& plan, const std::string& path) {
  return Deliver(path, ToGpx(plan));
}

std::string GotoFile(std::size_t index) {
  return "goto_l" + std::to_string(kFirstGotoList + index) + ".ma";
}

// Is it a file that an export wrote?
bool IsGotoList(const std::string& path) {
  std::ifstream file(path);
  std::string behavior, author;
  std::getline(file, behavior);
  std::getline(file, author);
  return behavior == "behavior_name=goto_list" &&
         author.rfind(kGotoAuthor, 0) == 0;
}

// An agent's lists; none if it has no stop left.
std::vector<std::string> CollectGotoLists(const PlanTracks& plan,
                                          const PlannedAgent& agent) {
  std::vector<std::string> lists = ToGotoLists(plan, agent);
  if (lists.size() > kMaxGotoLists) {
    throw InputError(agent.id + " has more stops than " +
                     std::to_string(kMaxGotoLists) + " goto lists hold");
  }
  return lists;
}

// Lists of an earlier export, from `first` on: a glider would fly them after
// the new ones.
void RemoveGotoLists(const fs::path& folder, std::size_t first) {
  for (std::size_t i = first; i < kMaxGotoLists; ++i) {
    const fs::path path = folder / GotoFile(i);
    if (!IsGotoList(path.string())) continue;
    std::error_code error;
    fs::remove(path, error);
    if (error) {
      throw InputError(path.string() +
                       ": cannot be removed: " + error.message());
    }
  }
}

void WriteGotoLists(const fs::path& folder,
                    const std::vector<std::string>& lists) {
  std::error_code error;
  if (folder.is_absolute()) fs::create_directories(folder, error);
  if (error) {
    throw InputError(folder.string() + ": cannot be made: " + error.message());
  }
  for (std::size_t i = 0; i < lists.size(); ++i) {
    WriteAtomically((folder / GotoFile(i)).string(), lists[i]);
  }
}

std::string JoinGotoLists(const std::string& agent,
                          const std::vector<std::string>& lists) {
  std::string all;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    all += "# " + agent + "/" + GotoFile(i) + "\n" + lists[i] + "\n";
  }
  return all;
}

std::string Goto(const PlanTracks& plan, const std::string& path) {
  std::string all;
  bool has_lists = false;
  for (const PlannedAgent& agent : plan.agents) {
    const auto lists = CollectGotoLists(plan, agent);
    has_lists = has_lists || !lists.empty();
    if (lists.empty()) {
      all += "# " + agent.id + ": no stop is left to fly, no list\n";
    }
    if (path.empty()) {
      all += JoinGotoLists(agent.id, lists);
      continue;
    }
    const fs::path folder = fs::path(path) / agent.id;
    if (!lists.empty()) WriteGotoLists(folder, lists);
    RemoveGotoLists(folder, lists.size());
  }
  if (!has_lists) {
    throw InputError(plan.run_iri +
                     " has no stop left to fly: no goto list is written");
  }
  return all;
}

std::string NetCdf(const PlanTracks& plan, const std::string& path) {
  if (path.empty()) {
    throw InputError("format 'netcdf' is not text: expected a path");
  }
  WriteAtomically(path, [&](const std::string& temporary) {
    WriteCfTrajectory(plan, temporary);
  });
  return "";
}

struct PlanFormat {
  const char* name;
  std::string (*write)(const PlanTracks& plan, const std::string& path);
};
constexpr PlanFormat kPlanFormats[] = {
    {"geojson", GeoJson}, {"gpx", Gpx}, {"goto", Goto}, {"netcdf", NetCdf}};

// Expands and checks a graph name; throws InputError if the store lacks it.
std::string GraphNamed(const GraphView& view, const std::string& name) {
  const std::string iri = kg_core::ExpandPrefixed(name).value_or(name);
  if (kg_core::sparql::HasGraph(view, iri)) return iri;
  throw InputError("graph '" + name + "' is not in the store");
}

std::string WriteFacts(const GraphView& view, kg_core::RdfSyntax syntax,
                       const ExportRequest& request) {
  kg_core::RdfSelection selection;
  for (const std::string& name : request.graphs) {
    selection.graphs.push_back(GraphNamed(view, name));
  }
  if (selection.graphs.empty()) selection.graphs = {kg_core::kFactsGraph};
  return Deliver(request.path, kg_core::WriteRdf(view, selection, syntax));
}

std::string PlanGraphOf(const GraphView& view, const ExportRequest& request) {
  if (request.graphs.size() > 1) {
    throw InputError("expected the graph of one plan, or none for the current");
  }
  if (!request.graphs.empty()) return GraphNamed(view, request.graphs[0]);
  const std::uint64_t run = LoadState(view).plan_run;
  if (run == 0) throw InputError("there is no plan yet");
  return PlanGraph(run).text;
}

std::string Write(const GraphView& view, const ExportRequest& request) {
  if (const auto* syntax = kg_core::SyntaxNamed(request.format)) {
    return WriteFacts(view, syntax->syntax, request);
  }
  for (const PlanFormat& format : kPlanFormats) {
    if (request.format != format.name) continue;
    return format.write(ReadPlanTracks(view, PlanGraphOf(view, request)),
                        request.path);
  }
  throw InputError("format '" + request.format + "' is not known; expected " +
                   kg_base::JoinStrings(ExportFormats()));
}

}  // namespace

std::vector<std::string> ExportFormats() {
  std::vector<std::string> names;
  for (const auto& syntax : kg_core::RdfSyntaxes()) {
    names.push_back(syntax.name);
  }
  for (const PlanFormat& format : kPlanFormats) names.push_back(format.name);
  return names;
}

ExportAnswer Export(const GraphView& view, const ExportRequest& request) {
  ExportAnswer answer;
  answer.world_version = view.world_version();
  try {
    answer.data = Write(view, request);
    answer.ok = true;
  } catch (const InputError& error) {
    answer.error = error.what();
  }
  return answer;
}

}  // namespace kg_engine
