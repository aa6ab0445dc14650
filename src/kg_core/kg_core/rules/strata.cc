#include "kg_core/rules/strata.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "kg_base/common/input_error.h"

namespace kg_core {
namespace {

using Kinds = std::vector<TripleKind>;

// The first of `reads` that meets one of `writes`, or null.
const TripleKind* FirstMet(const Kinds& writes, const Kinds& reads) {
  for (const TripleKind& read : reads) {
    for (const TripleKind& write : writes) {
      if (Overlap(write, read)) return &read;
    }
  }
  return nullptr;
}

bool Feeds(const Rule& from, const Rule& to) {
  return FirstMet(from.writes, to.reads) != nullptr ||
         FirstMet(from.writes, to.negative_reads) != nullptr;
}

// Transitive dependencies between rules.
class RuleNeeds {
 public:
  explicit RuleNeeds(const std::vector<Rule>& rules)
      : count_(rules.size()), needs_(count_ * count_, false) {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < count_; ++j) {
        needs_[i * count_ + j] = Feeds(rules[j], rules[i]);
      }
    }
    for (std::size_t via = 0; via < count_; ++via) {
      for (std::size_t i = 0; i < count_; ++i) {
        if (needs_[i * count_ + via]) Inherit(i, via);
      }
    }
  }
  bool operator()(std::size_t i, std::size_t j) const {
    return needs_[i * count_ + j];
  }
  // Number of rules that rule i depends on, including itself.
  std::size_t GetCount(std::size_t i) const {
    std::size_t count = 0;
    for (std::size_t j = 0; j < count_; ++j) {
      if (j == i || (*this)(i, j)) ++count;
    }
    return count;
  }

 private:
  void Inherit(std::size_t i, std::size_t via) {
    for (std::size_t j = 0; j < count_; ++j) {
      if (needs_[via * count_ + j]) needs_[i * count_ + j] = true;
    }
  }

  std::size_t count_;
  std::vector<bool> needs_;
};

void CheckDoubts(const Stratum& stratum) {
  for (const Rule* reader : stratum.rules) {
    for (const Rule* writer : stratum.rules) {
      const TripleKind* kind = FirstMet(writer->writes, reader->negative_reads);
      if (kind == nullptr) continue;
      throw kg_base::InputError(
          ToTurtle(reader->iri) + ": its NOT EXISTS, MINUS, OPTIONAL or " +
          "aggregate reads " + ToString(*kind) + ", which " +
          ToTurtle(writer->iri) +
          " concludes, and that depends in turn on what " +
          ToTurtle(reader->iri) + " concludes");
    }
  }
}

}  // namespace

std::vector<Stratum> Stratify(const std::vector<Rule>& rules) {
  const RuleNeeds needs(rules);
  // Dependencies are transitive, so sorting by their number is a topological
  // order.
  std::vector<std::size_t> order(rules.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&needs](std::size_t a, std::size_t b) {
                     return needs.GetCount(a) < needs.GetCount(b);
                   });
  std::vector<Stratum> strata;
  // A stratum is one strongly connected component: `first` and all rules that
  // it needs and that need it.
  std::vector<bool> done(rules.size(), false);
  for (const std::size_t first : order) {
    if (done[first]) continue;
    Stratum stratum;
    stratum.recursive = needs(first, first);
    for (const std::size_t other : order) {
      const bool together =
          other == first || (needs(first, other) && needs(other, first));
      if (!together) continue;
      stratum.rules.push_back(&rules[other]);
      done[other] = true;
    }
    if (stratum.recursive) CheckDoubts(stratum);
    strata.push_back(std::move(stratum));
  }
  return strata;
}

}  // namespace kg_core
