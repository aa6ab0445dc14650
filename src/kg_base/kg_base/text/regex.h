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

  // Nullopt if the pattern is none of XPath's (xpath_pattern.h) or the flags
  // are not of "smixq". Both functions throw InputError if the match limit is
  // exceeded.
  std::optional<bool> Matches(const std::string& text,
                              const std::string& pattern,
                              const std::string& flags);
  // Replaces all matches; "$1" is a group, "\$" a dollar. "$10" is the tenth
  // group if the pattern has ten, else the first and a '0'; with flag q none is
  // special. Nullopt also if the pattern matches the empty string.
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
