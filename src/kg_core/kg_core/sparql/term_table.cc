#include "kg_core/sparql/term_table.h"

namespace kg_core::sparql {
namespace {

// Injective key: different terms have different keys.
std::string MakeKey(const Term& term) {
  std::string key;
  key.reserve(term.text.size() + term.datatype.size() + 8);
  key.push_back(static_cast<char>('0' + static_cast<int>(term.kind)));
  key += term.language;
  key.push_back('\0');
  key += term.datatype;
  key.push_back('\0');
  key += term.text;
  return key;
}

}  // namespace

TermId TermTable::Intern(const Term& term) {
  const TermId known = view_->Find(term);
  if (known != kNoTerm) return known;
  const auto next = kLocalBit | static_cast<TermId>(terms_.size());
  const auto [found, is_new] = ids_.emplace(MakeKey(term), next);
  if (is_new) {
    terms_.push_back(term);
    budget_->UseWorkingBytes(2 * found->first.size() + 128);
  }
  return found->second;
}

const Term& TermTable::Get(TermId id) const {
  return IsLocal(id) ? terms_[id & ~kLocalBit] : view_->Get(id);
}

}  // namespace kg_core::sparql
