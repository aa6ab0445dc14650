// https://www.w3.org/TR/sparql11-service-description/
#include <set>
#include <string>

#include "kg_core/rdf/namespaces.h"
#include "kg_engine/protocol/formats.h"
#include "kg_engine/protocol/operations.h"

namespace kg_engine::protocol {
namespace {

using kg_core::Blank;
using kg_core::Iri;
using kg_core::Term;

constexpr char kSd[] = "http://www.w3.org/ns/sparql-service-description#";
constexpr char kFormats[] = "http://www.w3.org/ns/formats/";

// https://www.w3.org/ns/formats/
constexpr const char* kFormatNames[] = {
    "SPARQL_Results_JSON",
    "SPARQL_Results_XML",
    "SPARQL_Results_CSV",
    "SPARQL_Results_TSV",
    "Turtle",
    "N-Triples",
    "RDF_XML",
};

class ServiceDescription {
 public:
  void Add(const Term& subject, const char* property, const Term& object) {
    triples_.push_back({subject, Iri(std::string(kSd) + property), object});
  }
  void AddType(const Term& subject, const char* type) {
    triples_.push_back({subject, Iri(std::string(kg_core::kRdf) + "type"),
                        Iri(std::string(kSd) + type)});
  }
  kg_core::QueryResult Result() && {
    kg_core::QueryResult result;
    result.form = kg_core::QueryResult::Form::kConstruct;
    result.triples = std::move(triples_);
    return result;
  }

 private:
  std::vector<kg_core::Triple> triples_;
};

void DescribeDataset(const RequestContext& context, const Term& service,
                     ServiceDescription* description) {
  const Term dataset = Blank("dataset");
  const Term merged = Blank("default");
  description->Add(service, "defaultDataset", dataset);
  description->AddType(dataset, "Dataset");
  description->Add(dataset, "defaultGraph", merged);
  description->AddType(merged, "Graph");
  const auto view = context.store.read();
  int number = 0;
  for (const std::string& graph : context.store.dataset(*view).default_graphs) {
    const Term node = Blank("graph" + std::to_string(++number));
    description->Add(dataset, "namedGraph", node);
    description->AddType(node, "NamedGraph");
    description->Add(node, "name", Iri(graph));
  }
}

}  // namespace

HttpResponse DescribeService(const RequestContext& context) {
  const AnswerFormat& format =
      ChooseFormat(context.request, AnswerKind::kTriples);
  const Term service = Blank("service");
  ServiceDescription description;
  description.AddType(service, "Service");
  const std::string host = Header(context.request, "host");
  if (!host.empty() && host.find_first_of(" <>\"{}|\\^`") == host.npos) {
    description.Add(service, "endpoint", Iri("http://" + host + "/sparql"));
  }
  const auto language = [&](const char* name) {
    description.Add(service, "supportedLanguage", Iri(std::string(kSd) + name));
  };
  language("SPARQL11Query");
  if (context.options.writable) language("SPARQL11Update");
  for (const char* name : kFormatNames) {
    description.Add(service, "resultFormat", Iri(std::string(kFormats) + name));
  }
  DescribeDataset(context, service, &description);
  return WriteAnswer(std::move(description).Result(), format);
}

}  // namespace kg_engine::protocol
