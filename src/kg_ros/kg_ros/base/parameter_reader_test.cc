#include "kg_ros/base/parameter_reader.h"

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"

namespace kg_ros {
namespace {

ParameterReader MakeReader() {
  XmlRpc::XmlRpcValue block;
  block["deadline_s"] = 3;
  block["agent"] = "alpha";
  block["once"] = true;
  return ParameterReader("/planner_alpha", block);
}

TEST(ParameterReaderTest, ReadsBoundedValuesAndFallbacks) {
  ParameterReader read = MakeReader();
  EXPECT_EQ(read.Number("deadline_s", {0.1, 10.0}, 1.0), 3.0);
  EXPECT_EQ(read.Number("rate", {0.0, 10.0}, 2.5), 2.5);
  EXPECT_EQ(read.Text("agent"), "alpha");
  EXPECT_TRUE(read.Boolean("once", false));
  EXPECT_TRUE(read.Boolean("sim", true));
  EXPECT_NO_THROW(read.RefuseTheRest());
}

TEST(ParameterReaderTest, RefusesAnOutlierByName) {
  ParameterReader read = MakeReader();
  try {
    read.Number("deadline_s", {5.0, 6.0}, 5.0);
    FAIL() << "accepted";
  } catch (const kg_base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/planner_alpha/deadline_s"),
              std::string::npos);
  }
}

TEST(ParameterReaderTest, RefusesTheWrongType) {
  EXPECT_THROW(MakeReader().Integer("agent", {0, 1}, 0), kg_base::InputError);
  EXPECT_THROW(MakeReader().Text("deadline_s", ""), kg_base::InputError);
  EXPECT_THROW(MakeReader().Boolean("deadline_s", true), kg_base::InputError);
}

TEST(ParameterReaderTest, RefusesAnUnknownKey) {
  ParameterReader read = MakeReader();
  read.Text("agent");
  EXPECT_THROW(read.RefuseTheRest(), kg_base::InputError);
}

TEST(ParameterReaderTest, RefusesAMissingText) {
  EXPECT_THROW(MakeReader().Text("state_folder"), kg_base::InputError);
}

}  // namespace
}  // namespace kg_ros
