// Files of facts that the shapes must reject: test/shacl_bad/*.ttl, each a
// small change of the test world (mission_world.h). Their first lines say
//
//   # shape: ex:TimeWindowShape     the only shape that must reject it;
//   # path: ex:confidence           path of the result; "none": the node;
//   # without: ex:w1 ex:confidence  facts removed first;
//   # repaired by: 1.2 => 0.8       the text replacement that repairs it, or
//   # repaired with: ex:w1 ...      the missing fact.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "kg_core/facts/terms.h"
#include "kg_core/shacl/shapes.h"
#include "kg_mission/mission/testing/mission_world.h"

namespace kg_mission {
namespace {

using kg_core::FactUpdate;
using kg_core::ToTurtle;

constexpr char kFolder[] = "test/shacl_bad";

struct BadFile {
  std::string name;
  std::string text;
  std::string shape;
  std::string path;
  std::vector<std::string> without;
  std::string bad, good;  // Repaired by replacing bad with good
  std::string missing;    // or by adding this.
};

// Extracts the rest of `line` if it begins with `key`.
bool Takes(const std::string& line, const std::string& key,
           std::string* value) {
  if (line.rfind(key, 0) != 0) return false;
  *value = line.substr(key.size());
  return true;
}

BadFile ReadBadFile(const std::filesystem::path& path) {
  BadFile file;
  file.name = path.filename().string();
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  file.text = text.str();
  std::string line, value;
  while (std::getline(text, line)) {
    Takes(line, "# shape: ", &file.shape);
    Takes(line, "# path: ", &file.path);
    if (Takes(line, "# without: ", &value)) file.without.push_back(value);
    Takes(line, "# repaired with: ", &file.missing);
    if (Takes(line, "# repaired by: ", &value)) {
      const std::size_t arrow = value.find(" => ");
      file.bad = value.substr(0, arrow);
      file.good = value.substr(arrow + 4);
    }
  }
  return file;
}

std::vector<BadFile> BadFiles() {
  std::vector<BadFile> files;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    files.push_back(ReadBadFile(entry.path()));
  }
  std::sort(files.begin(), files.end(),
            [](const BadFile& a, const BadFile& b) { return a.name < b.name; });
  return files;
}

FactUpdate MakeUpdate(const BadFile& file, const std::string& turtle) {
  FactUpdate update;
  update.turtle = turtle;
  for (const std::string& fact : file.without) {
    const std::size_t space = fact.find(' ');
    update.remove.push_back(
        {fact.substr(0, space), fact.substr(space + 1), ""});
  }
  return update;
}

// The repaired facts of the file, without comments.
std::string Repaired(const BadFile& file) {
  std::istringstream in(file.text);
  std::string line, body;
  while (std::getline(in, line)) {
    if (line.rfind('#', 0) != 0) body += line + "\n";
  }
  if (!file.missing.empty()) return body + file.missing;
  const std::size_t at = body.find(file.bad);
  if (at == std::string::npos) return "the repair of " + file.name;
  return body.replace(at, file.bad.size(), file.good);
}

std::string GetPath(const kg_core::Violation& violation) {
  return violation.path ? kg_core::shacl::ToTurtle(*violation.path) : "none";
}

std::string AllFacts() { return std::string(kTestFacts) + kTestArtifacts; }

// All tests share one store: nothing is committed.
class ShaclBadTest : public testing::TestWithParam<BadFile> {
 protected:
  static UpdateJudgement Judge(const FactUpdate& update) {
    static MissionWorld* const world = new MissionWorld(AllFacts());
    kg_core::Transaction transaction = world->store.Begin();
    return JudgeUpdate(update, transaction);
  }
};

TEST_P(ShaclBadTest, IsRefusedByItsShapeAlone) {
  const BadFile& file = GetParam();
  const UpdateJudgement judgement = Judge(MakeUpdate(file, file.text));
  EXPECT_FALSE(judgement.reasons.empty());
  ASSERT_TRUE(judgement.violations) << Joined(judgement.reasons);
  bool is_at_path = false;
  for (const kg_core::Violation& violation : *judgement.violations) {
    EXPECT_EQ(ToTurtle(violation.named_shape), file.shape) << violation.Line();
    EXPECT_FALSE(violation.message.empty()) << violation.Line();
    EXPECT_EQ(violation.Line().find('\n'), std::string::npos);
    is_at_path |= GetPath(violation) == file.path;
  }
  EXPECT_TRUE(is_at_path) << Joined(kg_core::Lines(*judgement.violations));
}

TEST_P(ShaclBadTest, IsTakenWhenRepaired) {
  const BadFile& file = GetParam();
  EXPECT_EQ(Joined(Judge(MakeUpdate(file, Repaired(file))).reasons), "");
}

INSTANTIATE_TEST_SUITE_P(Files, ShaclBadTest, testing::ValuesIn(BadFiles()),
                         [](const auto& info) {
                           return info.param.name.substr(
                               0, info.param.name.size() - 4);
                         });

// Checks that there is a file for every shape with a target and each of its
// properties.
TEST(ShaclBadFilesTest, ThereIsOneForEveryShapeAndProperty) {
  MissionWorld world("");
  std::set<std::pair<std::string, std::string>> tried;
  for (const BadFile& file : BadFiles()) tried.insert({file.shape, file.path});
  const auto shapes =
      kg_core::shacl::LoadShapes(*world.store.Read(), kg_core::kVocabGraph);
  int count = 0;
  for (const auto& [id, shape] : shapes) {
    for (const kg_core::shacl::Constraint& constraint : shape.constraints) {
      if (!id.is_iri() ||
          constraint.component->parameter != std::string_view("property")) {
        continue;
      }
      const std::string path =
          kg_core::shacl::ToTurtle(*shapes.at(constraint.terms.front()).path);
      EXPECT_EQ(tried.count({ToTurtle(id), path}), 1u)
          << ToTurtle(id) << " at " << path;
      ++count;
    }
  }
  EXPECT_GT(count, 150);
}

}  // namespace
}  // namespace kg_mission
