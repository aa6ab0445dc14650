// Files referenced by a manifest's tests, by IRI.

#ifndef KG_ENGINE_CONFORMANCE_DOCUMENTS_H_
#define KG_ENGINE_CONFORMANCE_DOCUMENTS_H_

#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"

namespace kg_engine::conformance {

inline constexpr char kMf[] =
    "http://www.w3.org/2001/sw/DataAccess/tests/test-manifest#";
inline constexpr char kQt[] =
    "http://www.w3.org/2001/sw/DataAccess/tests/test-query#";
inline constexpr char kUt[] =
    "http://www.w3.org/2009/sparql/tests/test-update#";
inline constexpr char kRs[] =
    "http://www.w3.org/2001/sw/DataAccess/tests/result-set#";
inline constexpr char kRdft[] = "http://www.w3.org/ns/rdftest#";
inline constexpr char kSht[] = "http://www.w3.org/ns/shacl-test#";

// Name of the default graph, which has none in the tests.
inline constexpr char kDefaultGraph[] = "urn:kg:default";

// Thrown if a test cannot be run here; the text is the reason.
class NotRun : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// `text` with %XX for all but letters, digits and "/-._~".
std::string EscapeUrl(const std::string& text);

// Converts between paths and file:// URLs with %XX escapes. A URL that is not a
// file throws NotRun: nothing is fetched.
std::string UrlOfPath(const std::string& path);
std::string PathOfUrl(const std::string& url);

// The following throw InputError naming the file.
std::string GetText(const std::string& url);
// RDF by the file's suffix: RDF/XML, N-Triples, N-Quads, TriG; else Turtle.
std::vector<kg_core::Statement> CollectStatements(const std::string& url,
                                                  const std::string& graph);

// Graphs named by their files' URLs, each read once, so that blank nodes are
// shared between data, shapes and expected report.
class DocumentStore {
 public:
  void Load(const std::string& url);
  const kg_core::GraphView& view() const { return *view_; }

  std::vector<kg_core::Term> All(const std::string& graph,
                                 const kg_core::Term& subject,
                                 const std::string& property) const;
  std::optional<kg_core::Term> One(const std::string& graph,
                                   const kg_core::Term& subject,
                                   const std::string& property) const;
  std::vector<kg_core::Term> OfType(const std::string& graph,
                                    const std::string& type) const;

 private:
  kg_core::Store store_{""};
  std::shared_ptr<const kg_core::GraphView> view_ = store_.Read();
  std::set<std::string> loaded_;
};

}  // namespace kg_engine::conformance

#endif  // KG_ENGINE_CONFORMANCE_DOCUMENTS_H_
