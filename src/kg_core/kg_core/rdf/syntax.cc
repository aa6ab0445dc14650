#include "kg_core/rdf/syntax.h"

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"

namespace kg_core {
namespace {

template <typename Fits>
const RdfSyntaxName* FindSyntax(Fits fits) {
  for (const RdfSyntaxName& syntax : RdfSyntaxes()) {
    if (fits(syntax)) return &syntax;
  }
  return nullptr;
}

bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() &&
         text.substr(text.size() - end.size()) == end;
}

}  // namespace

const std::vector<RdfSyntaxName>& RdfSyntaxes() {
  static const std::vector<RdfSyntaxName> syntaxes = {
      {RdfSyntax::kTurtle, "turtle", ".ttl", false},
      {RdfSyntax::kTriG, "trig", ".trig", true},
      {RdfSyntax::kNTriples, "ntriples", ".nt", false},
      {RdfSyntax::kNQuads, "nquads", ".nq", true},
  };
  return syntaxes;
}

const RdfSyntaxName* SyntaxNamed(std::string_view name) {
  return FindSyntax([&](const RdfSyntaxName& s) { return name == s.name; });
}

const RdfSyntaxName* SyntaxOfPath(std::string_view path) {
  const std::string lower = kg_base::ToLowerAscii(path);
  return FindSyntax(
      [&](const RdfSyntaxName& s) { return EndsWith(lower, s.suffix); });
}

std::vector<Statement> ParseRdfFile(const std::string& path,
                                    const Term& default_graph,
                                    const TurtleLimits& limits) {
  const RdfSyntaxName* syntax = SyntaxOfPath(path);
  if (syntax == nullptr) {
    throw kg_base::InputError(
        path + ": expected a file whose name ends in .ttl, .trig, " +
        ".nt or .nq");
  }
  return ParseRdf(kg_base::ReadFile(path, limits.bytes), syntax->syntax,
                  {path, default_graph}, limits);
}

}  // namespace kg_core
