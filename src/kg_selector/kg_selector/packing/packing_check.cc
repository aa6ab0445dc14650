#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "kg_selector/packing/packing.h"

namespace kg_selector {
namespace {

[[noreturn]] void Refuse(const std::string& what, std::size_t index,
                         const std::string& why) {
  throw std::invalid_argument(what + " " + std::to_string(index) + ": " + why);
}

bool IsIndexOf(int index, std::size_t size) {
  return index >= 0 && index < static_cast<int>(size);
}

void CheckColumn(const Packing& packing, std::size_t index) {
  const Column& column = packing.columns[index];
  if (!IsIndexOf(column.agent, packing.agent_counts.size())) {
    Refuse("column", index, "no such agent");
  }
  if (!std::isfinite(column.score) || !std::isfinite(column.load)) {
    Refuse("column", index, "score or load not finite");
  }
  std::set<int> rows;
  for (int row : column.rows) {
    if (!IsIndexOf(row, packing.row_capacities.size())) {
      Refuse("column", index, "no such row");
    }
    if (!rows.insert(row).second) Refuse("column", index, "a row twice");
  }
}

void CheckCounts(const char* what, const std::vector<int>& counts) {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] < 0) Refuse(what, i, "capacity below 0");
  }
}

void CheckFairness(const Packing& packing) {
  if (!(packing.weight >= 0.0 && std::isfinite(packing.weight))) {
    throw std::invalid_argument("weight: not finite and >= 0");
  }
  if (packing.fairness == Fairness::kNone) return;
  for (std::size_t i = 0; i < packing.agent_counts.size(); ++i) {
    if (packing.agent_counts[i] != 1) {
      Refuse("agent", i, "fairness is between distinct agents");
    }
  }
}

}  // namespace

void Check(const Packing& packing) {
  CheckCounts("agent", packing.agent_counts);
  CheckCounts("row", packing.row_capacities);
  for (std::size_t i = 0; i < packing.columns.size(); ++i) {
    CheckColumn(packing, i);
  }
  for (std::size_t i = 0; i < packing.conflicts.size(); ++i) {
    const auto [a, b] = packing.conflicts[i];
    if (!IsIndexOf(a, packing.columns.size()) ||
        !IsIndexOf(b, packing.columns.size()) || a == b) {
      Refuse("conflict", i, "not between two columns");
    }
  }
  CheckFairness(packing);
}

}  // namespace kg_selector
