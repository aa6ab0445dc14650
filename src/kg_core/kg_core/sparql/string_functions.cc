// Functions on strings. https://www.w3.org/TR/sparql11-query/#func-strings

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_base/text/utf8.h"
#include "kg_core/sparql/functions.h"
#include "kg_core/sparql/values.h"

namespace kg_core::sparql {
namespace {

constexpr std::size_t kTextLimit_bytes = 1u << 20;

// `text` as a literal with the datatype or language of `like`.
Term Like(const Term& like, std::string text) {
  if (like.language.empty()) return Literal(std::move(text));
  return LanguageLiteral(std::move(text), like.language);
}

// https://www.w3.org/TR/sparql11-query/#func-arg-compatibility
bool Compatible(const Arguments& a) {
  return IsStringLike(*a[0]) && IsStringLike(*a[1]) &&
         (a[1]->language.empty() || a[0]->language == a[1]->language);
}

Answer StrLen(FunctionContext&, const Arguments& a) {
  if (!IsStringLike(*a[0])) return std::nullopt;
  return IntegerLiteral(
      static_cast<long long>(kg_base::Utf8Length(a[0]->text)));
}

// Positions count from 1 and are rounded; NaN selects nothing.
// https://www.w3.org/TR/xpath-functions/#func-substring
Answer SubStr(FunctionContext&, const Arguments& a) {
  const std::optional<XsdNumber> start = ToNumber(*a[1]);
  if (!IsStringLike(*a[0]) || !start) return std::nullopt;
  const auto size = static_cast<double>(kg_base::Utf8Length(a[0]->text));
  // Positions count from 1 and are rounded, as fn:substring does; NaN gives "".
  const double first = RoundHalfUp(start->ToDouble());
  double end = size + 1;
  if (a.size() == 3) {
    const std::optional<XsdNumber> length = ToNumber(*a[2]);
    if (!length) return std::nullopt;
    end = first + RoundHalfUp(length->ToDouble());
  }
  const double from = std::max(first, 1.0);
  const double to = std::min(end, size + 1);
  if (!(first <= size) || !(from < to)) return Like(*a[0], "");
  const std::string& text = a[0]->text;
  const std::size_t begin_at =
      kg_base::Utf8Offset(text, static_cast<std::size_t>(from) - 1);
  const std::size_t end_at =
      kg_base::Utf8Offset(text, static_cast<std::size_t>(to) - 1);
  return Like(*a[0], text.substr(begin_at, end_at - begin_at));
}

Answer UCase(FunctionContext&, const Arguments& a) {
  if (!IsStringLike(*a[0])) return std::nullopt;
  return Like(*a[0], kg_base::UpperCase(a[0]->text));
}

Answer LCase(FunctionContext&, const Arguments& a) {
  if (!IsStringLike(*a[0])) return std::nullopt;
  return Like(*a[0], kg_base::LowerCase(a[0]->text));
}

Answer StrStarts(FunctionContext&, const Arguments& a) {
  if (!Compatible(a)) return std::nullopt;
  return BooleanLiteral(a[0]->text.rfind(a[1]->text, 0) == 0);
}

Answer StrEnds(FunctionContext&, const Arguments& a) {
  if (!Compatible(a)) return std::nullopt;
  const std::string& text = a[0]->text;
  const std::string& end = a[1]->text;
  return BooleanLiteral(
      text.size() >= end.size() &&
      text.compare(text.size() - end.size(), end.size(), end) == 0);
}

Answer Contains(FunctionContext&, const Arguments& a) {
  if (!Compatible(a)) return std::nullopt;
  return BooleanLiteral(a[0]->text.find(a[1]->text) != std::string::npos);
}

Answer StrBefore(FunctionContext&, const Arguments& a) {
  if (!Compatible(a)) return std::nullopt;
  const std::size_t at = a[0]->text.find(a[1]->text);
  if (at == std::string::npos) return Literal("");
  return Like(*a[0], a[0]->text.substr(0, at));
}

Answer StrAfter(FunctionContext&, const Arguments& a) {
  if (!Compatible(a)) return std::nullopt;
  const std::size_t at = a[0]->text.find(a[1]->text);
  if (at == std::string::npos) return Literal("");
  return Like(*a[0], a[0]->text.substr(at + a[1]->text.size()));
}

Answer EncodeForUri(FunctionContext&, const Arguments& a) {
  if (!IsStringLike(*a[0])) return std::nullopt;
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~";
  std::string out;
  for (const char c : a[0]->text) {
    if (kPlain.find(c) != std::string_view::npos) {
      out.push_back(c);
      continue;
    }
    char code[8];
    std::snprintf(code, sizeof code, "%%%02X",
                  static_cast<unsigned>(static_cast<unsigned char>(c)));
    out += code;
  }
  return Literal(out);
}

// CONCAT keeps the language tag if all arguments share it.
// https://www.w3.org/TR/sparql11-query/#func-concat
Answer Concat(FunctionContext&, const Arguments& a) {
  std::string text;
  for (const Term* part : a) {
    if (!IsStringLike(*part)) return std::nullopt;
    text += part->text;
    if (text.size() > kTextLimit_bytes) {
      throw kg_base::InputError(
          "CONCAT made a text of more than the limit of " +
          std::to_string(kTextLimit_bytes) + " bytes");
    }
  }
  const bool same =
      !a.empty() && std::all_of(a.begin(), a.end(), [&a](const Term* part) {
        return part->language == a[0]->language;
      });
  return same ? Like(*a[0], text) : Literal(text);
}

// https://www.w3.org/TR/sparql11-query/#func-langMatches (basic filtering)
Answer LangMatches(FunctionContext&, const Arguments& a) {
  if (!IsString(*a[0]) || !IsString(*a[1])) return std::nullopt;
  const std::string tag = kg_base::LowerCase(a[0]->text);
  const std::string range = kg_base::LowerCase(a[1]->text);
  if (range == "*") return BooleanLiteral(!tag.empty());
  return BooleanLiteral(tag == range || tag.rfind(range + "-", 0) == 0);
}

std::string GetFlags(const Arguments& a, std::size_t index) {
  return a.size() > index ? a[index]->text : std::string();
}

// https://www.w3.org/TR/sparql11-query/#func-regex
Answer RegexTest(FunctionContext& context, const Arguments& a) {
  if (!IsStringLike(*a[0]) || !IsString(*a[1])) return std::nullopt;
  if (a.size() == 3 && !IsString(*a[2])) return std::nullopt;
  const std::optional<bool> matches =
      context.regexes.Matches(a[0]->text, a[1]->text, GetFlags(a, 2));
  if (!matches) return std::nullopt;
  return BooleanLiteral(*matches);
}

// https://www.w3.org/TR/sparql11-query/#func-replace
Answer ReplaceAll(FunctionContext& context, const Arguments& a) {
  if (!IsStringLike(*a[0]) || !IsString(*a[1]) || !IsString(*a[2])) {
    return std::nullopt;
  }
  if (a.size() == 4 && !IsString(*a[3])) return std::nullopt;
  std::optional<std::string> text = context.regexes.Replace(
      a[0]->text, a[1]->text, a[2]->text, GetFlags(a, 3));
  if (!text) return std::nullopt;
  return Like(*a[0], std::move(*text));
}

}  // namespace

std::vector<SparqlFunction> StringFunctions() {
  return {{"STRLEN", 1, 1, StrLen},
          {"SUBSTR", 2, 3, SubStr},
          {"UCASE", 1, 1, UCase},
          {"LCASE", 1, 1, LCase},
          {"STRSTARTS", 2, 2, StrStarts},
          {"STRENDS", 2, 2, StrEnds},
          {"CONTAINS", 2, 2, Contains},
          {"STRBEFORE", 2, 2, StrBefore},
          {"STRAFTER", 2, 2, StrAfter},
          {"ENCODE_FOR_URI", 1, 1, EncodeForUri},
          {"CONCAT", 0, kAnyNumber, Concat},
          {"LANGMATCHES", 2, 2, LangMatches},
          {"REGEX", 2, 3, RegexTest},
          {"REPLACE", 3, 4, ReplaceAll}};
}

}  // namespace kg_core::sparql
