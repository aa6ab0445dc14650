// The serd-based parser behind the read functions of syntax.h and turtle.h.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_base/text/iri.h"
#include "kg_base/text/utf8.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/syntax.h"
#include "kg_core/rdf/term_check.h"
#include "kg_core/rdf/turtle_check.h"
#include "serd/serd.h"

namespace kg_core {
namespace {

using kg_base::InputError;

std::string Hex16(std::uint64_t value) {
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx",
                static_cast<unsigned long long>(value));
  return digits;
}

// A prefix for the blank node labels of one parse: the time (never the same
// twice in a process, so labels sort in the order of the parses) and a random
// number that distinguishes processes.
std::string FreshBlankPrefix() {
  static const std::uint64_t process = [] {
    std::random_device device;
    return (std::uint64_t{device()} << 32) | device();
  }();
  static std::atomic<std::uint64_t> last{0};
  const std::uint64_t now =
      std::chrono::system_clock::now().time_since_epoch().count();
  std::uint64_t before = last.load();
  while (!last.compare_exchange_weak(before, std::max(before + 1, now))) {
  }
  return "b" + Hex16(std::max(before + 1, now)) + Hex16(process);
}

std::string_view GetText(const SerdNode& node) {
  return {reinterpret_cast<const char*>(node.buf), node.n_bytes};
}

SerdSyntax ToSerdSyntax(RdfSyntax syntax) {
  switch (syntax) {
    case RdfSyntax::kTurtle:
      return SERD_TURTLE;
    case RdfSyntax::kTriG:
      return SERD_TRIG;
    case RdfSyntax::kNTriples:
      return SERD_NTRIPLES;
    case RdfSyntax::kNQuads:
      return SERD_NQUADS;
  }
  return SERD_TURTLE;
}

// State of one parse, with the callbacks for serd. No exception may cross serd
// (it is C), so it is stored and rethrown after serd returns.
class SerdParse {
 public:
  SerdParse(std::string_view text, const RdfSource& source,
            std::vector<InsertedByte> inserted)
      : text_(text),
        source_(source),
        inserted_(std::move(inserted)),
        blank_prefix_(FreshBlankPrefix()),
        base_(source.base) {
    for (const NamespacePrefix& prefix : kPrefixes) {
      prefixes_[prefix.name] = prefix.iri;
    }
  }

  std::vector<Statement> Run(RdfSyntax syntax) {
    const std::unique_ptr<SerdReader, void (*)(SerdReader*)> reader(
        serd_reader_new(ToSerdSyntax(syntax), this, nullptr, OnBase, OnPrefix,
                        OnStatement, nullptr),
        serd_reader_free);
    serd_reader_set_strict(reader.get(), true);
    serd_reader_set_error_sink(reader.get(), OnError, this);
    const SerdStatus status = serd_reader_read_source(
        reader.get(), NextByte, NoStreamError, this, nullptr, 1);
    if (failure_) std::rethrow_exception(failure_);
    if (!syntax_error_.empty()) throw InputError(syntax_error_);
    if (status > SERD_FAILURE || at_ < text_.size()) {
      throw InputError(Here() + "expected the end of the text or a statement");
    }
    return std::move(statements_);
  }

 private:
  // serd reads byte by byte, so that `at_` is the position of an error.
  static std::size_t NextByte(void* buffer, std::size_t, std::size_t,
                              void* handle) {
    auto& parse = *static_cast<SerdParse*>(handle);
    auto& byte = *static_cast<char*>(buffer);
    if (parse.next_inserted_ < parse.inserted_.size() &&
        parse.inserted_[parse.next_inserted_].offset == parse.at_) {
      byte = parse.inserted_[parse.next_inserted_++].byte;
      return 1;
    }
    if (parse.at_ == parse.text_.size()) return 0;
    byte = parse.text_[parse.at_++];
    return 1;
  }

  static int NoStreamError(void*) { return 0; }

  static SerdStatus OnError(void* handle, const SerdError* error) {
    auto& parse = *static_cast<SerdParse*>(handle);
    char what[256];
    std::vsnprintf(what, sizeof(what), error->fmt, *error->args);
    if (!parse.syntax_error_.empty()) return SERD_SUCCESS;
    const std::size_t place = parse.at_ == 0 ? 0 : parse.at_ - 1;
    parse.syntax_error_ =
        parse.FormatPosition(place) +
        parse.CompleteCharacter(std::string(kg_base::StripAsciiSpace(what)),
                                place);
    std::replace(parse.syntax_error_.begin(), parse.syntax_error_.end(), '\n',
                 ' ');
    return SERD_SUCCESS;
  }

  static SerdStatus OnBase(void* handle, const SerdNode* uri) {
    auto& parse = *static_cast<SerdParse*>(handle);
    return parse.Attempt([&] { parse.base_ = parse.Resolve(*uri); });
  }

  static SerdStatus OnPrefix(void* handle, const SerdNode* name,
                             const SerdNode* uri) {
    auto& parse = *static_cast<SerdParse*>(handle);
    return parse.Attempt([&] {
      parse.prefixes_[std::string(GetText(*name))] = parse.Resolve(*uri);
    });
  }

  static SerdStatus OnStatement(void* handle, SerdStatementFlags,
                                const SerdNode* graph, const SerdNode* subject,
                                const SerdNode* predicate,
                                const SerdNode* object,
                                const SerdNode* datatype,
                                const SerdNode* language) {
    auto& parse = *static_cast<SerdParse*>(handle);
    return parse.Attempt([&] {
      parse.statements_.push_back(
          {parse.MakeTerm(*subject), parse.MakeTerm(*predicate),
           parse.MakeObject(*object, datatype, language),
           parse.GetGraph(graph)});
    });
  }

