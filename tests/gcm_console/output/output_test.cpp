#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gcm_console/demo_fixture.h"
#include "gcm_console/output/json_schema.h"

namespace {

using nlohmann::json;

json SchemaIn(const std::filesystem::path& file) {
  return json::parse(std::ifstream(file), nullptr, false);
}

class OutputTest : public DemoFixture {
 protected:
  /// The first document or line that a verb prints with --json fits the schema of its name.
  void ExpectFits(Program::Words words) const {
    const std::string verb = words[0];
    words.emplace_back("--json");
    const Outcome outcome = Gcm(words);
    ASSERT_EQ(outcome.exit_code, program::kOk) << verb << ": " << outcome.err;
    const bool is_document = outcome.out.starts_with("{\n");
    const json value = json::parse(
        is_document ? outcome.out : outcome.out.substr(0, outcome.out.find('\n')), nullptr, false);
    ASSERT_FALSE(value.is_discarded()) << verb << ": " << outcome.out;
    const json schema = SchemaIn(std::filesystem::path(TENDON_JSON_SCHEMAS) / (verb + ".json"));
    ASSERT_TRUE(schema.is_object()) << verb;
    EXPECT_EQ(MisfitOf(value, schema, verb), "");
  }
};

TEST_F(OutputTest, EveryDocumentFitsItsSchema) {
  const std::string column = "robot/arm/state.Joints.position[0]";
  const std::vector<Program::Words> lines = {
      {"ls"},
      {"show", "robot/arm"},
      {"find", "Joints"},
      {"status"},
      {"graph"},
      {"get", column},
      {"watch", column, "--count", "1"},
      {"hz", "robot/arm/state", "--count", "1"},
      {"log"},
      {"candidates", "desk/teleoperation/Robot"},
      {"connect", "desk/teleoperation/Robot", "robot/arm/Control"},
      {"explain", "desk/teleoperation/Robot"},
      {"undo"},
      {"history"},
      {"classes", "robot"},
      {"stop", "robot/arm"},
      {"disconnect", "desk/supervisor/Robot"},
      {"top"},
      {"doctor"},
      {"version"}};

  for (const Program::Words& words : lines) ExpectFits(words);

  std::size_t schemas = 0;
  for (const auto& file : std::filesystem::directory_iterator(TENDON_JSON_SCHEMAS)) {
    EXPECT_TRUE(SchemaIn(file.path()).is_object()) << file.path();
    ++schemas;
  }
  EXPECT_EQ(schemas, lines.size());
}

TEST(MisfitOf, SaysWhereAValueIsWrong) {
  const json schema = json::parse(R"({"type": "object", "required": ["a"], "properties":
      {"a": {"type": "array", "items": {"type": "string"}}}, "additionalProperties": false})");
  EXPECT_EQ(MisfitOf(json::parse(R"({"a": ["x"]})"), schema), "");
  EXPECT_EQ(MisfitOf(json::parse(R"({"a": ["x", 1]})"), schema), "document.a[1] is no string: 1");
  EXPECT_EQ(MisfitOf(json::parse("{}"), schema), "document lacks a");
  EXPECT_EQ(MisfitOf(json::parse(R"({"a": [], "b": 1})"), schema),
            "document has b, which no reader knows");
}

}  // namespace
