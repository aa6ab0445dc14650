// Translation of XPath's regular expressions to those of PCRE2 with UTF.
//
// Of the escapes only \p, \n, \r, \t and those of single characters mean the
// same in both. \d, \w and \s have other members, \i, \c, blocks (\p{IsGreek})
// and class subtraction ([a-z-[aeiou]]) are unknown to PCRE2, and what only
// PCRE2 knows (\b, (?=x), a++) is an error in XPath.
//
// https://www.w3.org/TR/xpath-functions-31/#regex-syntax
// https://www.w3.org/TR/xmlschema-2/#regexs

#ifndef KG_BASE_TEXT_XPATH_PATTERN_H_
#define KG_BASE_TEXT_XPATH_PATTERN_H_

#include <optional>
#include <string>
#include <string_view>

namespace kg_base {

// `pattern` is UTF-8; nullopt if it is not a regular expression of XPath.
// Bounds of quantifiers and ranges are left to the check of PCRE2.
std::optional<std::string> ToPcrePattern(std::string_view pattern);

}  // namespace kg_base

#endif  // KG_BASE_TEXT_XPATH_PATTERN_H_
