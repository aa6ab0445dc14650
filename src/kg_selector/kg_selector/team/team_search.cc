#include "kg_selector/team/team_search.h"

namespace kg_selector {

std::vector<int> ChosenColumns(const TeamChoice& choice) {
  std::vector<int> columns;
  for (const int column : choice) {
    if (column != kNobody) columns.push_back(column);
  }
  return columns;
}

ColumnRequests RequestUnservedBeside(const TeamChoice& choice,
                                     const std::set<int>& dropped) {
  ColumnRequests requests;
  for (std::size_t a = 0; a < choice.size(); ++a) {
    const int agent = static_cast<int>(a);
    if (choice[a] == kNobody && dropped.count(agent) == 0) {
      requests[agent] = {{}, ChosenColumns(choice)};
    }
  }
  return requests;
}

ColumnRequests RequestAll(const std::vector<double>& prices, int agents,
                          const std::set<int>& dropped) {
  ColumnRequests requests;
  for (int agent = 0; agent < agents; ++agent) {
    if (dropped.count(agent) == 0) requests[agent] = {prices, {}};
  }
  return requests;
}

}  // namespace kg_selector
