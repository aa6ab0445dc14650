#include "kg_selector/team/team_search.h"

namespace kg_selector {

std::vector<int> ColumnsOf(const TeamChoice& choice) {
  std::vector<int> columns;
  for (const int column : choice)
    if (column != kNobody) columns.push_back(column);
  return columns;
}

ColumnAsks AskUnservedBeside(const TeamChoice& choice,
                             const std::set<int>& dropped) {
  ColumnAsks asks;
  for (std::size_t a = 0; a < choice.size(); ++a) {
    const int agent = static_cast<int>(a);
    if (choice[a] == kNobody && dropped.count(agent) == 0)
      asks[agent] = {{}, ColumnsOf(choice)};
  }
  return asks;
}

ColumnAsks AskAllAt(const std::vector<double>& prices, int agents,
                    const std::set<int>& dropped) {
  ColumnAsks asks;
  for (int agent = 0; agent < agents; ++agent)
    if (dropped.count(agent) == 0) asks[agent] = {prices, {}};
  return asks;
}

}  // namespace kg_selector
