// Each SHACL component, on one-line shapes.

#include "kg_mission/mission/validator.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/store.h"
#include "kg_core/rdf/turtle.h"

namespace kg_mission {
namespace {

using kg_base::InputError;
using kg_core::Ex;
using kg_core::ParseTurtle;

std::vector<kg_core::Violation> ValidateTexts(const std::string& shapes,
                                              const std::string& facts) {
  kg_core::Store store("");
  kg_core::Transaction transaction = store.Begin();
  for (const auto& s :
       ParseTurtle(shapes, "shapes", kg_core::Iri(kg_core::kVocabGraph))) {
    transaction.Add(s);
  }
  for (const auto& s : ParseTurtle(facts, "facts", kg_core::Facts())) {
    transaction.Add(s);
  }
  return Validate(transaction.view());
}

// ex:x has the `values` of ex:p; the property shape has `constraint`.
struct ComponentCase {
  const char* constraint;
  const char* good;
  const char* bad;
  const char* component;
};

const ComponentCase kCases[] = {
    {"sh:minCount 2", "1 , 2", "1", "MinCount"},
    {"sh:maxCount 1", "1", "1 , 2", "MaxCount"},
    {"sh:class ex:C", "ex:c", "ex:nothing", "Class"},
    {"sh:class ex:C", "ex:d", "\"ex:c\"", "Class"},
    {"sh:datatype xsd:integer", "3", "3.0", "Datatype"},
    {"sh:datatype xsd:dateTime", "\"2026-01-01T00:00:00Z\"^^xsd:dateTime",
     "\"2026-13-01T00:00:00Z\"^^xsd:dateTime", "Datatype"},
    {"sh:datatype xsd:boolean", "true", "\"yes\"^^xsd:boolean", "Datatype"},
    {"sh:nodeKind sh:IRI", "ex:c", "3", "NodeKind"},
    {"sh:nodeKind sh:BlankNodeOrLiteral", "[]", "ex:c", "NodeKind"},
    {"sh:minExclusive 0", "0.1", "0", "MinExclusive"},
    {"sh:minInclusive 0", "0", "-0.1", "MinInclusive"},
    {"sh:minInclusive 0", "1e0", "\"NaN\"^^xsd:double", "MinInclusive"},
    {"sh:maxExclusive 1", "0.9", "1.0", "MaxExclusive"},
    {"sh:maxInclusive 1", "1", "\"one\"", "MaxInclusive"},
    {"sh:minLength 2", "\"\xC3\xA4\xC3\xB6\"", "\"\xC3\xA4\"", "MinLength"},
    {"sh:maxLength 2", "\"ab\"", "\"abc\"", "MaxLength"},
    {"sh:pattern \"^a.c$\"", "\"abc\"", "\"Abc\"", "Pattern"},
    {"sh:pattern \"^a.c$\" ; sh:flags \"i\"", "\"ABC\"", "\"ab\"", "Pattern"},
    {"sh:in ( \"a\" 1 )", "1", "\"1\"", "In"},
    {"sh:hasValue 3", "3 , 4", "4", "HasValue"},
    {"sh:lessThan ex:q", "4", "5", "LessThan"},
    {"sh:lessThanOrEquals ex:q", "5", "6", "LessThanOrEquals"},
    {"sh:node [ sh:class ex:C ]", "ex:c", "ex:x", "Node"},
    {"sh:or ( [ sh:minInclusive 5 ] [ sh:maxInclusive 3 ] )", "2 , 6", "4",
     "Or"},
    {"sh:xone ( [ sh:minInclusive 3 ] [ sh:maxInclusive 5 ] )", "2 , 6", "4",
     "Xone"},
    {"sh:and ( [ sh:minInclusive 3 ] [ sh:maxInclusive 5 ] )", "3 , 5", "6",
     "And"},
    {"sh:not [ sh:class ex:C ]", "ex:x", "ex:c", "Not"},
    {"sh:languageIn ( \"de\" )", "\"a\"@de-CH", "\"a\"@den", "LanguageIn"},
    {"sh:uniqueLang true", "\"a\"@de , \"b\"@en", "\"a\"@de , \"b\"@de",
     "UniqueLang"},
    {"sh:equals ex:q", "5", "5 , 6", "Equals"},
    {"sh:disjoint ex:q", "6", "5 , 6", "Disjoint"},
    {"sh:qualifiedValueShape [ sh:class ex:C ] ; sh:qualifiedMinCount 1",
     "ex:c , 1", "1", "QualifiedMinCount"},
    {"sh:qualifiedValueShape [ sh:class ex:C ] ; sh:qualifiedMaxCount 1",
     "ex:c , 1", "ex:c , ex:d", "QualifiedMaxCount"},
    {"sh:datatype xsd:byte", "\"-128\"^^xsd:byte", "\"128\"^^xsd:byte",
     "Datatype"},
    {"sh:datatype xsd:date", "\"2024-02-29\"^^xsd:date",
     "\"2023-02-29\"^^xsd:date", "Datatype"},
    {"sh:node [ sh:closed true ; sh:ignoredProperties ( rdf:type ) ]", "ex:c",
     "ex:x", "Node"},
};

std::string ShapeWith(const std::string& constraint) {
  return "ex:S a sh:NodeShape ; sh:targetNode ex:x ; sh:property [ sh:path "
         "ex:p ; " +
         constraint + " ] . ex:D rdfs:subClassOf ex:C .";
}
std::string FactsWith(const std::string& values) {
  return "ex:x ex:q 5 ; ex:p " + values + " . ex:c a ex:C . ex:d a ex:D .";
}

TEST(ValidatorTest, EveryComponentPassesTheGoodAndNamesItselfOnTheBad) {
  for (const ComponentCase& c : kCases) {
    const std::string shapes = ShapeWith(c.constraint);
    EXPECT_TRUE(ValidateTexts(shapes, FactsWith(c.good)).empty())
        << c.constraint << " with " << c.good;
    const auto violations = ValidateTexts(shapes, FactsWith(c.bad));
    ASSERT_EQ(violations.size(), 1u) << c.constraint << " with " << c.bad;
    EXPECT_EQ(violations[0].component,
              "sh:" + std::string(c.component) + "ConstraintComponent");
    EXPECT_EQ(violations[0].focus_node, Ex("x"));
    EXPECT_EQ(violations[0].path->predicate, Ex("p"));
    EXPECT_EQ(violations[0].named_shape, Ex("S"));
  }
}

TEST(ValidatorTest, NestedPropertyShapesBlameTheInnerNode) {
  const auto violations =
      ValidateTexts(ShapeWith("sh:property [ sh:path ex:r ; sh:minCount 1 ]"),
                    FactsWith("ex:c"));
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].focus_node, Ex("c"));
  EXPECT_EQ(violations[0].path->predicate, Ex("r"));
}

