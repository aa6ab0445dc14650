#include "kg_base/text/regex.h"

#define PCRE2_CODE_UNIT_WIDTH 8
#include <pcre2.h>

#include <cstdint>
#include <utility>

#include "absl/strings/ascii.h"
#include "kg_base/common/limit_error.h"
#include "kg_base/text/xpath_pattern.h"

namespace kg_base {
namespace {

constexpr std::uint32_t kMatchLimit = 200000;  // A few milliseconds of work.
constexpr std::uint32_t kHeapLimit_KiB = 20000;
constexpr std::size_t kPatternLimit_bytes = 4096;
constexpr std::size_t kReplacedLimit_bytes = 1u << 20;

// https://www.w3.org/TR/xpath-functions/#flags
std::optional<std::uint32_t> ParseOptions(const std::string& flags) {
  // A back-reference to a group that took no part matches the empty string.
  std::uint32_t options =
      PCRE2_UTF | PCRE2_NEVER_BACKSLASH_C | PCRE2_MATCH_UNSET_BACKREF;
  bool literal = false;
  for (const char flag : flags) {
    switch (flag) {
      case 's':
        options |= PCRE2_DOTALL;
        break;
      case 'm':
        options |= PCRE2_MULTILINE;
        break;
      case 'i':
        options |= PCRE2_CASELESS;
        break;
      case 'x':  // See WithoutSpace.
        break;
      case 'q':
        literal = true;
        break;
      default:
        return std::nullopt;
    }
  }
  if (!literal) return options | PCRE2_DOLLAR_ENDONLY;
  return PCRE2_LITERAL | PCRE2_UTF | (options & PCRE2_CASELESS);
}

bool IsPatternSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// The pattern for flag x: removes white space except within character classes.
// PCRE2's own flag would also recognise comments and keep spaces after a
// backslash.
std::string WithoutSpace(const std::string& pattern) {
  std::string out;
  int classes = 0;
  bool is_escaped = false;
  for (const char c : pattern) {
    if (classes == 0 && IsPatternSpace(c)) continue;
    if (!is_escaped && c == '[') ++classes;
    if (!is_escaped && c == ']' && classes > 0) --classes;
    is_escaped = !is_escaped && c == '\\';
    out.push_back(c);
  }
  return out;
}

bool Has(const std::string& flags, char flag) {
  return flags.find(flag) != std::string::npos;
}

// The pattern in PCRE2's syntax; nullopt if it is none of XPath's.
std::optional<std::string> Translate(const std::string& pattern,
                                     const std::string& flags) {
  if (Has(flags, 'q')) return pattern;
  return ToPcrePattern(Has(flags, 'x') ? WithoutSpace(pattern) : pattern);
}

PCRE2_SPTR Bytes(const std::string& text) {
  return reinterpret_cast<PCRE2_SPTR>(text.data());
}

}  // namespace

class CompiledRegex {
 public:
  CompiledRegex(const std::string& pattern, std::uint32_t options) {
    int error = 0;
    std::size_t offset = 0;
    code_.reset(pcre2_compile(Bytes(pattern), pattern.size(), options, &error,
                              &offset, nullptr));
    if (code_ == nullptr) return;
    data_.reset(pcre2_match_data_create_from_pattern(code_.get(), nullptr));
    context_.reset(pcre2_match_context_create(nullptr));
    pcre2_set_match_limit(context_.get(), kMatchLimit);
    pcre2_set_depth_limit(context_.get(), kMatchLimit);
    pcre2_set_heap_limit(context_.get(), kHeapLimit_KiB);
  }
  bool ok() const { return code_ != nullptr; }

  // The number of groups of the pattern, whether they take part or not.
  int CountGroups() const {
    std::uint32_t count = 0;
    pcre2_pattern_info(code_.get(), PCRE2_INFO_CAPTURECOUNT, &count);
    return static_cast<int>(count);
  }
  // The number of groups + 1 of the first match from `start`, 0 for none.
  int Match(const std::string& text, std::size_t start) const {
    const int found = pcre2_match(code_.get(), Bytes(text), text.size(), start,
                                  0, data_.get(), context_.get());
    if (found == PCRE2_ERROR_MATCHLIMIT || found == PCRE2_ERROR_DEPTHLIMIT ||
        found == PCRE2_ERROR_HEAPLIMIT) {
      throw LimitError(
          "a regular expression took more steps than the limit of " +
          std::to_string(kMatchLimit));
    }
    return found < 0 ? 0 : found;
  }
  // Begin and end of group i of the last match.
  std::pair<std::size_t, std::size_t> Group(int i) const {
    const PCRE2_SIZE* bounds = pcre2_get_ovector_pointer(data_.get());
    const std::size_t begin = 2 * static_cast<std::size_t>(i);
    return {bounds[begin], bounds[begin + 1]};
  }

