#include "kg_mission/mission/option_names.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace kg_mission {
namespace {

// The lists of names that the shapes allow for a property, as written.
std::vector<std::string> ListsInShapes(const std::string& property) {
  std::ifstream file("ontology/shapes.ttl");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const std::regex list("sh:path " + property +
                        " ;[^\\]]*sh:in \\( ([^)]*) \\)");
  std::vector<std::string> lists;
  for (std::sregex_iterator at(text.begin(), text.end(), list), end; at != end;
       ++at) {
    lists.push_back((*at)[1]);
  }
  return lists;
}

template <typename Names>
void ExpectInShapes(const std::string& property, const Names& names,
                    std::size_t shapes) {
  std::string wanted;
  for (const char* name : names) {
    wanted += (wanted.empty() ? "\"" : " \"") + std::string(name) + "\"";
  }
  EXPECT_EQ(ListsInShapes(property), std::vector<std::string>(shapes, wanted))
      << property;
}

TEST(OptionNames, AreThoseThatTheShapesAllow) {
  ExpectInShapes("ex:teamMode", kTeamModeNames, 2);  // Mission and plan run.
  ExpectInShapes("ex:fairness", kFairnessNames, 1);
  ExpectInShapes("ex:movementMode", kMovementModeNames, 2);  // And NavGraph.
}

}  // namespace
}  // namespace kg_mission
