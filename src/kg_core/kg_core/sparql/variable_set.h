// A set of variable numbers, stored as a bit set.

#ifndef KG_CORE_SPARQL_VARIABLE_SET_H_
#define KG_CORE_SPARQL_VARIABLE_SET_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kg_core::sparql {

class VariableSet {
 public:
  void Insert(int variable) {
    const auto word = static_cast<std::size_t>(variable) / 64;
    if (word >= words_.size()) words_.resize(word + 1);
    words_[word] |= std::uint64_t{1} << (variable % 64);
  }
  bool Contains(int variable) const {
    const auto word = static_cast<std::size_t>(variable) / 64;
    return word < words_.size() && ((words_[word] >> (variable % 64)) & 1) != 0;
  }
  void InsertAll(const VariableSet& other) {
    if (words_.size() < other.words_.size()) words_.resize(other.words_.size());
    for (std::size_t i = 0; i < other.words_.size(); ++i) {
      words_[i] |= other.words_[i];
    }
  }
  VariableSet And(const VariableSet& other) const {
    VariableSet both = *this;
    both.words_.resize(std::min(words_.size(), other.words_.size()));
    for (std::size_t i = 0; i < both.words_.size(); ++i) {
      both.words_[i] &= other.words_[i];
    }
    return both;
  }
  bool IsSubsetOf(const VariableSet& other) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const std::uint64_t there = i < other.words_.size() ? other.words_[i] : 0;
      if ((words_[i] & ~there) != 0) return false;
    }
    return true;
  }
  std::vector<int> Members() const {
    std::vector<int> members;
    for (std::size_t i = 0; i < words_.size() * 64; ++i) {
      if (Contains(static_cast<int>(i))) members.push_back(static_cast<int>(i));
    }
    return members;
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_VARIABLE_SET_H_