 private:
  struct Deleter {
    void operator()(pcre2_code* p) const { pcre2_code_free(p); }
    void operator()(pcre2_match_data* p) const { pcre2_match_data_free(p); }
    void operator()(pcre2_match_context* p) const {
      pcre2_match_context_free(p);
    }
  };

  std::unique_ptr<pcre2_code, Deleter> code_;
  std::unique_ptr<pcre2_match_data, Deleter> data_;
  std::unique_ptr<pcre2_match_context, Deleter> context_;
};

namespace {

// Reads the number of a group from the digits at *at, as many of them as there
// are groups for, and leaves *at on the last one.
int ReadGroupNumber(const std::string& text, int groups, std::size_t* at) {
  int number = text[*at] - '0';
  while (*at + 1 < text.size() && absl::ascii_isdigit(text[*at + 1])) {
    const int longer = 10 * number + (text[*at + 1] - '0');
    if (longer > groups) break;
    number = longer;
    ++*at;
  }
  return number;
}

// Appends `replacement` with its groups filled in; false if it is malformed.
// https://www.w3.org/TR/xpath-functions/#func-replace
bool AppendReplacement(const CompiledRegex& regex, int groups,
                       const std::string& text, const std::string& replacement,
                       std::string* out) {
  for (std::size_t i = 0; i < replacement.size(); ++i) {
    const char c = replacement[i];
    if (c != '$' && c != '\\') {
      out->push_back(c);
      continue;
    }
    if (++i == replacement.size()) return false;
    const char next = replacement[i];
    if (c == '\\') {
      if (next != '\\' && next != '$') return false;
      out->push_back(next);
      continue;
    }
    if (!absl::ascii_isdigit(next)) return false;
    const int number = ReadGroupNumber(replacement, regex.CountGroups(), &i);
    // A group that the pattern does not have, or that took no part, is empty.
    if (number >= groups) continue;
    const auto [begin, end] = regex.Group(number);
    if (begin != PCRE2_UNSET) out->append(text, begin, end - begin);
  }
  return true;
}

}  // namespace

RegexCache::RegexCache() = default;
RegexCache::~RegexCache() = default;

const CompiledRegex* RegexCache::Compile(const std::string& pattern,
                                         const std::string& flags) {
  const std::string key = flags + "/" + pattern;
  const auto found = compiled_.find(key);
  if (found != compiled_.end()) return found->second.get();
  std::unique_ptr<CompiledRegex> regex;
  const std::optional<std::uint32_t> options = ParseOptions(flags);
  if (options && pattern.size() <= kPatternLimit_bytes) {
    const std::optional<std::string> translated = Translate(pattern, flags);
    if (translated) {
      regex = std::make_unique<CompiledRegex>(*translated, *options);
    }
    if (regex != nullptr && !regex->ok()) regex.reset();
  }
  if (compiled_.size() >= 1000) compiled_.clear();
  return compiled_.emplace(key, std::move(regex)).first->second.get();
}

std::optional<bool> RegexCache::Matches(const std::string& text,
                                        const std::string& pattern,
                                        const std::string& flags) {
  const CompiledRegex* regex = Compile(pattern, flags);
  if (regex == nullptr) return std::nullopt;
  return regex->Match(text, 0) > 0;
}

std::optional<std::string> RegexCache::Replace(const std::string& text,
                                               const std::string& pattern,
                                               const std::string& replacement,
                                               const std::string& flags) {
  const CompiledRegex* regex = Compile(pattern, flags);
  if (regex == nullptr || regex->Match("", 0) > 0) return std::nullopt;
  std::string out;
  std::size_t at = 0;
  while (const int groups = regex->Match(text, at)) {
    const auto [begin, end] = regex->Group(0);
    if (end <= begin) return std::nullopt;
    out.append(text, at, begin - at);
    if (Has(flags, 'q')) {
      out += replacement;
    } else if (!AppendReplacement(*regex, groups, text, replacement, &out)) {
      return std::nullopt;
    }
    if (out.size() > kReplacedLimit_bytes) return std::nullopt;
    at = end;
  }
  return out.append(text, at);
}

}  // namespace kg_base
