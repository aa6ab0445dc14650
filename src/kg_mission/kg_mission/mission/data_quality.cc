#include "kg_mission/mission/data_quality.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "kg_base/common/join_strings.h"
#include "kg_base/raster/time_steps.h"
#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/fact_writer.h"
#include "kg_core/facts/literals.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_mission/mission/entity.h"

namespace kg_mission {
namespace {

using kg_base::FieldFile;
using kg_base::VariableReport;
using kg_core::AbbreviateIri;
using kg_core::Ex;
using kg_core::FactWriter;
using kg_core::Term;

constexpr double kHour_s = 3600.0;
// Years that xsd:dateTime has in four digits.
constexpr double kMinTime_s = -62135596800.0;
constexpr double kMaxTime_s = 253402300799.0;

bool HasDateTime(double time_s) {  // Negated comparison, to catch NaN as well.
  return time_s >= kMinTime_s && time_s <= kMaxTime_s;
}

// From when the data are, seen from the mission: their issue if the file tells,
// otherwise their last time.
double Staleness_h(const FieldFile& file, const VariableReport& report,
                   double mission_begin_s) {
  const double from_s = std::isnan(report.issue_time_s) ? file.time_s.back()
                                                        : report.issue_time_s;
  return (mission_begin_s - from_s) / kHour_s;
}

void AddTexts(const VariableReport& report, FactWriter* facts) {
  facts->Text("variable", report.variable).Text("quantity", report.quantity);
  if (!report.level.empty()) facts->Text("level", report.level);
  if (!report.unit.empty()) facts->Text("sourceUnit", report.unit);
  for (const std::string& warning : report.warnings) {
    facts->Text("warning", warning);
  }
}

void AddTimes(const FieldFile& file, const VariableReport& report,
              double mission_begin_s, FactWriter* facts) {
  const std::vector<double>& time_s = file.time_s;
  if (std::isnan(time_s.front())) return;
  // A variable that is read by name keeps the order of its file.
  const auto [first, last] = std::minmax_element(time_s.begin(), time_s.end());
  if (!HasDateTime(*first) || !HasDateTime(*last)) return;
  facts->Integer("timeCount", static_cast<long long>(time_s.size()))
      .Time(Ex("firstTime"), *first)
      .Time(Ex("lastTime"), *last);
  if (std::is_sorted(time_s.begin(), time_s.end())) {
    const kg_base::TimeSteps steps = kg_base::FindTimeSteps(time_s);
    facts->Add(Ex("usualStepHours"),
               kg_core::DoubleLiteral(steps.usual_s / kHour_s));
    facts->Integer("missingTimes", static_cast<long long>(steps.missing));
  }
  if (HasDateTime(report.issue_time_s)) {
    facts->Time(Ex("issueTime"), report.issue_time_s);
  }
  facts->Add(Ex("stalenessHours"), kg_core::DoubleLiteral(Staleness_h(
                                       file, report, mission_begin_s)));
}

void AddCells(const VariableReport& report, FactWriter* facts) {
  const auto count = [](std::size_t n) { return static_cast<long long>(n); };
  facts->Integer("cellCount", count(report.cells))
      .Integer("cellsWithoutData", count(report.cells_without_data))
      .Integer("impossibleValues", count(report.impossible_values))
      .Integer("outliers", count(report.outliers));
}

// The node whose ingest made a report.
std::string SourceText(const FactEntity& report) {
  return AbbreviateIri(report.Follow(Ex("ingestedFrom")).iri());
}

std::vector<FactEntity> Reports(const kg_core::GraphView& view) {
  std::vector<FactEntity> reports;
  for (const Term& term : kg_core::FindInstances(view, kg_core::kFactsGraph,
                                                 Ex("DataQualityReport"))) {
    reports.emplace_back(view, term);
  }
  std::sort(reports.begin(), reports.end(),
            [](const FactEntity& a, const FactEntity& b) {
              return a.iri() < b.iri();
            });
  return reports;
}

std::string TimesLine(const FactEntity& report) {
  const int count = report.Integer(Ex("timeCount"), 0);
  if (count == 0) return "no time";
  std::ostringstream line;
  line << count << (count == 1 ? " time, " : " times, ")
       << kg_base::TimeText(*report.MaybeTime_s(Ex("firstTime")));
  if (count == 1) return line.str();
  line << " to " << kg_base::TimeText(*report.MaybeTime_s(Ex("lastTime")));
  const std::optional<double> step_h = report.MaybeNumber(Ex("usualStepHours"));
  if (step_h) {
    line << ", every " << *step_h << " h, "
         << report.Integer(Ex("missingTimes"), 0) << " missing";
  }
  return line.str();
}

std::string CellsLine(const FactEntity& report) {
  const int cells = report.Integer(Ex("cellCount"));
  const int empty = report.Integer(Ex("cellsWithoutData"));
  std::ostringstream line;
  line.precision(3);
  line << cells << " cells, " << 100.0 * empty / std::max(cells, 1)
       << " % without data";
  for (const auto& [property, words] :
       {std::pair{"impossibleValues", "impossible values"},
        std::pair{"outliers", "outliers"}}) {
    const int count = report.Integer(Ex(property), 0);
    if (count > 0) line << ", " << count << " " << words;
  }
  return line.str();
}

std::string SummaryText(const FactEntity& report) {
  const FactEntity file = report.Follow(kg_core::Prov("wasDerivedFrom"));
  std::vector<std::string> parts = {report.Text(Ex("variable")) + " of " +
                                    file.Text(Ex("path"))};
  for (const char* property : {"level", "sourceUnit"}) {
    const std::string text = report.Text(Ex(property), "");
    if (text.empty()) continue;
    parts.push_back((std::string(property) == "level" ? "level " : "unit ") +
                    text);
  }
  parts.push_back(TimesLine(report));
  parts.push_back(CellsLine(report));
  return kg_base::JoinStrings(parts, "; ");
}

}  // namespace

void StateDataQuality(const Term& subject, const FieldFile& file,
                      const kg_base::QuantitySeries& series,
                      double mission_begin_s,
                      kg_core::Transaction& transaction) {
  FactWriter facts(kg_core::Facts());
  facts.About(subject);
  AddTexts(series.report, &facts);
  AddTimes(file, series.report, mission_begin_s, &facts);
  AddCells(series.report, &facts);
  facts.AddTo(transaction);
}

std::vector<DataSummary> SummarizeData(const kg_core::GraphView& view) {
  std::vector<DataSummary> summaries;
  for (const FactEntity& report : Reports(view)) {
    summaries.push_back(
        {SourceText(report) + ": " + report.Text(Ex("quantity")),
         SummaryText(report)});
  }
  return summaries;
}

std::vector<std::string> DataWarnings(const kg_core::GraphView& view) {
  // Variables by source and warning.
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> found;
  for (const FactEntity& report : Reports(view)) {
    for (const Term& warning : report.All(Ex("warning"))) {
      found[{SourceText(report), warning.text}].push_back(
          report.Text(Ex("variable")));
    }
  }
  std::vector<std::string> lines;
  for (const auto& [key, variables] : found) {
    lines.push_back(key.first + ": " + kg_base::JoinStrings(variables) + ": " +
                    key.second);
  }
  return lines;
}

}  // namespace kg_mission
