// XPath regular expressions on top of PCRE2, with limits on time and memory.
// https://www.w3.org/TR/xpath-functions/#regex-syntax

#ifndef KG_BASE_TEXT_REGEX_H_
#define KG_BASE_TEXT_REGEX_H_

#include <memory>
#include <optional>
#include <string>

#include "absl/container/flat_hash_map.h"

namespace kg_base {

class CompiledRegex;

// The regular expressions of one query, each compiled once.
class RegexCache {
 public:
  RegexCache();
  ~RegexCache();
  RegexCache(const RegexCache&) = delete;
  RegexCache& operator=(const RegexCache&) = delete;

  // Nullopt if the pattern or the flags (of "smixq") are invalid. Both
  // functions throw InputError if the match limit is exceeded.
  std::optional<bool> Matches(const std::string& text,
                              const std::string& pattern,
                              const std::string& flags);
  // Replaces all matches; "$1" is a group, "\$" a dollar. Nullopt also if the
  // pattern matches the empty string.
  std::optional<std::string> Replace(const std::string& text,
                                     const std::string& pattern,
                                     const std::string& replacement,
                                     const std::string& flags);

 private:
  const CompiledRegex* Compile(const std::string& pattern,
                               const std::string& flags);

  absl::flat_hash_map<std::string, std::unique_ptr<CompiledRegex>> compiled_;
};

}  // namespace kg_base

#endif  // KG_BASE_TEXT_REGEX_H_
