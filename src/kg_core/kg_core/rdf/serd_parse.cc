// The serd-based parser behind the read functions of syntax.h and turtle.h.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <random>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/syntax.h"
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

bool HasScheme(std::string_view iri) {
  const std::size_t colon = iri.find(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
  };
  const bool starts_with_letter =
      (iri[0] | 0x20) >= 'a' && fits(iri[0]) && (iri[0] | 0x20) <= 'z';
  return starts_with_letter &&
         std::all_of(iri.begin(), iri.begin() + colon, fits);
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
  // `labels`: byte offsets in `text` where blank node labels begin.
  SerdParse(std::string_view text, const RdfSource& source,
            std::vector<std::size_t> labels)
      : text_(text),
        source_(source),
        labels_(std::move(labels)),
        env_(serd_env_new(nullptr), serd_env_free),
        blank_prefix_(FreshBlankPrefix()) {
    for (const NamespacePrefix& prefix : kPrefixes) {
      serd_env_set_prefix_from_strings(
          env_.get(), reinterpret_cast<const std::uint8_t*>(prefix.name),
          reinterpret_cast<const std::uint8_t*>(prefix.iri));
    }
    if (source.base.empty()) return;
    const SerdNode base = serd_node_from_string(
        SERD_URI, reinterpret_cast<const std::uint8_t*>(source.base.c_str()));
    serd_env_set_base_uri(env_.get(), &base);
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
  // serd reads byte by byte, so that `at_` is the position of an error. It
  // names nodes without a label b1, b2, ..., which would collide with _:b1 in
  // the text; so each label is passed to serd with the letter 'u' prepended.
  static std::size_t NextByte(void* buffer, std::size_t, std::size_t,
                              void* handle) {
    auto& parse = *static_cast<SerdParse*>(handle);
    auto& byte = *static_cast<char*>(buffer);
    if (parse.next_label_ < parse.labels_.size() &&
        parse.labels_[parse.next_label_] == parse.at_) {
      ++parse.next_label_;
      byte = 'u';
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
    parse.syntax_error_ = parse.FormatPosition(place);
    parse.syntax_error_ += kg_base::StripAsciiSpace(what);
    std::replace(parse.syntax_error_.begin(), parse.syntax_error_.end(), '\n',
                 ' ');
    return SERD_SUCCESS;
  }

  static SerdStatus OnBase(void* handle, const SerdNode* uri) {
    return serd_env_set_base_uri(static_cast<SerdParse*>(handle)->env_.get(),
                                 uri);
  }

  static SerdStatus OnPrefix(void* handle, const SerdNode* name,
                             const SerdNode* uri) {
    return serd_env_set_prefix(static_cast<SerdParse*>(handle)->env_.get(),
                               name, uri);
  }

  static SerdStatus OnStatement(void* handle, SerdStatementFlags,
                                const SerdNode* graph, const SerdNode* subject,
                                const SerdNode* predicate,
                                const SerdNode* object,
                                const SerdNode* datatype,
                                const SerdNode* language) {
    auto& parse = *static_cast<SerdParse*>(handle);
    try {
      parse.statements_.push_back(
          {parse.MakeTerm(*subject), parse.MakeTerm(*predicate),
           parse.MakeObject(*object, datatype, language),
           parse.GetGraph(graph)});
      return SERD_SUCCESS;
    } catch (...) {
      parse.failure_ = std::current_exception();
      return SERD_ERR_INTERNAL;
    }
  }

  Term MakeObject(const SerdNode& node, const SerdNode* datatype,
                  const SerdNode* language) {
    if (node.type != SERD_LITERAL) return MakeTerm(node);
    if (language != nullptr && language->buf != nullptr) {
      return LanguageLiteral(std::string(GetText(node)),
                             std::string(GetText(*language)));
    }
    if (datatype == nullptr || datatype->buf == nullptr) {
      return Literal(std::string(GetText(node)));
    }
    return Literal(std::string(GetText(node)), MakeTerm(*datatype).text);
  }

  Term GetGraph(const SerdNode* node) {
    const bool is_named = node != nullptr && node->buf != nullptr;
    return is_named ? MakeTerm(*node) : source_.default_graph;
  }

  Term MakeTerm(const SerdNode& node) {
    if (node.type == SERD_BLANK) return InternBlank(GetText(node));
    if (node.type == SERD_CURIE) return Iri(ExpandCurie(node));
    return Iri(ResolveIri(node));
  }

  Term InternBlank(std::string_view label) {
    const auto number =
        blanks_.try_emplace(std::string(label), blanks_.size()).first->second;
    char digits[24];
    std::snprintf(digits, sizeof(digits), "x%06zu", number);
    return Blank(blank_prefix_ + digits);
  }

  std::string ExpandCurie(const SerdNode& node) {
    SerdChunk start, rest;
    if (serd_env_expand(env_.get(), &node, &start, &rest) != SERD_SUCCESS) {
      RefusePrefix(GetText(node));
    }
    return CheckAbsolute(
        std::string(reinterpret_cast<const char*>(start.buf), start.len) +
        std::string(reinterpret_cast<const char*>(rest.buf), rest.len));
  }

  [[noreturn]] void RefusePrefix(std::string_view curie) const {
    const std::string name(curie.substr(0, curie.find(':') + 1));
    const std::size_t found = text_.rfind(name, at_);
    const std::size_t place = found == std::string_view::npos ? at_ : found;
    throw InputError(FormatPosition(place) + "unknown prefix '" + name +
                     "'; expected one declared with @prefix, or one of ours");
  }

  // Absolute IRIs are kept as written; relative ones need a base.
  std::string ResolveIri(const SerdNode& node) {
    if (HasScheme(GetText(node))) return std::string(GetText(node));
    SerdNode resolved = serd_env_expand_node(env_.get(), &node);
    std::string iri(resolved.buf == nullptr ? GetText(node)
                                            : GetText(resolved));
    serd_node_free(&resolved);
    return CheckAbsolute(std::move(iri));
  }

  std::string CheckAbsolute(std::string iri) const {
    if (HasScheme(iri)) return iri;
    throw InputError(Here() + "relative IRI <" + iri +
                     ">; expected an absolute IRI or an @base before it");
  }

  std::string FormatPosition(std::size_t offset) const {
    return TurtleErrorPlace(text_, source_.name, offset);
  }
  std::string Here() const { return FormatPosition(at_); }

  const std::string_view text_;
  const RdfSource& source_;
  const std::vector<std::size_t> labels_;
  const std::unique_ptr<SerdEnv, void (*)(SerdEnv*)> env_;
  const std::string blank_prefix_;
  std::map<std::string, std::size_t> blanks_;
  std::vector<Statement> statements_;
  std::size_t at_ = 0;
  std::size_t next_label_ = 0;
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
