// One transaction of fact changes, as transported by kg_msgs/FactUpdate.

#ifndef KG_CORE_FACTS_FACT_UPDATE_H_
#define KG_CORE_FACTS_FACT_UPDATE_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/facts/source_file.h"
#include "kg_core/rdf/store.h"
#include "kg_core/sparql/query_dataset.h"

namespace kg_core {

// Three strings in Turtle term syntax with predefined prefixes. Plain strings
// become geo:wktLiteral if that is the property's range; alternative names of
// classes and properties (ex:BaseLayer, ssn:observedProperty) are replaced by
// the canonical ones.
struct Fact {
  std::string subject;
  std::string property;
  std::string value;
};

struct FactUpdate {
  std::string id;         // Chosen by the sender, may be empty.
  std::string author;     // Name of the sender, recorded in the log.
  std::vector<Fact> set;  // Replaces all values of (subject, property).
  std::vector<Fact> add;
  std::vector<Fact> remove;  // Empty value: all values; if the property is
                             // empty too: all facts about the subject.
  std::string turtle;        // Facts to add, as Turtle text.
  std::string sparql{};      // SPARQL 1.1 Update on the facts graph.
  // Dataset read by the patterns of `sparql`; nullopt: the default dataset of
  // queries.
  std::optional<Dataset> sparql_reads{};
  // If true, all facts stated by operators are removed first, before `remove`.
  bool replaces_facts = false;
  // The files from which the facts were read, for the log: path and sha256.
  std::vector<SourceFile> files{};
  // Facts to add that were parsed already: their blank nodes stay those of the
  // other graphs of a file.
  std::vector<Statement> statements{};
};

}  // namespace kg_core

#endif  // KG_CORE_FACTS_FACT_UPDATE_H_
