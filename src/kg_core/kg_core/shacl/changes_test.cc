// Compares validation of a change with full validation.

#include "kg_core/shacl/changes.h"

#include <gtest/gtest.h>

#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/shacl/shapes.h"
#include "kg_core/shacl/validation.h"

namespace kg_core::shacl {
namespace {

constexpr char kShapes[] = R"ttl(
ex:A a sh:NodeShape ; sh:targetClass ex:C0 ; sh:targetNode ex:n0 ;
  sh:property [ sh:path ( ex:p0 ex:p1 ) ; sh:maxCount 1 ; sh:class ex:C1 ] ,
    [ sh:path [ sh:inversePath ( ex:p2 ex:p0 ) ] ; sh:minCount 1 ] .
ex:B a sh:NodeShape ; sh:targetSubjectsOf ex:p1 ;
  sh:property [ sh:path [ sh:oneOrMorePath ex:p0 ] ; sh:disjoint ex:p2 ;
    sh:node ex:Inner ; sh:maxCount 2 ] .
ex:Inner a sh:NodeShape ; sh:closed true ; sh:ignoredProperties ( rdf:type ex:p1 ) ;
  sh:property [ sh:path ex:p0 ; sh:maxCount 1 ] .
ex:D a sh:NodeShape ; sh:targetObjectsOf ex:p2 ; sh:equals ex:p1 ;
  sh:property [ sh:path [ sh:zeroOrMorePath [ sh:alternativePath
    ( ex:p0 [ sh:inversePath ex:p1 ] ) ] ] ; sh:not [ sh:class ex:C0 ] ] ,
    ex:Q1 , ex:Q2 .
ex:Q1 sh:path ex:p0 ; sh:qualifiedValueShape ex:IsC0 ; sh:qualifiedMinCount 1 ;
  sh:qualifiedValueShapesDisjoint true .
ex:Q2 sh:path [ sh:zeroOrOnePath ex:p1 ] ; sh:qualifiedValueShape ex:HasP2 ;
  sh:qualifiedMaxCount 1 ; sh:qualifiedValueShapesDisjoint true .
ex:IsC0 a sh:NodeShape ; sh:class ex:C0 .
ex:HasP2 a sh:NodeShape ; sh:xone ( [ sh:path ex:p2 ; sh:minCount 1 ]
  [ sh:class ex:C1 ] ) .
)ttl";

constexpr char kData[] = "urn:data";
constexpr char kShapeGraph[] = "urn:shapes";

Term Ex(const std::string& local) { return Iri(kEx + local); }

class ChangesTest : public testing::Test {
 protected:
  ChangesTest() {
    Transaction transaction = store_.Begin();
    for (const auto& s : ParseTurtle(kShapes, "shapes", Iri(kShapeGraph))) {
      transaction.Add(s);
    }
    transaction.Commit(WorldChange::kYes);
    shapes_ = LoadShapes(*store_.Read(), kShapeGraph);
  }

  int Below(int n) {
    return std::uniform_int_distribution<>(0, n - 1)(random_);
  }
  Term Node() { return Ex("n" + std::to_string(Below(7))); }

  Statement RandomStatement() {
    const int predicate = Below(5);
    if (predicate == 4 && Below(8) == 0) {
      return {Ex("C1"), Iri(std::string(kRdfs) + "subClassOf"), Ex("C0"),
              Iri(kData)};
    }
    if (predicate > 2) {
      return {Node(), Iri(std::string(kRdf) + "type"),
              Ex("C" + std::to_string(Below(2))), Iri(kData)};
    }
    return {Node(), Ex("p" + std::to_string(predicate)), Node(), Iri(kData)};
  }

  // Changes the data at random; some changes undo earlier ones.
  void ChangeSomething(Transaction& transaction) {
    for (int i = Below(4); i >= 0; --i) {
      if (Below(2) == 0) {
        transaction.Add(RandomStatement());
      } else {
        const Statement s = RandomStatement();
        transaction.RemoveMatching(
            Below(2) == 0 ? nullptr : &s.subject, &s.predicate,
            Below(2) == 0 ? nullptr : &s.object, s.graph);
      }
    }
  }

  static DataGraph MakeData(const GraphView& view) {
    return {view, kData, {kData}, nullptr};
  }

  // The results as text, each with the shape that has the target.
  std::multiset<std::string> Results(const GraphView& view) const {
    std::multiset<std::string> lines;
    for (const auto& [id, shape] : shapes_) AddResults(view, shape, &lines);
    return lines;
  }

  static std::string FormatLine(const Violation& violation) {
    return violation.Line() + violation.component +
           ToTurtle(violation.source_shape);
  }

  void AddResults(const GraphView& view, const Shape& shape,
                  std::multiset<std::string>* lines,
                  const std::set<Term>* without = nullptr) const {
    const DataGraph data = MakeData(view);
    ShapeValidation validation(data, shapes_);
    for (const Term& focus : validation.FocusNodes(shape)) {
      if (without != nullptr && without->count(focus) != 0) continue;
      std::vector<Violation> found;
      validation.CheckShape(shape, focus, found);
      for (const Violation& violation : found) {
        lines->insert(FormatLine(violation));
      }
    }
  }

  std::mt19937 random_{7};
  Store store_{""};
  ShapeGraph shapes_;
};

TEST_F(ChangesTest, TouchedNodesPlusTheResultsBeforeAreAFullValidation) {
  int partial = 0, violating = 0;
  for (int round = 0; round < 1500; ++round) {
    const auto before = store_.Read();
    Transaction transaction = store_.Begin();
    ChangeSomething(transaction);
    const GraphChange change{transaction.added(), transaction.removed()};
    const DataGraph after = MakeData(transaction.view());
    const auto touched = FindTouched(after, shapes_, change);
    std::multiset<std::string> got;
    for (const auto& v : ValidateTouched(after, shapes_, change)) {
      got.insert(FormatLine(v));
    }
    if (touched) {
      ++partial;
      for (const auto& [id, nodes] : *touched) {
        AddResults(*before, shapes_.at(id), &got, &nodes);
      }
    }
    const auto want = Results(transaction.view());
    ASSERT_EQ(got, want) << "round " << round;
    violating += want.empty() ? 0 : 1;
    transaction.Commit(WorldChange::kYes);
  }
  EXPECT_GT(partial, 1000);
  EXPECT_GT(violating, 500);
}

TEST_F(ChangesTest, AChangeThatNoShapeReadsTouchesNothing) {
  Transaction transaction = store_.Begin();
  transaction.Add({Ex("n1"), Ex("other"), Ex("n2"), Iri(kData)});
  const GraphChange change{transaction.added(), transaction.removed()};
  const auto touched =
      FindTouched(MakeData(transaction.view()), shapes_, change);
  ASSERT_TRUE(touched.has_value());
  EXPECT_TRUE(touched->at(Ex("A")).empty());
}

TEST_F(ChangesTest, AChangeOfTheClassTreeTouchesEverything) {
  Transaction transaction = store_.Begin();
  transaction.Add(
      {Ex("C1"), Iri(std::string(kRdfs) + "subClassOf"), Ex("C0"), Iri(kData)});
  const GraphChange change{transaction.added(), transaction.removed()};
  EXPECT_FALSE(FindTouched(MakeData(transaction.view()), shapes_, change));
}

}  // namespace
}  // namespace kg_core::shacl
