// The shipped ontology: the paper's class tree, and the properties required of
// every term.

#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/terms.h"
#include "kg_core/facts/vocabulary.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/shacl/shapes.h"
#include "kg_mission/mission/testing/mission_world.h"

namespace kg_mission {
namespace {

using kg_core::Ex;
using kg_core::GraphView;
using kg_core::Has;
using kg_core::Iri;
using kg_core::Rdfs;
using kg_core::Subjects;
using kg_core::Term;
using kg_core::Vocabulary;

Term Owl(const std::string& local) { return Iri(kg_core::kOwl + local); }

struct Edge {
  const char* below;
  const char* above;
};
// Fig. 2, the rest of the paper's classes (A41), and the alignments.
const Edge kTree[] = {
    {"ex:Agent", "ex:MissionEntity"},
    {"ex:Policy", "ex:MissionEntity"},
    {"ex:Mission", "ex:MissionEntity"},
    {"ex:Event", "ex:MissionEntity"},
    {"ex:AgentCapabilities", "ex:MissionEntity"},
    {"ex:TimeWindow", "ex:SpatiotemporalEntity"},
    {"ex:TimeWindow", "time:TemporalEntity"},
    {"ex:TimeWindow", "time:ProperInterval"},
    {"time:Instant", "time:TemporalEntity"},
    {"ex:MissionState", "ex:SpatiotemporalEntity"},
    {"ex:GridSpec", "ex:SpatiotemporalEntity"},
    {"ex:WorkField", "ex:SpatiotemporalEntity"},
    {"ex:WorkLayer", "ex:WorkField"},
    {"ex:CurrentField", "ex:WorkField"},
    {"ex:CurrentField", "sosa:Observation"},
    {"ex:ValueLayer", "ex:SpatiotemporalEntity"},
    {"ex:BaseLayer", "ex:ValueLayer"},
    {"ex:PriorLayer", "ex:SpatiotemporalEntity"},
    {"ex:Constraint", "ex:SpatiotemporalEntity"},
    {"ex:Constraint", "geo:Feature"},
    {"ex:CoolingConstraint", "ex:Constraint"},
    {"ex:AgentState", "ex:SpatiotemporalEntity"},
    {"ex:TensorArtifact", "ex:Artifact"},
    {"ex:HeatmapArtifact", "ex:TensorArtifact"},
    {"ex:NavGraph", "ex:Artifact"},
    {"ex:Waypoint", "ex:Artifact"},
    {"ex:TraverseEdge", "ex:Artifact"},
    {"ex:EdgeCost", "ex:Artifact"},
    {"ex:Assignment", "ex:Artifact"},
    {"ex:Artifact", "prov:Entity"},
    {"ex:CompilePhi2", "prov:Activity"},
    {"ex:CompilePhi1", "prov:Activity"},
    {"ex:PlanRun", "prov:Activity"},
    {"ex:SelectRun", "prov:Activity"},
};

std::vector<Term> OfType(const GraphView& view, const std::string& type) {
  return Subjects(view, kg_core::kVocabGraph, kg_core::RdfType(), Owl(type));
}

std::vector<Term> Properties(const GraphView& view) {
  std::vector<Term> all;
  for (const char* type :
       {"ObjectProperty", "DatatypeProperty", "AnnotationProperty"}) {
    const std::vector<Term> some = OfType(view, type);
    all.insert(all.end(), some.begin(), some.end());
  }
  const std::vector<Term> either =
      Subjects(view, kg_core::kVocabGraph, kg_core::RdfType(),
               Iri(std::string(kg_core::kRdf) + "Property"));
  all.insert(all.end(), either.begin(), either.end());
  return all;
}

std::vector<Term> CollectProperties(
    const std::optional<kg_core::shacl::PropertyPath>& path) {
  if (!path) return {};
  if (path->kind == kg_core::shacl::PropertyPath::Kind::kPredicate) {
    return {path->predicate};
  }
  std::vector<Term> all;
  for (const kg_core::shacl::PropertyPath& part : path->parts) {
    const std::vector<Term> some = CollectProperties(part);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

class OntologyTest : public testing::Test {
 protected:
  MissionWorld world_{""};
  const std::shared_ptr<const GraphView> view_ = world_.store.Read();

  bool Says(const Term& subject, const Term& property) const {
    return kg_core::FirstObject(*view_, kg_core::kVocabGraph, subject, property)
        .has_value();
  }
};

TEST_F(OntologyTest, HoldsThePapersClassTree) {
  const Vocabulary vocabulary(*view_);
  for (const Edge& edge : kTree) {
    const Term below = kg_core::ParseTurtleTerm(edge.below);
    EXPECT_TRUE(vocabulary.HasClass(below)) << edge.below;
    EXPECT_EQ(kg_core::ClassAndSubclasses(*view_,
                                          kg_core::ParseTurtleTerm(edge.above))
                  .count(below),
              1u)
        << edge.below << " under " << edge.above;
  }
}

TEST_F(OntologyTest, EveryClassOfOursHasLabelCommentAndAPlaceInTheTree) {
  for (const Term& type : OfType(*view_, "Class")) {
    if (type.text.rfind(kg_core::kEx, 0) != 0) continue;
    EXPECT_TRUE(Says(type, Rdfs("label"))) << type;
    EXPECT_TRUE(Says(type, Rdfs("comment"))) << type;
    EXPECT_TRUE(Says(type, Rdfs("subClassOf"))) << type;
  }
}

TEST_F(OntologyTest, EveryPropertyHasLabelCommentDomainAndRange) {
  const std::vector<Term> properties = Properties(*view_);
  EXPECT_GT(properties.size(), 100u);
  for (const Term& property : properties) {
    EXPECT_TRUE(Says(property, Rdfs("label"))) << property;
    EXPECT_TRUE(Says(property, Rdfs("comment"))) << property;
    EXPECT_TRUE(Says(property, Ex("domainIncludes"))) << property;
    EXPECT_TRUE(Says(property, Ex("rangeIncludes"))) << property;
  }
}

TEST_F(OntologyTest, EveryNumberWithAUnitSaysIt) {
  const Term number = Iri(std::string(kg_core::kXsd) + "double");
  for (const Term& property :
       Subjects(*view_, kg_core::kVocabGraph, Ex("rangeIncludes"), number)) {
    EXPECT_TRUE(Says(property, Ex("unit"))) << property;
  }
}

TEST_F(OntologyTest, DomainsAndRangesAreClassesThatItKnows) {
  const Vocabulary vocabulary(*view_);
  for (const Term& property : Properties(*view_)) {
    const kg_core::PropertyFacts* facts = vocabulary.FindProperty(property);
    ASSERT_NE(facts, nullptr);
    if (facts->is_annotation) continue;
    for (const auto& classes : {facts->domains, facts->classes}) {
      for (const Term& type : classes) {
        const bool is_rdf = type.text.rfind(kg_core::kRdf, 0) == 0 ||
                            type.text.rfind(kg_core::kRdfs, 0) == 0;
        EXPECT_TRUE(is_rdf || vocabulary.HasClass(type))
            << property << " " << type;
      }
    }
  }
}

TEST_F(OntologyTest, ShapesSpeakOfKnownPropertiesAndClassesOnly) {
  const Vocabulary vocabulary(*view_);
  for (const auto& [id, shape] :
       kg_core::shacl::LoadShapes(*view_, kg_core::kVocabGraph)) {
    for (const Term& property : CollectProperties(shape.path)) {
      EXPECT_NE(vocabulary.FindProperty(property), nullptr) << property;
    }
    for (const Term& target : shape.target_classes) {
      EXPECT_TRUE(vocabulary.HasClass(target)) << target;
    }
  }
}

TEST_F(OntologyTest, EveryShapeSaysWhatWasExpected) {
  for (const auto& [id, shape] :
       kg_core::shacl::LoadShapes(*view_, kg_core::kVocabGraph)) {
    if (!shape.path) continue;
    const bool is_nested = shape.constraints.size() == 1;  // In xone, or.
    EXPECT_TRUE(!shape.message.empty() || is_nested)
        << shape.named << " " << kg_core::shacl::ToTurtle(*shape.path);
  }
}

TEST_F(OntologyTest, AliasesAreStated) {
  EXPECT_TRUE(Has(*view_, kg_core::kVocabGraph, Ex("BaseLayer"),
                  Owl("equivalentClass"), Ex("ValueLayer")));
  EXPECT_TRUE(Has(*view_, kg_core::kVocabGraph, Ex("WorkLayer"),
                  Owl("equivalentClass"), Ex("WorkField")));
  EXPECT_TRUE(Has(*view_, kg_core::kVocabGraph,
                  Iri(std::string(kg_core::kSsn) + "observedProperty"),
                  Owl("equivalentProperty"),
                  Iri(std::string(kg_core::kSosa) + "observedProperty")));
}

}  // namespace
}  // namespace kg_mission