TEST(ValidatorTest, TargetClassReachesInstancesOfSubclasses) {
  const std::string shapes =
      "ex:S a sh:NodeShape ; sh:targetClass ex:C ; sh:property [ sh:path ex:p "
      "; sh:minCount 1 ] . ex:E rdfs:subClassOf ex:D . ex:D rdfs:subClassOf "
      "ex:C .";
  const auto violations = ValidateTexts(shapes, "ex:e a ex:E . ex:f a ex:F .");
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].focus_node, Ex("e"));
}

TEST(ValidatorTest, SubclassCyclesEnd) {
  EXPECT_TRUE(ValidateTexts("ex:S a sh:NodeShape ; sh:targetClass ex:C . "
                            "ex:C rdfs:subClassOf ex:D . ex:D "
                            "rdfs:subClassOf ex:C .",
                            "ex:e a ex:D .")
                  .empty());
}

TEST(ValidatorTest, LineSaysWhereWhatAndWhichValue) {
  const auto violations = ValidateTexts(
      ShapeWith("sh:maxInclusive 1 ; sh:message \"expected at most 1\""),
      FactsWith("1.2"));
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].Line(),
            "ex:x ex:p: expected at most 1, not 1.2 (ex:S)");
}

TEST(ValidatorTest, RefusesAComponentThatIsNotAvailable) {
  EXPECT_THROW(ValidateTexts(ShapeWith("sh:sparql []"), FactsWith("1")),
               InputError);
  EXPECT_THROW(ValidateTexts(ShapeWith("sh:minCuont 1"), FactsWith("1")),
               InputError);
}

TEST(ValidatorTest, RefusesShapesThatReferToThemselves) {
  EXPECT_THROW(
      ValidateTexts("ex:S a sh:NodeShape ; sh:targetNode ex:x ; sh:node ex:S .",
                    FactsWith("1")),
      InputError);
}

// Nodes reached from ex:x by each kind of path in the data below.
struct PathCase {
  const char* path;
  const char* reached;  // Sorted.
};
const PathCase kPaths[] = {
    {"ex:p", "ex:a ex:b"},
    {"( ex:p ex:q )", "ex:c"},
    {"[ sh:inversePath ex:p ]", "ex:a ex:z"},
    {"[ sh:inversePath ( ex:q ex:p ) ]", "ex:w"},
    {"[ sh:alternativePath ( ex:p [ sh:inversePath ex:p ] ) ]",
     "ex:a ex:b ex:z"},
    {"[ sh:zeroOrMorePath ex:p ]", "ex:a ex:b ex:x"},
    {"[ sh:oneOrMorePath ex:p ]", "ex:a ex:b ex:x"},
    {"[ sh:oneOrMorePath [ sh:inversePath ex:p ] ]", "ex:a ex:x ex:z"},
    {"( ex:p [ sh:zeroOrOnePath ex:q ] )", "ex:a ex:b ex:c"},
};

