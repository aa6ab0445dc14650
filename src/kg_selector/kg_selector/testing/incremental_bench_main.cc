// Cost of an incremental update against a full recomputation (targets 13 and
// 15): soft areas of 40 x 40 cells, one at a time, in one window, for 3 agents
// and 7 windows and for 10 and 24 (the target applies to areas anywhere in the
// grid; areas in an agent's way move most of its waypoints, and everything
// downstream is recomputed); and 100 agents by 168 windows in 5 classes. Uses
// the grid of the Gulf. Times cover compiling and planning from rasters in
// memory, without reading; both sides on all cores. `--quick`: small teams, one
// repetition.

#include <sys/resource.h>

#include <cstdio>
#include <cstring>

#include "kg_base/common/testing/bench_report.h"
#include "kg_compiler/compile/same_compilation.h"
#include "kg_compiler/testing/test_world.h"
#include "kg_selector/team/plan_mission.h"

namespace kg_selector {
namespace {

using kg_compiler::Compilation;
using kg_compiler::MissionCompiler;
using kg_compiler::SeamCounts;
using CompilationPtr = std::shared_ptr<const Compilation>;

constexpr double kWindow_s = 86400.0;
constexpr int kRings = 11;  // Distinct flow windows; then they repeat.

struct BenchTeam {
  int agents = 3;
  int windows = 7;
  int classes = 3;  // Number of policies and of speeds.
  int slices = 2;   // Slices of each window's field, without its end.
};

// Slices of one window, from time 0.
kg_compiler::WorkField MakeField(int window, const BenchTeam& team) {
  kg_compiler::WorkField made;
  const double step_s = kWindow_s / team.slices;
  const double end_s = team.slices > 1 ? kWindow_s : 0.5 * kWindow_s;
  made.field = kg_compiler::GulfLikeFlow(window % kRings, 0.0, end_s, step_s);
  for (kg_base::FieldSlice& slice : made.field.slices) {
    slice.time_s += window * kWindow_s;
  }
  return made;
}

kg_compiler::RasterReaders ReadersFor(const BenchTeam& team) {
  return {
      [team](const kg_mission::Mission&, const kg_mission::WorkFieldRef& ref) {
        return MakeField(ref.window, team).field;
      },
      [](const kg_mission::Mission&, const kg_mission::ValueLayer& layer,
         const kg_base::Grid& grid) {
        std::mt19937 rng(layer.time_index);
        return kg_compiler::RandomRaster(rng, grid.size(), 0.0, 1.0);
      }};
}

void AddWindow(int t, kg_mission::Mission* mission) {
  const std::string name = std::to_string(t);
  mission->windows.push_back(kg_compiler::TestWindow(t, std::exp(-0.02 * t)));
  mission->work_fields.push_back({"ex:field" + name, t, "ex:file", t, t + 1});
  mission->value_layers.push_back(
      {"ex:value" + name, t, "delta_sst", "ex:file", t + 1, t});
}

kg_mission::Agent MakeAgent(int i, const BenchTeam& team) {
  kg_mission::Agent agent = kg_compiler::TestAgent("a" + std::to_string(i));
  const int kind = i % team.classes;
  agent.policy.iri = "ex:policy" + std::to_string(kind);
  agent.policy.alpha_base = 1.0 - 0.1 * kind;
  agent.policy.gamma_front = 0.1 * kind;
  agent.policy.lambda_time_per_s = 1e-6;
  agent.policy.lambda_energy_per_j = 1e-7;
  agent.policy.lambda_risk = 0.05;
  agent.capabilities.cruise_mps = 0.3 + 0.1 * kind;
  agent.capabilities.energy_budget_j = 1e9;
  agent.start = {-94.0 + 0.9 * (i % 12), 24.3 + 0.5 * (i / 12 % 8)};
  return agent;
}

kg_mission::Mission MakeMission(const BenchTeam& team) {
  kg_mission::Mission mission;
  mission.iri = "ex:mission";
  mission.files["ex:file"] = {"ex:file", "/file.nc", "sha"};
  for (int t = 0; t < team.windows; ++t) AddWindow(t, &mission);
  for (int i = 0; i < team.agents; ++i) {
    mission.agents.push_back(MakeAgent(i, team));
  }
  mission.coordination.waypoints_per_window = 20;
  mission.coordination.waypoint_spacing_m = 12e3;
  mission.coordination.candidates_per_agent = 50;
  return mission;
}

// Location of the changed area.
enum class ChangePlace { kAnywhere, kInTheWay };

kg_base::LonLat MiddleOf(ChangePlace where, const kg_mission::Mission& mission,
                         std::mt19937* rng) {
  if (where == ChangePlace::kAnywhere) {  // In the grid.
    return {kg_compiler::Uniform(*rng, -97.0, -77.5),
            kg_compiler::Uniform(*rng, 19.0, 32.5)};
  }
  const std::size_t agent = (*rng)() % mission.agents.size();
  const kg_base::LonLat start = mission.agents[agent].start;
  return {start.lon_deg + kg_compiler::Uniform(*rng, -0.5, 0.5),
          start.lat_deg + kg_compiler::Uniform(*rng, -0.5, 0.5)};
}

// 40 x 40 cells at 0.04 degree, in the middle window.
kg_mission::Mission WithArea(kg_mission::Mission mission, kg_base::LonLat at) {
  mission.constraints.push_back(kg_compiler::AreaConstraint(
      "ex:area", kg_mission::ConstraintKind::kSoft,
      kg_compiler::Box(at.lon_deg - 0.8, at.lat_deg - 0.8, at.lon_deg + 0.8,
                       at.lat_deg + 0.8)));
  mission.constraints[0].attenuation = 0.5;
  mission.constraints[0].windows = {static_cast<int>(mission.windows.size()) /
                                    2};
  return mission;
}

struct BenchWorld {
  MissionCompiler compiler;
  CompilationPtr compilation;
  PlannedMission planned;
};

BenchWorld PlanAll(MissionCompiler compiler, const kg_mission::Mission& mission,
                   const PlannedMission* previous) {
  BenchWorld world{std::move(compiler), nullptr, {}};
  world.compilation = world.compiler.Compile(mission, 1, 0);
  world.planned = PlanMission(*world.compilation, previous);
  return world;
}

struct StageTimes {
  double compile_s = 0.0, graphs_s = 0.0, team_s = 0.0;
  double total_s() const { return compile_s + graphs_s + team_s; }
};

StageTimes StagesOf(const BenchWorld& world) {
  const auto& compile = world.compilation->stage_seconds;
  return {compile.at("tensors") + compile.at("rules"),
          world.planned.stage_seconds.at("graphs"),
          world.planned.stage_seconds.at("team")};
}

SeamCounts CountsOf(const PlannedMission& planned) {
  SeamCounts all;
  for (const auto& [agent, cache] : planned.caches) {
    const SeamCounts& one = cache.seams.counts;
    all.graphs += one.graphs, all.graphs_kept += one.graphs_kept;
    all.reaches += one.reaches, all.reaches_kept += one.reaches_kept;
    all.flights += one.flights, all.flights_kept += one.flights_kept;
    all.seams_s += one.seams_s;
  }
  return all;
}

void Show(const char* name, const BenchWorld& world) {
  const StageTimes stages = StagesOf(world);
  const SeamCounts seams = CountsOf(world.planned);
  std::printf(
      "  %-12s compile %8.3f ms, graphs %9.3f ms (seams %9.3f ms of all "
      "threads), stitch + select %8.3f ms; tensors %zu of %zu, graphs %d + %d "
      "kept, arrival fields %d + %d, flights %d + %d\n",
      name, 1e3 * stages.compile_s, 1e3 * stages.graphs_s, 1e3 * seams.seams_s,
      1e3 * stages.team_s, world.compilation->counts.compiled,
      world.compilation->counts.tensors, seams.graphs, seams.graphs_kept,
      seams.reaches, seams.reaches_kept, seams.flights, seams.flights_kept);
}

bool SameBits(const BenchWorld& a, const BenchWorld& b) {
  auto found = kg_compiler::Compare(*a.compilation, *b.compilation);
  for (std::size_t i = 0; i < a.planned.members.size(); ++i) {
    const auto graphs = kg_compiler::Compare(a.planned.members[i].graphs,
                                             b.planned.members[i].graphs);
    found.compared += graphs.compared;
    found.differs.insert(found.differs.end(), graphs.differs.begin(),
                         graphs.differs.end());
  }
  const bool same =
      found.differs.empty() &&
      a.planned.plan.score() == b.planned.plan.score() &&
      a.planned.plan.committed.size() == b.planned.plan.committed.size();
  std::printf("  %zu artifacts compared bit by bit: %zu differ; plans %s\n",
              found.compared, found.differs.size(), same ? "equal" : "differ");
  for (const std::string& name : found.differs) {
    std::printf("    differs: %s\n", name.c_str());
  }
  return same;
}

// Medians of full / incremental time over areas.
class TimeRatios {
 public:
  void Add(const BenchWorld& full, const BenchWorld& step) {
    const StageTimes a = StagesOf(full), b = StagesOf(step);
    whole_.push_back(a.total_s() / b.total_s());
    compile_.push_back(a.compile_s / b.compile_s);
    graphs_.push_back(a.graphs_s / b.graphs_s);
    team_.push_back(a.team_s / b.team_s);
  }
  double whole() const { return kg_base::Median(whole_); }
  void Show(const char* where) const {
    std::printf(
        "  areas %s: all %.1f x, compile %.1f x, graphs %.1f x, stitch + "
        "select %.1f x\n",
        where, whole(), kg_base::Median(compile_), kg_base::Median(graphs_),
        kg_base::Median(team_));
  }

