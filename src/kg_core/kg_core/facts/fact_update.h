// One transaction of fact changes, as kg_msgs/FactUpdate carries it.

#ifndef KG_CORE_FACTS_FACT_UPDATE_H_
#define KG_CORE_FACTS_FACT_UPDATE_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/facts/source_file.h"
#include "kg_core/sparql/query_dataset.h"

namespace kg_core {

// Three strings in Turtle's term syntax with the usual prefixes known. Plain
// strings become geo:wktLiteral where that is the property's range, and other
// names of classes and properties (ex:BaseLayer, ssn:observedProperty) those
// that they stand for.
struct Fact {
  std::string subject;
  std::string property;
  std::string value;
};

struct FactUpdate {
  std::string id;         // Chosen by the sender, may be empty.
  std::string author;     // Who asks; kept in the log.
  std::vector<Fact> set;  // Replaces all values of (subject, property).
  std::vector<Fact> add;
  std::vector<Fact> remove;  // Empty value: all values; empty property, too:
                             // everything about the subject.
  std::string turtle;        // Facts in bulk, added.
  std::string sparql{};      // SPARQL 1.1 Update on the facts graph.
  // What the patterns of `sparql` see; nothing: what queries see.
  std::optional<Dataset> sparql_reads{};
  // Take the place of all facts that an operator stated, before `remove`.
  bool replaces_facts = false;
  // The files that its facts were read from, for the log: path and sha256.
  std::vector<SourceFile> files{};
};

}  // namespace kg_core

#endif  // KG_CORE_FACTS_FACT_UPDATE_H_