TEST(ValidatorTest, PathsOfEveryKindReachWhatTheyShould) {
  for (const PathCase& c : kPaths) {
    std::string reached;
    for (const kg_core::Violation& violation :
         ValidateTexts(std::string("ex:S a sh:NodeShape ; sh:targetNode ex:x ; "
                                   "sh:property [ sh:path ") +
                           c.path + " ; sh:nodeKind sh:Literal ] .",
                       "ex:x ex:p ex:a , ex:b . ex:a ex:q ex:c ; ex:p ex:x . "
                       "ex:z ex:p ex:x . ex:w ex:q ex:z .")) {
      if (!reached.empty()) reached += " ";
      reached += kg_core::ToTurtle(violation.value);
      EXPECT_EQ(kg_core::shacl::ToTurtle(*violation.path), c.path);
    }
    EXPECT_EQ(reached, c.reached) << c.path;
  }
}

// Each shape is rejected on loading with a message that contains `said`.
struct IllFormed {
  const char* constraint;
  const char* said;
};
const IllFormed kIllFormed[] = {
    {"sh:path ex:q", "at most one sh:path"},
    {"sh:minCount 1 , 2", "at most one sh:minCount"},
    {"sh:minCount 1.5", "an integer of at least 0 as sh:minCount, not 1.5"},
    {"sh:maxLength -1", "an integer of at least 0"},
    {"sh:class \"C\"", "an IRI as sh:class"},
    {"sh:nodeKind ex:Iri", "as sh:nodeKind"},
    {"sh:pattern \"(\"", "a regular expression"},
    {"sh:pattern \"a\" ; sh:flags \"z\"", "a regular expression"},
    {"sh:in 3", "an RDF list as sh:in"},
    {"sh:or ( 3 )", "a shape as sh:or"},
    {"sh:uniqueLang 1", "true or false as sh:uniqueLang"},
    {"sh:languageIn ( 1 )", "language ranges"},
    {"sh:minInclusive ex:a", "a literal as sh:minInclusive"},
    {"sh:property [ sh:minLength 1 ]", "with a sh:path as sh:property"},
    {"sh:node [ sh:minCount 1 ]", "no sh:minCount in a node shape"},
    {"sh:node ex:Nothing", "nothing describes it"},
    {"sh:severity 3", "an IRI as sh:severity"},
    {"sh:deactivated \"yes\"", "true or false as sh:deactivated"},
    {"sh:targetClass 3", "an IRI as sh:targetClass"},
};

TEST(ValidatorTest, RefusesIllFormedShapesAndSaysWhatWasExpected) {
  for (const IllFormed& c : kIllFormed) {
    try {
      ValidateTexts(ShapeWith(c.constraint), FactsWith("1"));
      ADD_FAILURE() << c.constraint;
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find(c.said), std::string::npos) << what;
      EXPECT_EQ(what.rfind("shape ex:", 0), 0u) << what;
    }
  }
}

TEST(ValidatorTest, RefusesPathsThatAreNone) {
  for (const char* path : {"\"p\"", "( ex:p )", "[]", "[ sh:inversePath 3 ]",
                           "[ sh:inversePath ex:p ; sh:zeroOrOnePath ex:p ]"}) {
    EXPECT_THROW(ValidateTexts("ex:S a sh:NodeShape ; sh:targetNode ex:x ; "
                               "sh:property [ sh:path " +
                                   std::string(path) + " ] .",
                               FactsWith("1")),
                 InputError)
        << path;
  }
}

TEST(ValidatorTest, APathThatIsAListAndMoreIsTheList) {
  const auto violations = ValidateTexts(
      "ex:S a sh:NodeShape ; sh:targetNode ex:x ; sh:property [ sh:minCount 1 "
      "; "
      "sh:path [ rdf:first ex:p ; rdf:rest ( ex:r ) ; sh:inversePath ex:q ] ] "
      ".",
      FactsWith("1"));
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(kg_core::shacl::ToTurtle(*violations[0].path), "( ex:p ex:r )");
}

TEST(ValidatorTest, DeactivatedShapesAskNothing) {
  EXPECT_TRUE(ValidateTexts(ShapeWith("sh:minCount 9 ; sh:deactivated true"),
                            FactsWith("1"))
                  .empty());
}

TEST(ValidatorTest, ReportHoldsEveryResultWithItsFields) {
  const std::string report = kg_core::ReportTurtle(
      ValidateTexts(ShapeWith("sh:maxInclusive 1 ; sh:severity sh:Warning ; "
                              "sh:message \"too much\"@en"),
                    FactsWith("1.2")));
  for (const char* said :
       {"sh:conforms false", "sh:focusNode ex:x", "sh:resultPath ex:p",
        "sh:value 1.2", "sh:resultSeverity sh:Warning",
        "sh:sourceConstraintComponent sh:MaxInclusiveConstraintComponent",
        "sh:resultMessage \"too much\"@en"}) {
    EXPECT_NE(report.find(said), std::string::npos) << said << report;
  }
  EXPECT_NE(kg_core::ReportTurtle({}).find("sh:conforms true"),
            std::string::npos);
  EXPECT_FALSE(ParseTurtle(report, "report", kg_core::Facts()).empty());
}

TEST(ValidatorTest, RefusesAPatternThatIsNone) {
  EXPECT_THROW(ValidateTexts(ShapeWith("sh:pattern \"(\""), FactsWith("\"a\"")),
               InputError);
}

}  // namespace
}  // namespace kg_mission