 private:
  std::vector<double> whole_, compile_, graphs_, team_;
};

struct BenchTrial {
  BenchTeam team;
  ChangePlace where = ChangePlace::kAnywhere;
  int rounds = 1;
};

// False if a bit differs.
bool Measure(const BenchTrial& trial, const BenchWorld& base,
             TimeRatios* ratios) {
  const MissionCompiler empty(ReadersFor(trial.team));
  const kg_mission::Mission before = MakeMission(trial.team);
  std::mt19937 rng(7);
  bool same = true;
  for (int i = 0; i < trial.rounds; ++i) {
    const kg_mission::Mission after =
        WithArea(before, MiddleOf(trial.where, before, &rng));
    // One run from scratch, one from the previous mission's data.
    const BenchWorld full = PlanAll(empty, after, nullptr);
    const BenchWorld step = PlanAll(base.compiler, after, &base.planned);
    Show("full", full);
    Show("incremental", step);
    ratios->Add(full, step);
    same = SameBits(full, step) && same;
  }
  return same;
}

bool CompareTeam(const BenchTeam& team, double goal, int rounds) {
  const kg_mission::Mission mission = MakeMission(team);
  const BenchWorld base =
      PlanAll(MissionCompiler(ReadersFor(team)), mission, nullptr);
  std::printf("%d agents x %d windows, %zu cells, %d waypoints\n", team.agents,
              team.windows, base.compilation->fields[0]->field.grid.size(),
              mission.coordination.waypoints_per_window);
  TimeRatios anywhere, in_the_way;
  bool same = Measure({team, ChangePlace::kAnywhere, rounds}, base, &anywhere);
  same = Measure({team, ChangePlace::kInTheWay, (rounds + 2) / 3}, base,
                 &in_the_way) &&
         same;
  anywhere.Show("anywhere in the grid");
  in_the_way.Show("in an agent's way");
  const std::string what = "full against incremental, " +
                           std::to_string(team.agents) + " x " +
                           std::to_string(team.windows);
  kg_base::Report({13, what, goal, true, "x"}, anywhere.whole());
  return same;
}

double PeakMemory_mb() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.0;  // Kilobytes.
}

// CPU time of all threads so far [s]: independent of other load on the machine.
double Cpu_s() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * time.tv_usec;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// One agent with its own policy, so that all rasters exist.
kg_mission::Mission Scout(const BenchTeam& team) {
  kg_mission::Mission mission = MakeMission(team);
  mission.agents.resize(1);
  mission.agents[0].policy.alpha_base = 0.123;
  return mission;
}

bool Scale(const BenchTeam& team) {
  MissionCompiler compiler(ReadersFor(team));
  compiler.Compile(Scout(team), 1, 0);
  const double before_s = Cpu_s();
  const CompilationPtr all = compiler.Compile(MakeMission(team), 2, 0);
  const double cpu_s = Cpu_s() - before_s;
  const std::string name =
      std::to_string(team.agents) + " x " + std::to_string(team.windows);
  std::printf("%s, %d classes: %zu tensors, %zu distinct, %zu compiled\n",
              name.c_str(), team.classes, all->counts.tensors,
              all->counts.distinct, all->counts.compiled);
  kg_base::Report({15, name + ": compiled less distinct", 0, false, ""},
                  static_cast<double>(all->counts.compiled) -
                      static_cast<double>(team.classes) * team.windows);
  kg_base::Report({15, name + ": compile, seconds of a core", 10, false, "s"},
                  cpu_s);
  kg_base::Report({15, name + ": peak memory", 1024, false, "MB"},
                  PeakMemory_mb());
  return all->counts.compiled == all->counts.distinct;
}

int Run(bool quick) {
  if (quick) {
    const bool counts = Scale({20, 3, 5, 1});
    return counts && CompareTeam({3, 3, 3, 1}, 50.0, 1) ? 0 : 1;
  }
  // Runs first because peak memory never falls.
  bool good = Scale({100, 168, 5, 1});
  good = CompareTeam({3, 7, 3, 2}, 50.0, 7) && good;
  good = CompareTeam({10, 24, 5, 2}, 150.0, 3) && good;
  return good ? 0 : 1;
}

}  // namespace
}  // namespace kg_selector

int main(int argc, char** argv) {
  return kg_selector::Run(argc > 1 && std::strcmp(argv[1], "--quick") == 0);
}
