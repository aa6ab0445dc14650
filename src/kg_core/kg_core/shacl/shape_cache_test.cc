// Caching of shapes between validations.

#include "kg_core/shacl/shape_cache.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"

namespace kg_core::shacl {
namespace {

constexpr char kShapeGraph[] = "urn:shapes";

class ShapeCacheTest : public testing::Test {
 protected:
  std::vector<Statement> Read(const std::string& turtle) {
    return ParseTurtle(turtle, "shapes", Iri(kShapeGraph));
  }
  void Add(const std::string& turtle) {
    Transaction transaction = store_.Begin();
    for (const Statement& s : Read(turtle)) transaction.Add(s);
    transaction.Commit(WorldChange::kYes);
  }
  void Remove(const std::string& turtle) {
    Transaction transaction = store_.Begin();
    for (const Statement& s : Read(turtle)) transaction.Remove(s);
    transaction.Commit(WorldChange::kYes);
  }
  auto Get() { return cache_.Get(*store_.Read(), kShapeGraph); }

  Store store_{""};
  ShapeCache cache_;
};

TEST_F(ShapeCacheTest, KeepsShapesWhileTheirGraphStaysAsItIs) {
  Add("ex:S a sh:NodeShape ; sh:class ex:C .");
  const auto first = Get();
  Transaction transaction = store_.Begin();
  transaction.Add({Iri("urn:a"), Iri("urn:b"), Iri("urn:c"), Iri("urn:d")});
  transaction.Commit(WorldChange::kYes);
  EXPECT_EQ(Get(), first);
  EXPECT_EQ(first->size(), 1u);
}

TEST_F(ShapeCacheTest, ReadsShapesAgainAfterAnyChangeOfTheirGraph) {
  EXPECT_TRUE(Get()->empty());
  Add("ex:S a sh:NodeShape ; sh:class ex:C .");
  EXPECT_EQ(Get()->size(), 1u);
  Add("ex:T a sh:NodeShape ; sh:class ex:D .");
  EXPECT_EQ(Get()->size(), 2u);
  Remove("ex:T a sh:NodeShape ; sh:class ex:D .");
  EXPECT_EQ(Get()->size(), 1u);
  Remove("ex:S sh:class ex:C .");
  Add("ex:S sh:class ex:D .");
  EXPECT_EQ(Get()->begin()->second.constraints.at(0).terms.at(0).text,
            kEx + std::string("D"));
}

TEST_F(ShapeCacheTest, RefusesIllFormedShapesEveryTime) {
  Add("ex:S a sh:NodeShape ; sh:minCount 1 .");
  EXPECT_THROW(Get(), kg_base::InputError);
  EXPECT_THROW(Get(), kg_base::InputError);
}

TEST_F(ShapeCacheTest, DistinguishesTwoStores) {
  Add("ex:S a sh:NodeShape ; sh:class ex:C .");
  EXPECT_EQ(Get()->begin()->first.text, kEx + std::string("S"));
  Store other("");
  Transaction transaction = other.Begin();
  for (const Statement& s : Read("ex:T a sh:NodeShape ; sh:class ex:C .")) {
    transaction.Add(s);
  }
  transaction.Commit(WorldChange::kYes);
  EXPECT_EQ(cache_.Get(*other.Read(), kShapeGraph)->begin()->first.text,
            kEx + std::string("T"));
}

}  // namespace
}  // namespace kg_core::shacl
