#include "kg_core/sparql/functions.h"

#include <cctype>

#include "kg_base/text/iri.h"
#include "kg_core/rdf/term_check.h"
#include "kg_core/sparql/fresh_blank.h"
#include "kg_core/sparql/values.h"

namespace kg_core::sparql {
namespace {

// https://www.w3.org/TR/sparql11-query/#func-str
Answer Str(FunctionContext&, const Arguments& a) {
  if (a[0]->is_blank()) return std::nullopt;
  return Literal(a[0]->text);
}

Answer Lang(FunctionContext&, const Arguments& a) {
  if (!a[0]->is_literal()) return std::nullopt;
  return Literal(a[0]->language);
}

Answer Datatype(FunctionContext&, const Arguments& a) {
  if (!a[0]->is_literal()) return std::nullopt;
  return Iri(a[0]->datatype);
}

Answer IsIriTerm(FunctionContext&, const Arguments& a) {
  return BooleanLiteral(a[0]->is_iri());
}

Answer IsBlankTerm(FunctionContext&, const Arguments& a) {
  return BooleanLiteral(a[0]->is_blank());
}

Answer IsLiteralTerm(FunctionContext&, const Arguments& a) {
  return BooleanLiteral(a[0]->is_literal());
}

Answer IsNumericTerm(FunctionContext&, const Arguments& a) {
  return BooleanLiteral(NumericValue(*a[0]).has_value());
}

// A term that is not RDF is an error.
Answer IfValid(Term term) {
  if (FindTermFault(term)) return std::nullopt;
  return term;
}

// https://www.w3.org/TR/sparql11-query/#func-iri
Answer MakeIri(FunctionContext& context, const Arguments& a) {
  if (a[0]->is_iri()) return *a[0];
  if (!IsString(*a[0])) return std::nullopt;
  return IfValid(Iri(kg_base::ResolveIri(context.base, a[0]->text)));
}

// https://www.w3.org/TR/sparql11-query/#func-bnode
Answer MakeBlank(FunctionContext& context, const Arguments& a) {
  if (a.empty()) return FreshBlank();
  if (!IsString(*a[0])) return std::nullopt;
  const auto known = context.blanks_of_row.find(a[0]->text);
  if (known != context.blanks_of_row.end()) return known->second;
  return context.blanks_of_row.emplace(a[0]->text, FreshBlank()).first->second;
}

Answer StrDt(FunctionContext&, const Arguments& a) {
  if (!IsString(*a[0]) || !a[1]->is_iri()) return std::nullopt;
  return IfValid(Literal(a[0]->text, a[1]->text));
}

Answer StrLang(FunctionContext&, const Arguments& a) {
  if (!IsString(*a[0]) || !IsString(*a[1])) return std::nullopt;
  return IfValid(LanguageLiteral(a[0]->text, a[1]->text));
}

std::string RandomUuid(FunctionContext& context) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string uuid;
  for (int i = 0; i < 32; ++i) {
    if (i == 8 || i == 12 || i == 16 || i == 20) uuid.push_back('-');
    unsigned digit = static_cast<unsigned>(context.random() & 15u);
    if (i == 12) digit = 4;                 // UUID version 4.
    if (i == 16) digit = 8 | (digit & 3u);  // Variant of RFC 4122.
    uuid.push_back(kHex[digit]);
  }
  return uuid;
}

Answer Uuid(FunctionContext& context, const Arguments&) {
  return Iri("urn:uuid:" + RandomUuid(context));
}

Answer StrUuid(FunctionContext& context, const Arguments&) {
  return Literal(RandomUuid(context));
}

using Table = absl::flat_hash_map<std::string, SparqlFunction>;

Table AllFunctions() {
  Table table;
  for (const auto& functions :
       {TermFunctions(), StringFunctions(), NumberFunctions(), TimeFunctions(),
        HashFunctions(), CastFunctions(), GeoFunctions()}) {
    for (const SparqlFunction& function : functions) {
      table.emplace(function.name, function);
    }
  }
  return table;
}

const SparqlFunction* FindIn(const std::string& name) {
  static const Table* const table = new Table(AllFunctions());
  const auto found = table->find(name);
  return found == table->end() ? nullptr : &found->second;
}

}  // namespace

std::vector<SparqlFunction> TermFunctions() {
  return {{"STR", 1, 1, Str},
          {"LANG", 1, 1, Lang},
          {"DATATYPE", 1, 1, Datatype},
          {"ISIRI", 1, 1, IsIriTerm},
          {"ISURI", 1, 1, IsIriTerm},
          {"ISBLANK", 1, 1, IsBlankTerm},
          {"ISLITERAL", 1, 1, IsLiteralTerm},
          {"ISNUMERIC", 1, 1, IsNumericTerm},
          {"IRI", 1, 1, MakeIri},
          {"URI", 1, 1, MakeIri},
          {"BNODE", 0, 1, MakeBlank},
          {"STRDT", 2, 2, StrDt},
          {"STRLANG", 2, 2, StrLang},
          {"UUID", 0, 0, Uuid},
          {"STRUUID", 0, 0, StrUuid}};
}

const SparqlFunction* FindKeywordFunction(std::string_view name) {
  std::string upper(name);
  for (char& c : upper) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return FindIn(upper);
}

const SparqlFunction* FindIriFunction(std::string_view iri) {
  return FindIn(std::string(iri));
}

}  // namespace kg_core::sparql
