// For tests: a small valid mission with one instance of every class that has a
// shape, in its own store. Tests run in the package's source folder.

#ifndef KG_MISSION_MISSION_TESTING_MISSION_WORLD_H_
#define KG_MISSION_MISSION_TESTING_MISSION_WORLD_H_

#include <stdexcept>
#include <string>
#include <vector>

#include "kg_core/facts/update_log.h"
#include "kg_core/rdf/store.h"
#include "kg_mission/mission/stage_update.h"
#include "kg_mission/mission/stage_vocabulary.h"

namespace kg_mission {

inline constexpr char kTestFacts[] = R"ttl(
ex:m a ex:Mission ; ex:name "test" ; ex:hasWindow ex:w0 , ex:w1 ;
    ex:hasAgent ex:alpha , ex:bravo ; ex:minimumSeparationKm 5 .
ex:w0 a ex:TimeWindow ; ex:index 0 ; ex:confidence 1.0 ;
    time:hasBeginning "2026-06-02T00:00:00Z"^^xsd:dateTime .
ex:w1 a ex:TimeWindow ; ex:index 1 ; ex:confidence 0.887 ;
    time:hasBeginning "2026-06-03T00:00:00Z"^^xsd:dateTime ;
    ex:durationHours 24 .
ex:safe a ex:Policy ; ex:alpha_base 1 ; ex:lambda_time 3.6 ;
    ex:lambda_energy 0.36 ; ex:priors '{"corridor": 0.8}' ;
    ex:softOverrides '{"sanctuary": 0.1}' .
ex:fast a ex:Policy ; ex:alpha_base 1.5 .
ex:corridor a ex:PriorLayer ; ex:name "corridor" ; ex:edgeKm 2 ;
    geo:asWKT "POLYGON((-90 25, -89 25, -89 27, -90 27, -90 25))" .
ex:sanctuary a ex:Constraint ; ex:kind "soft" ; ex:attenuation 0.4 ;
    geo:asWKT "POLYGON((-94 27, -93 27, -93 28, -94 28, -94 27))" .
ex:land a ex:Constraint ; ex:kind "no_go" ; ex:gridRef "land" ;
    ex:bufferCells 5 .
ex:cool a ex:CoolingConstraint ; ex:kind "soft" ; ex:attenuation 0.5 ;
    geo:asWKT "POLYGON((-92 27, -91 27, -91 28, -92 28, -92 27))" ;
    ex:forAgent ex:bravo ; ex:forWindow ex:w1 ;
    ex:expires "2026-06-04T00:00:00Z"^^xsd:dateTime .
ex:seep a ex:Event ; ex:forWindow ex:w0 ; ex:value 5 ; ex:capacity 2 ;
    geo:asWKT "POINT(-93.5 27.5)" .
ex:alpha a ex:Agent ; ex:id "alpha" ; ex:usesPolicy ex:safe ;
    ex:hasCapabilities ex:alpha_can .
ex:bravo a ex:Agent ; ex:id "bravo" ; ex:usesPolicy ex:fast ;
    ex:hasCapabilities ex:alpha_can .
ex:alpha_can a ex:AgentCapabilities ; ex:cruiseSpeedKts 1 ;
    ex:maxSpeedKts 1.5 ; ex:energyPerKm 2 ; ex:energyBudget 500 ;
    ex:sensorRadiusKm 12 .
ex:alpha_start a ex:AgentState ; ex:forAgent ex:alpha ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-93.5 26.5)" ; ex:headingDeg 90 .
ex:bravo_start a ex:AgentState ; ex:forAgent ex:bravo ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-90 26)" .
)ttl";

// Instances of the classes stated by ingest and planners.
inline constexpr char kTestArtifacts[] = R"ttl(
ex:sst a ex:DataSource ; ex:file "x.nc" ; ex:provides "temperature" .
ex:file1 a ex:SourceFile ; ex:path "/data/x.nc" ;
    ex:sha256 "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef" .
ex:grid a ex:GridSpec ; ex:rows 25 ; ex:cols 50 ; ex:pixelSizeKm 4.45 ;
    geo:asWKT "POLYGON((-92 24, -90 24, -90 25, -92 25, -92 24))" .
ex:field a ex:CurrentField ; ex:forWindow ex:w0 ; ex:gridRefU "x.nc#u@0..1" ;
    ex:gridRefV "x.nc#v@0..1" ; ex:firstTimeIndex 0 ; ex:lastTimeIndex 1 ;
    ex:onGrid ex:grid ; prov:wasDerivedFrom ex:file1 .
ex:waves a ex:CostField ; ex:forWindow ex:w0 ; ex:gridRef "x.nc#swh@0..1" ;
    ex:firstTimeIndex 0 ; ex:lastTimeIndex 1 ; ex:onGrid ex:grid ;
    sosa:observedProperty ex:waveHeight ; prov:wasDerivedFrom ex:file1 .
ex:layer1 a ex:BaseLayer ; ex:forWindow ex:w0 ; ex:kind "delta_sst" ;
    ex:timeIndex 1 ; ex:previousTimeIndex 0 ; prov:wasDerivedFrom ex:file1 .
