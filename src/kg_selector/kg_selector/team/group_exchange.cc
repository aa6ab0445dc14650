#include "kg_selector/team/group_exchange.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kg_selector {
namespace {

// Best column of an agent under prices; kNobody = none.
int FindWish(const TeamColumns& pool, int agent,
             const std::vector<double>& prices) {
  int wish = kNobody;
  double max_value = 0.0;
  for (const int column : pool.columns_of(agent)) {
    const double value = pool.Reduced(column, prices);
    if (wish != kNobody && !(value > max_value)) continue;
    wish = column;
    max_value = value;
  }
  return wish;
}

int CommonRows(const Column& a, const Column& b) {
  std::vector<int> common;
  std::set_intersection(a.rows.begin(), a.rows.end(), b.rows.begin(),
                        b.rows.end(), std::back_inserter(common));
  return static_cast<int>(common.size());
}

}  // namespace

void GroupExchange::Drop(int agent) {
  dropped_.insert(agent);
  if (agent < static_cast<int>(choice_.size())) choice_[agent] = kNobody;
  for (Group& group : groups_) {
    if (std::count(group.members.begin(), group.members.end(), agent) > 0) {
      group.members.clear();  // The group keeps its columns.
    }
  }
}

// Most shared rows first; ties in random order.
std::vector<int> GroupExchange::FindRivals(const TeamColumns& pool, int agent,
                                           const std::set<int>& free) {
  const int wish = FindWish(pool, agent, prices_);
  std::vector<std::pair<int, std::pair<unsigned, int>>> order;
  for (const int other : free) {
    if (other == agent) continue;
    int overlap = 0;
    if (wish != kNobody && choice_[other] != kNobody) {
      overlap =
          CommonRows(pool.columns()[wish], pool.columns()[choice_[other]]);
    }
    const unsigned chance = prng_();
    order.push_back({-overlap, {chance, other}});
  }
  std::sort(order.begin(), order.end());
  std::vector<int> rivals;
  for (const auto& [overlap, other] : order) rivals.push_back(other.second);
  return rivals;
}

void GroupExchange::MakeGroups(const TeamColumns& pool) {
  std::set<int> free;
  for (int agent = 0; agent < pool.agents(); ++agent) {
    if (dropped_.count(agent) == 0) free.insert(agent);
  }
  // Groups of 2 to 4: larger ones rarely improve the plan.
  const int size = 2 + Random(3);
  groups_.clear();
  while (!free.empty()) {
    auto first = free.begin();
    std::advance(first, Random(static_cast<int>(free.size())));
    Group group;
    group.members = FindRivals(pool, *first, free);
    group.members.insert(group.members.begin(), *first);
    if (static_cast<int>(group.members.size()) > size) {
      group.members.resize(size);
    }
    // Fisher-Yates shuffle: std::shuffle is not reproducible across libraries.
    for (std::size_t i = group.members.size(); i > 1; --i) {
      std::swap(group.members[i - 1],
                group.members[Random(static_cast<int>(i))]);
    }
    for (const int member : group.members) free.erase(member);
    // 0 to 1.2 of the prices: above 1 leaves contested rows to the last member.
    group.share = 0.012 * Random(101);
    groups_.push_back(std::move(group));
  }
}

ColumnRequests GroupExchange::Begin(const TeamColumns& pool,
                                    const TeamChoice& choice,
                                    const std::vector<double>& prices) {
  choice_ = choice;
  prices_ = prices;
  member_ = 0;
  MakeGroups(pool);
  return RequestMembers();
}

ColumnRequests GroupExchange::RequestMembers() const {
  ColumnRequests requests;
  for (const Group& group : groups_) {
    if (member_ >= group.members.size()) continue;
    ColumnRequest request;
    // The last member pays nothing.
    if (member_ + 1 < group.members.size()) {
      for (const double price : prices_) {
        request.prices.push_back(group.share * price);
      }
    }
    // Around all agents outside the group, and the members that answered.
    TeamChoice others = choice_;
    for (const int member : group.members) others[member] = kNobody;
    for (const int column : others) {
      if (column != kNobody) request.around.push_back(column);
    }
    for (const int column : group.columns) {
      if (column != kNobody) request.around.push_back(column);
    }
    requests[group.members[member_]] = std::move(request);
  }
  return requests;
}

ColumnRequests GroupExchange::Next(const ColumnAnswers& answers) {
  for (Group& group : groups_) {
    if (member_ >= group.members.size()) continue;
    const auto answer = answers.find(group.members[member_]);
    const bool none = answer == answers.end() || answer->second.columns.empty();
    group.columns.push_back(none ? kNobody : answer->second.columns.front());
  }
  ++member_;
  return RequestMembers();
}

TeamChoice GroupExchange::End(const TeamColumns& pool, const TeamWorth& best,
                              double slack) const {
  TeamChoice choice = choice_;
  for (const Group& group : groups_) {
    TeamChoice changed = choice;
    for (std::size_t i = 0; i < group.members.size(); ++i) {
      changed[group.members[i]] =
          i < group.columns.size() ? group.columns[i] : kNobody;
    }
    if (changed == choice || !pool.IsAllowed(changed)) continue;
    TeamWorth worth = pool.Worth(changed);
    const bool better = IsMore(worth, pool.Worth(choice));
    worth.second += slack;
    if (better || IsMore(worth, best)) choice = std::move(changed);
  }
  return choice;
}

}  // namespace kg_selector
