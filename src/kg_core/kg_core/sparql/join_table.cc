#include "kg_core/sparql/join_table.h"

#include "kg_core/sparql/matched_scope.h"

namespace kg_core::sparql {

JoinTable::JoinTable(const GraphPattern& pattern, QueryBudget* budget,
                     std::vector<Quad>* matched)
    : budget_(budget),
      matched_(matched),
      matched_before_(matched == nullptr ? 0 : matched->size()) {
  for (const int variable : pattern.possible.Members()) {
    columns_.push_back(static_cast<std::size_t>(variable));
    certain_.push_back(pattern.certain.Contains(variable));
  }
}

void JoinTable::Add(const Row& row) {
  budget_->UseWorkingBytes(sizeof(TermId) * (columns_.size() + 4));
  for (const std::size_t variable : columns_) cells_.push_back(row[variable]);
  all_.push_back(static_cast<std::uint32_t>(all_.size()));
  if (matched_ == nullptr) return;
  matched_of_.push_back(MatchedSince(*matched_, matched_before_));
  budget_->UseWorkingBytes(sizeof(Quad) * (matched_of_.back().size() + 2));
}

const std::vector<std::uint32_t>& JoinTable::Candidates(const Row& row) {
  static const std::vector<std::uint32_t>* const kNobody =
      new std::vector<std::uint32_t>();
  // Join key: the columns bound in `row` and in every solution.
  std::vector<std::size_t> key_columns;
  Row key;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!certain_[i] || row[columns_[i]] == kNoTerm) continue;
    key_columns.push_back(i);
    key.push_back(row[columns_[i]]);
  }
  if (key.empty()) return all_;
  const auto [index, is_new] = indices_.try_emplace(key_columns);
  // One hash index per set of key columns, built on first use.
  if (is_new) {
    Row cells(key_columns.size());
    for (const std::uint32_t solution : all_) {
      budget_->Step();
      for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i] = At(solution, key_columns[i]);
      }
      index->second[cells].push_back(solution);
    }
    budget_->UseWorkingBytes(all_.size() * (48 + 4 * cells.size()));
  }
  const auto found = index->second.find(key);
  return found == index->second.end() ? *kNobody : found->second;
}

bool JoinTable::Agrees(std::size_t solution, const Row& row,
                       bool* shares) const {
  budget_->Step();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const TermId here = At(solution, i);
    const TermId there = row[columns_[i]];
    if (here == kNoTerm || there == kNoTerm) continue;
    if (here != there) return false;
    *shares = true;
  }
  return true;
}

bool JoinTable::Join(Row* row, absl::FunctionRef<bool(Row&)> emit) {
  const std::vector<std::uint32_t>& candidates = Candidates(*row);
  std::vector<std::size_t> bound;
  for (const std::uint32_t solution : candidates) {
    bool shares = false;
    if (!Agrees(solution, *row, &shares)) continue;
    bound.clear();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      TermId& slot = (*row)[columns_[i]];
      if (slot != kNoTerm) continue;
      slot = At(solution, i);
      bound.push_back(columns_[i]);
    }
    const MatchedScope scope(matched_);
    if (matched_ != nullptr) scope.Append(matched_of_[solution]);
    const bool go_on = emit(*row);
    // Undo the bindings even if the evaluation stops here.
    for (const std::size_t variable : bound) (*row)[variable] = kNoTerm;
    if (!go_on) return false;
  }
  return true;
}

bool JoinTable::HasSharing(const Row& row) {
  for (const std::uint32_t solution : Candidates(row)) {
    bool shares = false;
    if (Agrees(solution, row, &shares) && shares) return true;
  }
  return false;
}

}  // namespace kg_core::sparql
