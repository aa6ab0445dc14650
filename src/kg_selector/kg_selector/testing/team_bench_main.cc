// Teams on synthetic trellises: targets 10 and 11.
//
//   kg_selector_team_bench [--quick]
//
// Agents share T stages of n nodes with a capacity. Identical except for their
// starts: compared with the exact flow. With individual rewards and weights:
// compared with the Lagrangian bound over all paths, from mode "priced". Times
// are processor seconds.

#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "kg_base/common/testing/bench_report.h"
#include "kg_compiler/control_plane/nav_graph.h"
#include "kg_selector/team/auction_search.h"
#include "kg_selector/team/exact_search.h"
#include "kg_selector/team/priced_search.h"
#include "kg_selector/testing/team_flow.h"
#include "kg_selector/testing/trellis_team.h"

namespace kg_selector {
namespace {

double ProcessorSeconds(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

// Greedy of the paper: commit the best of all, conflicting agents replan.
TeamChoice PlanGreedily(const TrellisTeam& team, TeamColumns* pool) {
  TeamChoice choice(team.options().agents, kNobody);
  std::vector<int> wish;
  for (int a = 0; a < team.options().agents; ++a) {
    wish.push_back(team.Answer(a, {}, pool).columns.front());
  }
  for (std::size_t left = wish.size(); left > 0;) {
    int first = kNobody;
    for (const int column : wish) {
      if (column != kNobody &&
          (first == kNobody ||
           pool->columns()[column].score > pool->columns()[first].score)) {
        first = column;
      }
    }
    if (first == kNobody) break;
    const int agent = pool->columns()[first].agent;
    choice[agent] = first;
    wish[agent] = kNobody;
    // No conflict: committed.
    if (pool->IsAllowed(choice)) {
      --left;
      continue;
    }
    choice[agent] = kNobody;
    const ColumnAnswer again =
        team.Answer(agent, {{}, ChosenColumns(choice)}, pool);
    wish[agent] = again.columns.empty() ? kNobody : again.columns.front();
    left -= again.columns.empty();
  }
  return choice;
}

TeamFlow ToFlow(const TrellisTeam& team) {
  const TrellisTeamOptions& options = team.options();
  TeamFlow flow;
  flow.agents = options.agents;
  for (int t = 0; t < options.stages; ++t) {
    FlowStage stage;
    // Agents differ only in their start: seams of later stages are those of
    // agent 0.
    const int before = t == 0 ? options.agents : options.nodes;
    for (int v = 0; v < options.nodes; ++v) {
      stage.rewards.push_back(static_cast<double>(team.Reward(0, t, v)));
    }
    stage.capacities.assign(options.nodes, options.capacity);
    for (int u = 0; u < before; ++u) {
      for (int v = 0; v < options.nodes; ++v) {
        stage.seams.push_back(
            {u, v,
             static_cast<double>(team.SeamCost(t == 0 ? u : 0, t, u, v))});
      }
    }
    flow.stages.push_back(std::move(stage));
  }
  return flow;
}

struct SearchRun {
  double score = 0.0;
  double bound = 0.0;
  double seconds = 0.0;
};

SearchRun RunGreedy(const TrellisTeam& team) {
  TeamColumns pool = team.MakePool();
  SearchRun run;
  run.seconds = ProcessorSeconds(
      [&] { run.score = pool.Score(PlanGreedily(team, &pool)); });
  return run;
}

template <typename Search>
SearchRun RunMode(const TrellisTeam& team, const SearchOptions& options) {
  TeamColumns pool = team.MakePool();
  Search search(options);
  SearchRun run;
  run.seconds = ProcessorSeconds([&] { RunSearch(team, &search, &pool); });
  run.score = pool.Score(search.choice());
  run.bound = search.bound();
  return run;
}

struct TeamSize {
  TrellisTeamOptions team;
  int rounds = 1000;
  double goal = 99.0;  // Share of the bound [%].
};

std::string NameOf(const TrellisTeamOptions& o) {
  return std::to_string(o.agents) + " agents, " + std::to_string(o.nodes) +
         " x " + std::to_string(o.stages) + ", capacity " +
         std::to_string(o.capacity);
}

void Print(const char* mode, const SearchRun& run, double of) {
  std::printf("    %-8s %7.3f %%   %8.3f s\n", mode, 100.0 * run.score / of,
              run.seconds);
  std::fflush(stdout);
}

void Homogeneous(const TeamSize& size) {
  TrellisTeamOptions options = size.team;
  options.homogeneous = true;
  const TrellisTeam team(options, 1);
  const TeamFlow flow = ToFlow(team);
  FlowPlan plan;
  const double seconds = ProcessorSeconds([&] { plan = SolveFlow(flow); });
  std::printf("alike: %s: exact flow %.4g in %.3f s; of it\n",
              NameOf(options).c_str(), plan.value, seconds);
  Print("greedy", RunGreedy(team), plan.value);
  if (options.agents < 100) {
    SearchOptions search;
    search.max_rounds = size.rounds;
    search.gap_goal = 1e-4;
    Print("priced", RunMode<PricedSearch>(team, search), plan.value);
  } else {
    kg_base::Report({10, "exact flow, " + NameOf(options), 1.0, false, "s"},
                    seconds);
  }
}

void Heterogeneous(const TeamSize& size) {
  const TrellisTeam team(size.team, 1);
  SearchOptions options;
  options.max_rounds = size.rounds;
  options.gap_goal = 1e-4;
  const SearchRun priced = RunMode<PricedSearch>(team, options);
  std::printf("of their own: %s: bound %.6g; of it\n",
              NameOf(size.team).c_str(), priced.bound);
  Print("greedy", RunGreedy(team), priced.bound);
  SearchOptions auction = options;
  auction.epsilon = 0.02;
  auction.max_rounds = 20 * options.max_rounds;
  if (size.team.agents <= 50) {
    Print("auction", RunMode<AuctionSearch>(team, auction), priced.bound);
  }
  Print("priced", priced, priced.bound);
  options.time_limit_s = 10.0;
  if (size.team.agents <= 20) {
    Print("exact", RunMode<ExactSearch>(team, options), priced.bound);
  }
  kg_base::Report(
      {11, "priced, of own bound, " + NameOf(size.team), size.goal, true, "%"},
      100.0 * priced.score / priced.bound);
}

int Main(bool quick) {
  const std::vector<TeamSize> alike = {{{3, 20, 7, 1, true}, 200, 99.5},
                                       {{10, 20, 7, 1, true}, 500, 99.5},
                                       {{20, 40, 24, 1, true}, 1000, 99.5},
                                       {{50, 100, 24, 1, true}, 1000, 99.5},
                                       {{100, 200, 24, 1, true}, 0, 99.5}};
  const std::vector<TeamSize> own = {
      {{3, 20, 7, 1}, 200, 99.0},    {{10, 20, 7, 1}, 600, 99.0},
      {{20, 20, 7, 2}, 600, 99.0},   {{20, 40, 24, 1}, 4000, 99.0},
      {{50, 40, 24, 2}, 3000, 98.0}, {{100, 200, 24, 1}, 4000, 98.0}};
  for (const TeamSize& size : alike) {
    if (!quick || size.team.agents != 50) {
      TeamSize shorter = size;
      if (quick) shorter.rounds = std::min(size.rounds, 300);
      Homogeneous(shorter);
    }
  }
  for (const TeamSize& size : own) {
    if (!quick || size.rounds <= 600) Heterogeneous(size);
  }
  return 0;
}

}  // namespace
}  // namespace kg_selector

int main(int argc, char** argv) {
  return kg_selector::Main(argc > 1 && std::string(argv[1]) == "--quick");
}
