// The shipped queries (config/queries) on a planned mission of two agents, with
// one fact changed since: compares answers with golden/. With KG_WRITE_GOLDEN=1
// in the environment the golden files are written instead.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "gtest/gtest.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/common/text.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/results.h"
#include "kg_engine/server/testing/test_mission.h"
#include "kg_engine/server/testing/test_team.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine {
namespace {

namespace fs = std::filesystem;

constexpr char kQueries[] = "../../config/queries";
constexpr char kGolden[] = "kg_engine/server/golden";
constexpr std::size_t kMaxBytes = 1u << 20;

struct Case {
  const char* query;   // File name without ".rq".
  const char* golden;  // File name without ".csv".
  const char* values;  // Parameters, appended as a VALUES clause.
};

const Case kCases[] = {
    {"who_said", "who_said",
     "VALUES ?subject { ex:alpha ex:fast ex:mission "
     "<http://example.org/mission/sst/w1> }"},
    {"fact_history", "fact_history", "VALUES ?author { \"operator\" }"},
    {"provenance_trace", "provenance_trace", ""},
    {"provenance_trace", "provenance_trace_of_bravo",
     "VALUES (?agent ?window) { (\"bravo\" 1) }"},
    {"mission_audit", "mission_audit", ""},
    {"assignments_current", "assignments_current", ""},
    {"rejections", "rejections", "VALUES ?to { \"alpha\" \"bravo\" }"},
    {"cooling_and_prices", "cooling_and_prices", ""},
    {"stale_artifacts", "stale_artifacts", ""},
    {"plan_runs", "plan_runs", ""},
    {"activities", "activities", ""},
};

// A planned mission; made once, as it is only read.
class PlannedTestMission {
 public:
  PlannedTestMission() {
    server_ = StartTestServer(folder_);
    kg_core::FactUpdate join;
    join.id = "join";
    join.author = "operator";
    join.turtle = kSecondAgent;
    join.set = {{"ex:mission", "ex:minimumSeparationKm", "5"}};
    MissionPlanning team(server_.get());
    Apply(join);
    team.Plan();
    team.Plan();
    kg_core::FactUpdate change;
    change.id = "later";
    change.author = "chief";
    change.set = {{"ex:w1", "ex:confidence", "0.5"}};
    Apply(change);
  }

  kg_core::QueryResult Ask(const std::string& text) const {
    return kg_core::RunQuery(
        *server_->Read(), text,
        kg_core::DefaultDataset(PlanGraph(server_->plan_run()).text), {});
  }
  std::string folder() const { return folder_ / ""; }

 private:
  void Apply(const kg_core::FactUpdate& update) {
    const Decision decision = server_->Apply(update);
    if (!decision.accepted) throw std::runtime_error(decision.reasons.at(0));
  }

  kg_base::TemporaryFolder folder_;
  std::unique_ptr<MissionServer> server_;
};

PlannedTestMission& SharedMission() {
  static PlannedTestMission mission;
  return mission;
}

// Three significant digits.
std::string Round(const std::string& text) {
  static const std::regex number(
      "-?[0-9]+\\.[0-9]+(E[-+]?[0-9]+)?|"
      "-?[0-9](\\.[0-9]+)?E[-+]?[0-9]+",
      std::regex::icase);
  std::string rounded;
  auto at = text.cbegin();
  for (std::sregex_iterator found(text.begin(), text.end(), number), end;
       found != end; ++found) {
    rounded.append(at, (*found)[0].first);
    char value[32];
    std::snprintf(value, sizeof value, "%.3g", std::stod(found->str()));
    rounded += value;
    at = (*found)[0].second;
  }
  return rounded.append(at, text.cend());
}

// Removes parts that depend on run and location; sorts rows.
std::string Normalise(std::string text, const std::string& folder) {
  for (std::size_t at = text.find(folder); at != std::string::npos;
       at = text.find(folder)) {
    text.replace(at, folder.size(), "FOLDER/");
  }
  text = std::regex_replace(text, std::regex("\r"), "");
  text =
      std::regex_replace(text, std::regex("/[^,\n]*/ontology/"), "ONTOLOGY/");
  text = std::regex_replace(text, std::regex("(^|[^0-9a-f.])[0-9a-f]{16,64}"),
                            "$1HASH");  // Does not match decimals of a number.
  text = std::regex_replace(
      text, std::regex("(?!2026-06-0)[0-9]{4}-[0-9-]+T[0-9:.]+Z"), "TIME");
  std::istringstream lines(Round(text));
  std::string head;
  std::getline(lines, head);
  std::multiset<std::string> rows;
  for (std::string row; std::getline(lines, row);) rows.insert(row);
  for (const std::string& row : rows) head += "\n" + row;
  return head + "\n";
}

TEST(ShippedQueries, AnswerAsTheyDidWhenTheyWereLookedAt) {
  for (const Case& one : kCases) {
    const std::string path = std::string(kQueries) + "/" + one.query + ".rq";
    const kg_core::QueryResult result = SharedMission().Ask(
        kg_base::ReadFile(path, kMaxBytes) + "\n" + one.values);
    EXPECT_GT(result.rows.size(), 0u) << one.golden;
    const std::string answer =
        Normalise(kg_core::ToCsv(result), SharedMission().folder());
    const std::string golden = std::string(kGolden) + "/" + one.golden + ".csv";
    if (std::getenv("KG_WRITE_GOLDEN") != nullptr) {
      std::ofstream(golden) << answer;
      continue;
    }
    EXPECT_EQ(kg_base::ReadFile(golden, kMaxBytes), answer) << one.golden;
  }
}

TEST(ShippedQueries, SayWhatTheyAnswerAndForWhichParameters) {
  for (const Case& one : kCases) {
    const std::string text = kg_base::ReadFile(
        std::string(kQueries) + "/" + one.query + ".rq", kMaxBytes);
    EXPECT_EQ(text.rfind("# ", 0), 0u) << one.query;
    EXPECT_NE(text.find("# Parameters: "), std::string::npos) << one.query;
    EXPECT_NE(text.find("\nPREFIX ex: "), std::string::npos) << one.query;
  }
}

TEST(ShippedQueries, EveryFactHasAnAuthor) {
  const std::string text =
      kg_base::ReadFile(std::string(kQueries) + "/who_said.rq", kMaxBytes);
  const kg_core::QueryResult said = SharedMission().Ask(text);
  const kg_core::QueryResult facts =
      SharedMission().Ask("SELECT ?s ?p ?o { GRAPH graph:facts { ?s ?p ?o } }");
  EXPECT_EQ(said.rows.size(), facts.rows.size());
}

}  // namespace
}  // namespace kg_engine