ex:heat a ex:HeatmapArtifact ; ex:forAgent ex:alpha ; ex:forWindow ex:w0 ;
    ex:tensorKind "FUSED" ; ex:hash "0af1" .
ex:nav a ex:NavGraph ; ex:forWindow ex:w0 ; ex:movementMode "hops" .
ex:p1 a ex:Waypoint ; ex:inGraph ex:nav ; ex:score 2.5 ;
    geo:asWKT "POINT(-93 26)" .
ex:p2 a ex:Waypoint ; ex:inGraph ex:nav ; geo:asWKT "POINT(-93 26.2)" .
ex:edge a ex:TraverseEdge ; ex:inGraph ex:nav ; ex:from ex:p1 ; ex:to ex:p2 .
ex:cost a ex:EdgeCost ; ex:forEdge ex:edge ; ex:forAgent ex:alpha ;
    ex:costHours 5.5 ; ex:costEnergy 30 ; ex:costRisk 0 .
ex:run a ex:PlanRun ; ex:forWindow ex:w0 , ex:w1 ; ex:worldVersion 3 ;
    ex:status "ok" .
ex:as a ex:Assignment ; ex:forAgent ex:alpha ; ex:forWindow ex:w0 ;
    ex:waypointWKT "POINT(-93 26.2)" ; prov:wasGeneratedBy ex:run .
ex:rejection a ex:Rejection ; ex:forAgent ex:bravo ; ex:forWindow ex:w0 ;
    ex:kind "separation" ; ex:reason "too near" ; ex:rank 0 ; ex:round 1 ;
    ex:lostTo ex:alpha ; prov:wasGeneratedBy ex:run .
ex:toll a ex:Price ; ex:forAgent ex:bravo ; ex:forWindow ex:w0 ;
    ex:ofWaypoint ex:p1 ; ex:price 0.5 ; prov:wasGeneratedBy ex:run .
ex:promise a ex:Commitment ; ex:forAgent ex:alpha ;
    prov:wasGeneratedBy ex:run .
ex:phi2 a ex:CompilePhi2 ; ex:worldVersion 3 ;
    prov:startedAtTime "2026-06-01T00:00:00Z"^^xsd:dateTime ;
    prov:endedAtTime "2026-06-01T00:00:01Z"^^xsd:dateTime ;
    prov:used ex:field ; prov:generated ex:heat .
ex:state a ex:MissionState ; ex:missionFolder "/missions/test" ; ex:cycle 2 ;
    ex:planRun 1 ; ex:currentPlan ex:run ; ex:ended false ;
    ex:missionTime "2026-06-02T00:00:00Z"^^xsd:dateTime .
ex:update a ex:UpdateFacts ; ex:worldVersion 3 ; ex:author "operator" .
ex:change a ex:FactChange ; ex:inUpdate ex:update ; ex:ofSubject ex:alpha ;
    ex:ofProperty ex:usesPolicy ; ex:oldValue ex:fast ; ex:newValue ex:safe .
ex:rule a ex:Rule ; rdfs:label "none" ; rdfs:comment "Concludes nothing." ;
    ex:construct "CONSTRUCT { ?p ex:mustAvoid ?p } WHERE { ?p ex:horizon 9 }" .
)ttl";

class MissionWorld {
 public:
  // Creates a store with `facts`, which must be valid.
  explicit MissionWorld(const std::string& facts = kTestFacts) {
    kg_core::Transaction vocabulary = store.Begin();
    StageVocabulary("../kg_mission/ontology", vocabulary);
    vocabulary.Commit(kg_core::WorldChange::kYes);
    std::string all;
    for (const std::string& reason : Commit({"", "test", {}, {}, {}, facts})) {
      all += reason + "\n";
    }
    if (!all.empty()) throw std::logic_error("the test's own facts: " + all);
  }

  // Returns the reasons to reject `update`; commits it if there are none.
  std::vector<std::string> Commit(const kg_core::FactUpdate& update) {
    kg_core::Transaction transaction = store.Begin();
    std::vector<std::string> reasons = StageUpdate(update, transaction);
    if (reasons.empty()) {
      kg_core::LogUpdate(update, 1.78e9, transaction);
      transaction.Commit(kg_core::WorldChange::kYes);
    }
    return reasons;
  }
  std::vector<std::string> Set(const kg_core::Fact& fact) {
    return Commit({"", "test", {fact}, {}, {}, ""});
  }
  std::vector<std::string> Add(const std::string& turtle) {
    return Commit({"", "test", {}, {}, {}, turtle});
  }
  std::vector<std::string> Remove(const kg_core::Fact& fact) {
    return Commit({"", "test", {}, {}, {fact}, ""});
  }

  kg_core::Store store{""};
};

// All reasons as one string, for HasSubstr.
inline std::string Joined(const std::vector<std::string>& reasons) {
  std::string all;
  for (const std::string& reason : reasons) all += reason + "\n";
  return all;
}

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_TESTING_MISSION_WORLD_H_