  template <typename Action>
  SerdStatus Attempt(Action action) {
    try {
      action();
      return SERD_SUCCESS;
    } catch (...) {
      failure_ = std::current_exception();
      return SERD_ERR_INTERNAL;
    }
  }

  Term MakeObject(const SerdNode& node, const SerdNode* datatype,
                  const SerdNode* language) {
    if (node.type != SERD_LITERAL) return MakeTerm(node);
    if (language != nullptr && language->buf != nullptr) {
      return CheckLiteral(LanguageLiteral(std::string(GetText(node)),
                                          std::string(GetText(*language))));
    }
    if (datatype == nullptr || datatype->buf == nullptr) {
      return CheckLiteral(Literal(std::string(GetText(node))));
    }
    return CheckLiteral(
        Literal(std::string(GetText(node)), MakeTerm(*datatype).text));
  }

  Term GetGraph(const SerdNode* node) {
    const bool is_named = node != nullptr && node->buf != nullptr;
    return is_named ? MakeTerm(*node) : source_.default_graph;
  }

  Term MakeTerm(const SerdNode& node) {
    if (node.type == SERD_BLANK) return InternBlank(GetText(node));
    if (node.type == SERD_CURIE) return Iri(CheckAbsolute(ExpandCurie(node)));
    return Iri(CheckAbsolute(Resolve(node)));
  }

  Term InternBlank(std::string_view label) {
    const auto number =
        blanks_.try_emplace(std::string(label), blanks_.size()).first->second;
    char digits[24];
    std::snprintf(digits, sizeof(digits), "x%06zu", number);
    return Blank(blank_prefix_ + digits);
  }

  std::string ExpandCurie(const SerdNode& node) {
    const std::string_view curie = GetText(node);
    const std::size_t colon = std::min(curie.find(':'), curie.size());
    const auto prefix = prefixes_.find(curie.substr(0, colon));
    if (prefix == prefixes_.end() || colon == curie.size()) RefusePrefix(curie);
    return prefix->second + std::string(curie.substr(colon + 1));
  }

  [[noreturn]] void RefusePrefix(std::string_view curie) const {
    const std::string name(curie.substr(0, curie.find(':') + 1));
    const std::size_t found = text_.rfind(name, at_);
    const std::size_t place = found == std::string_view::npos ? at_ : found;
    throw InputError(FormatPosition(place) + "unknown prefix '" + name +
                     "'; expected one declared with @prefix, or one of ours");
  }

  // Absolute IRIs are kept as written. serd undoes escapes, which may stand for
  // what no IRI may hold.
  std::string Resolve(const SerdNode& node) const {
    const auto fault = FindIriFault(GetText(node));
    if (fault) RefuseTerm(*fault);
    return kg_base::ResolveIri(base_, GetText(node));
  }

  // At the last byte read, which in N-Quads ends the line.
  [[noreturn]] void RefuseTerm(const std::string& fault) const {
    throw InputError(FormatPosition(at_ == 0 ? 0 : at_ - 1) + fault);
  }

  // Relative IRIs need a base.
  std::string CheckAbsolute(std::string iri) const {
    if (kg_base::IsAbsoluteIri(iri)) return iri;
    throw InputError(Here() + "relative IRI <" + iri +
                     ">; expected an absolute IRI or an @base before it");
  }

  Term CheckLiteral(Term term) const {
    if (const auto fault = FindTermFault(term)) RefuseTerm(*fault);
    return term;
  }

  // serd reports the byte at `place`; its whole character replaces it.
  std::string CompleteCharacter(std::string message, std::size_t place) const {
    const std::optional<std::size_t> bad = kg_base::FirstBadUtf8(message);
    if (!bad || text_.empty()) return message;
    std::size_t begin = place;
    while (begin > 0 && (text_[begin] & 0xC0) == 0x80) --begin;
    std::size_t end = begin;
    kg_base::TakeUtf8(text_, &end);
    return message.replace(*bad, 1, text_.substr(begin, end - begin));
  }

  std::string FormatPosition(std::size_t offset) const {
    return TurtleErrorPlace(text_, source_.name, offset);
  }
  std::string Here() const { return FormatPosition(at_); }

  const std::string_view text_;
  const RdfSource& source_;
  const std::vector<InsertedByte> inserted_;
  const std::string blank_prefix_;
  std::string base_;
  std::map<std::string, std::string, std::less<>> prefixes_;
  std::map<std::string, std::size_t> blanks_;
  std::vector<Statement> statements_;
  std::size_t at_ = 0;
  std::size_t next_inserted_ = 0;
  std::string syntax_error_;
  std::exception_ptr failure_;
};

}  // namespace

std::vector<Statement> ParseRdf(std::string_view text, RdfSyntax syntax,
                                const RdfSource& source,
                                const TurtleLimits& limits) {
  return SerdParse(text, source,
                   CheckRdfText(text, syntax, source.name, limits))
      .Run(syntax);
}

std::vector<Statement> ParseTurtle(std::string_view text,
                                   const std::string& source, const Term& graph,
                                   const TurtleLimits& limits) {
  return ParseRdf(text, RdfSyntax::kTurtle, {source, graph}, limits);
}

std::vector<Statement> ParseTurtleFile(const std::string& path,
                                       const Term& graph,
                                       const TurtleLimits& limits) {
  return ParseTurtle(kg_base::ReadFile(path, limits.bytes), path, graph,
                     limits);
}

}  // namespace kg_core
