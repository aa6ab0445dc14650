#include "kg_base/text/regex.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>

#include "kg_base/text/xpath_pattern.h"

namespace kg_base {
namespace {

// Does all of `text` match? 'e' for an invalid pattern.
char GetMatch(const std::string& text, const std::string& pattern,
              const std::string& flags = "") {
  RegexCache cache;
  const auto matches = cache.Matches(text, "^(?:" + pattern + ")$", flags);
  return !matches ? 'e' : *matches ? 'y' : 'n';
}

std::string Replace(const std::string& text, const std::string& pattern,
                    const std::string& replacement) {
  RegexCache cache;
  return cache.Replace(text, pattern, replacement, "").value_or("error");
}

TEST(Regex, ClassEscapesAreThoseOfXPath) {
  const std::tuple<const char*, const char*, char> kCases[] = {
      {"\\w", "\u00E9", 'y'},    {"\\w", "\u4E2D", 'y'},
      {"\\w", "_", 'n'},         {"\\w", "-", 'n'},
      {"\\w", "$", 'y'},         {"\\w", "\u0301", 'y'},
      {"\\w", " ", 'n'},         {"\\W", "_", 'y'},
      {"\\W", "\u00E9", 'n'},    {"\\d", "\u0663", 'y'},
      {"\\d", "\uFF13", 'y'},    {"\\d", "\u2167", 'n'},
      {"\\D", "\u0663", 'n'},    {"\\D", "a", 'y'},
      {"\\s", "\t", 'y'},        {"\\s", "\u00A0", 'n'},
      {"\\s", "\f", 'n'},        {"\\S", "\u00A0", 'y'},
      {"\\S", "\n", 'n'},        {"\\i", "\u00E9", 'y'},
      {"\\i", ":", 'y'},         {"\\i", "1", 'n'},
      {"\\I", "1", 'y'},         {"\\c", "1", 'y'},
      {"\\c", "\u00B7", 'y'},    {"\\c", " ", 'n'},
      {"\\C", " ", 'y'},         {"\\i\\c*", "a-1.b", 'y'},
      {"[\\w.]", "\u00E9", 'y'}, {"[^\\w]", "\u00E9", 'n'},
      {"[^\\W]", "\u00E9", 'y'}, {"[\\D1]", "1", 'y'},
      {"[\\D1]", "2", 'n'},      {"[\\I\\d]", "a", 'n'},
  };
  for (const auto& [pattern, text, expected] : kCases) {
    EXPECT_EQ(GetMatch(text, pattern), expected) << pattern << " " << text;
  }
}

TEST(Regex, KnowsCategoriesAndBlocks) {
  const std::tuple<const char*, const char*, char> kCases[] = {
      {"\\p{Lu}", "\u00C9", 'y'},
      {"\\p{Lu}", "\u00E9", 'n'},
      {"\\P{L}", "1", 'y'},
      {"\\p{IsBasicLatin}", "a", 'y'},
      {"\\p{IsBasicLatin}", "\u00E9", 'n'},
      {"\\P{IsBasicLatin}", "\u00E9", 'y'},
      {"\\p{IsLatin-1Supplement}", "\u00E9", 'y'},
      {"\\p{IsCyrillic}", "\u0436", 'y'},
      {"\\p{IsGreek}", "\u03B1", 'y'},
      {"\\p{IsCombiningMarksforSymbols}", "\u20D0", 'y'},
      {"\\p{IsPrivateUse}", "\uE000", 'y'},
      {"\\P{IsHangulJamoExtended-B}", "\uE000", 'y'},
      {"[\\p{IsGreek}\\p{Nd}]+", "\u03B15", 'y'},
      {"[^\\P{IsGreek}]", "\u03B1", 'y'},
      {"\\p{IsNowhere}", "a", 'e'},
      {"\\p{Is}", "a", 'e'},
      {"\\p{Greek}", "\u03B1", 'e'},
      {"\\p{Cs}", "a", 'e'},
      {"\\pL", "a", 'e'},
      {"\\p{L", "a", 'e'},
  };
  for (const auto& [pattern, text, expected] : kCases) {
    EXPECT_EQ(GetMatch(text, pattern), expected) << pattern << " " << text;
  }
}

TEST(Regex, SubtractsClasses) {
  const std::tuple<const char*, const char*, char> kCases[] = {
      {"[a-z-[aeiou]]", "b", 'y'},
      {"[a-z-[aeiou]]", "e", 'n'},
      {"[a-z-[aeiou]]+", "bcd", 'y'},
      {"[a-z-[^aeiou]]", "e", 'y'},
      {"[^a-z-[0-9]]", "A", 'y'},
      {"[^a-z-[0-9]]", "5", 'n'},
      {"[\\w-[\\d]]", "\u0663", 'n'},
      {"[\\w-[\\d]]", "\u00E9", 'y'},
      {"[a-z-[b-y-[m]]]", "m", 'y'},
      {"[a-z-[b-y-[m]]]", "n", 'n'},
      {"[\\p{L}-[\\p{IsBasicLatin}]]", "a", 'n'},
      {"[a-]", "-", 'y'},
      {"[-a]", "-", 'y'},
      {"[a\\-z]", "b", 'n'},
      {"[a^]", "^", 'y'},
      {"[.$]", ".", 'y'},
      {"[.$]", "a", 'n'},
      {"[a-z-[aeiou]", "b", 'e'},
      {"[a-z-[]]", "b", 'e'},
      {"[z-a]", "b", 'e'},
      {"[]", "b", 'e'},
      {"[[a]]", "a", 'e'},
  };
  for (const auto& [pattern, text, expected] : kCases) {
    EXPECT_EQ(GetMatch(text, pattern), expected) << pattern << " " << text;
  }
  EXPECT_EQ(GetMatch("I", "[A-Z-[IO]]", "i"), 'n');
  EXPECT_EQ(GetMatch("o", "[A-Z-[IO]]", "i"), 'n');
  EXPECT_EQ(GetMatch("b", "[A-Z-[IO]]", "i"), 'y');
}

TEST(Regex, RefusesWhatOnlyPcreKnows) {
  for (const char* pattern :
       {"\\bx",  "\\Bx",  "\\Ax",    "x\\z",    "\\Qx\\E", "\\h",
        "\\x41", "\\N",   "x++",     "x*+",     "x{1}+",   "x**",
        "(?=x)", "(?i)x", "(?<n>x)", "(*ANY)x", "x{,2}",   "x{",
        "}",     "]",     "*x",      "^*",      "(?#x)",   "\\",
        "(x",    "x)",    "\\1",     "(x\\1)",  "x{2,1}",  "[[:alpha:]]",
        "\\0",   "\\_"}) {
    EXPECT_EQ(GetMatch("x", pattern), 'e') << pattern;
  }
}

TEST(Regex, ReadsXPathsOwnSyntax) {
  const std::tuple<const char*, const char*, char> kCases[] = {
      {"a|", "", 'y'},
      {"()a", "a", 'y'},
      {"(?:ab){2}", "abab", 'y'},
      {"a{2,}?", "aaa", 'y'},
      {"a{0}b", "b", 'y'},
      {"(a)\\1", "aa", 'y'},
      {"(a)|b\\1", "b", 'y'},
      {"\\$\\^\\.\\-", "$^.-", 'y'},
      {"#a b/", "#a b/", 'y'},
      {"\u00E9+", "\u00E9\u00E9", 'y'},
      {"(a)(b)(c)(d)(e)(f)(g)(h)(i)(j)\\10", "abcdefghijj", 'y'},
      {"(a)\\10", "aa0", 'y'},
      {"a.c", "a\nc", 'n'},
  };
  for (const auto& [pattern, text, expected] : kCases) {
    EXPECT_EQ(GetMatch(text, pattern), expected) << pattern << " " << text;
  }
  EXPECT_EQ(GetMatch("ac", "a c", "x"), 'y');
  EXPECT_EQ(GetMatch("a c", "a[ ]c", "x"), 'y');
  EXPECT_EQ(GetMatch("\u00C9", "\u00E9", "i"), 'y');
}

TEST(Regex, LongTextsOfANegatedClassStayWithinTheLimit) {
  EXPECT_EQ(GetMatch(std::string(900000, 'a'), "[^#]*"), 'y');
}

TEST(Regex, ReplacesByAsManyDigitsAsThereAreGroups) {
  const char* ten = "(a)(b)(c)(d)(e)(f)(g)(h)(i)(j)";
  EXPECT_EQ(Replace("abcdefghijk", ten, "[$10]"), "[j]k");
  EXPECT_EQ(Replace("abcdefghijk", ten, "[$100]"), "[j0]k");
  EXPECT_EQ(Replace("abcdefghijk", ten, "[$11]"), "[a1]k");
  EXPECT_EQ(Replace("ab", "(a)", "[$10]"), "[a0]b");
  EXPECT_EQ(Replace("ab", "(a)", "[$2]"), "[]b");
  EXPECT_EQ(Replace("ab", "(a)", "[$0]"), "[a]b");
  EXPECT_EQ(Replace("ab", "(a)", "[$01]"), "[a]b");
  EXPECT_EQ(Replace("b", "(a)|b", "[$1]"), "[]");
  EXPECT_EQ(Replace("ab", "a", "\\$1"), "$1b");
  EXPECT_EQ(Replace("ab", "a", "$"), "error");
  EXPECT_EQ(Replace("na\u00EFve caf\u00E9", "\\w+", "x"), "x x");
}

// https://www.w3.org/TR/xpath-functions/#func-replace
TEST(Regex, ReplacesByTheTextAsItIsWithFlagQ) {
  RegexCache cache;
  EXPECT_EQ(cache.Replace("a.c", ".", "$0\\", "q"), "a$0\\c");
  EXPECT_EQ(cache.Replace("A.C", "a.c", "$1", "qi"), "$1");
  EXPECT_EQ(cache.Replace("a.c", "\\.", "$1", ""), "ac");
}

TEST(XPathPattern, DeepNestingIsRefused) {
  std::string deep;
  for (int i = 0; i < 2000; ++i) deep += "[a-";
  EXPECT_EQ(ToPcrePattern(deep), std::nullopt);
}

}  // namespace
}  // namespace kg_base
