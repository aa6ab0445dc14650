// One transaction of fact changes, as kg_msgs/FactUpdate carries it: parsed,
// checked against vocabulary and shapes, applied or refused whole.

#ifndef KG_CORE_MISSION_FACT_UPDATE_H_
#define KG_CORE_MISSION_FACT_UPDATE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kg_core/mission/mission.h"
#include "kg_core/rdf/store.h"
#include "kg_core/shacl/violation.h"
#include "kg_core/sparql/query_engine.h"

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

// Stages the update's changes in `transaction` (facts graph): `replaces_facts`
// first, which leaves what files have stated; then `remove`,
// then `set`, `add`, `turtle` and `sparql`; then what follows from them
// (derived_facts.h) and what the rules conclude (inference.h). Returns the
// reasons to refuse it; empty = none. With reasons, the transaction is half
// done and to be dropped. Knows nothing of files: see ingest.h. What an earlier
// ingest stated is dropped if IngestIsDue.
//  - malformed terms or Turtle, with the position;
//  - a property that the ontology does not know, with the nearest known name;
//  - `remove` of a fact that is not there;
//  - violations of the shapes in the state after it, e.g. an agent whose policy
//    does not exist, a confidence of 1.2, malformed WKT; only what the change
//    can have touched is checked (ValidateChange, validator.h);
//  - a rule that cannot be used, or whose conclusions are no facts that the
//    above would let pass (conclusions.h);
//  - two with one key, e.g. two costs of an edge for one agent (keys.h);
//  - a mission that can no longer be read (mission_reader.h).
std::vector<std::string> StageUpdate(const FactUpdate& update,
                                     Transaction& transaction);

// The same, with the violations of shapes themselves, even where the reasons
// are others; nothing if the update could not be read and applied.
struct Judgement {
  std::vector<std::string> reasons;
  std::optional<std::vector<Violation>> violations;
};
Judgement JudgeUpdate(const FactUpdate& update, Transaction& transaction);

// Adds the log entry of an accepted update (graph ex:graph/log): who, when,
// each old and new value, and the provenance activity (ex:graph/prov), which
// prov:used the update's files. Adds nothing if no fact changed. `time_s` is
// unix time.
void LogUpdate(const FactUpdate& update, double time_s,
               Transaction& transaction);

// The activity (ex:LoadVocabulary in ex:graph/prov) of a vocabulary that was
// read from `files`; its triples are not logged one by one. Adds nothing if
// there are none.
void LogVocabulary(const std::vector<SourceFile>& files, double time_s,
                   Transaction& transaction);

// StageUpdate for a file of facts, whose name stands in the reasons, e.g. a
// mission's mission.ttl.
std::vector<std::string> StageFactsFile(const std::string& path,
                                        Transaction& transaction);

}  // namespace kg_core

#endif  // KG_CORE_MISSION_FACT_UPDATE_H_
