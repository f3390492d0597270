#include <gcm_console/verbs/verb.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "gcm_console/demo_fixture.h"
#include "gcm_console/output/json_schema.h"

namespace {

using nlohmann::json;

json SchemaIn(const std::filesystem::path& file) {
  return json::parse(std::ifstream(file), nullptr, false);
}

/// Returns the name of the document that a verb prints. Each subcommand of `cert` has its own
/// document.
std::string DocumentOf(const Program::Words& words) {
  return words[0] == "cert" ? "cert-" + words.at(1) : words[0];
}

/// Returns the schema file of a document in the group of its verb.
std::filesystem::path SchemaFileOf(const std::string& group, const std::string& document) {
  return std::filesystem::path(TENDON_JSON_SCHEMAS) / group / (document + ".json");
}

/// Verbs that print no JSON: they draw, print text for people, or run other verbs.
const std::set<std::string> kWithoutDocument = {"plot", "serve", "broker",    "shell",
                                                "run",  "help",  "completion"};

class OutputTest : public DemoFixture {
 protected:
  /// Expects that the first document or line of a verb with --json matches the schema with its
  /// name.
  void ExpectFits(Program::Words words) {
    const std::string document = DocumentOf(words);
    const auto verb = std::ranges::find(verbs, words[0], &console::Verb::name);
    ASSERT_NE(verb, verbs.end()) << words[0];
    words.emplace_back("--json");
    const Outcome outcome = words[0] == "events" ? Hear(words) : Gcm(words);
    ASSERT_EQ(outcome.exit_code, program::kOk) << document << ": " << outcome.err;
    const bool is_whole = outcome.out.starts_with("{\n");
    const json value = json::parse(
        is_whole ? outcome.out : outcome.out.substr(0, outcome.out.find('\n')), nullptr, false);
    ASSERT_FALSE(value.is_discarded()) << document << ": " << outcome.out;
    const json schema = SchemaIn(SchemaFileOf(verb->group, document));
    ASSERT_TRUE(schema.is_object()) << document;
    EXPECT_EQ(MisfitOf(value, schema, document), "");
    seen.insert(words[0]);
    ++documents;
  }
  /// Runs a verb that waits until the arm has reached its goal.
  [[nodiscard]] Outcome Hear(Program::Words words) const {
    words.insert(words.begin(), {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout});
    Program events(words);
    EXPECT_TRUE(EventuallyTrue([&] {
      return events.err().find("gcm: listening to ") != std::string::npos;
    })) << events.err();
    const Outcome moved = Gcm({"call", "robot/arm/Control.MoveTo", kGoal});
    EXPECT_EQ(moved.exit_code, program::kOk) << moved.err;
    const int exit_code = events.Wait().value_or(-1);
    return {.exit_code = exit_code, .out = events.out(), .err = events.err()};
  }

  /// Returns the name of a new file of the cisst component manager.
  [[nodiscard]] std::string ForeignFile() const {
    const std::string file = (home.path() / "cisst.json").string();
    std::ofstream(file) << R"({"components":
        [{"class-name": "SimulatedArm", "constructor-arg": {"Name": "arm"}}]})";
    return file;
  }

  /// Returns one command line for each verb. Each command changes the system such that the next one
  /// can succeed.
  [[nodiscard]] std::vector<Program::Words> Lines() const {
    const std::string column = "robot/arm/state.Joints.position[0]";
    const std::string saved = (home.path() / "saved.json").string();
    const std::string imported = (home.path() / "imported.json").string();
    const std::string ca = (home.path() / "ca").string();
    const std::string keys = (home.path() / "keys").string();
    const std::string run = (home.path() / "run.mcap").string();
    return {{"ls"},
            {"tree"},
            {"show", "robot/arm"},
            {"find", "Joints"},
            {"status"},
            {"graph"},
            {"get", column},
            {"watch", column, "--count", "1"},
            {"events", "robot/arm/Control.GoalReached", "--count", "1"},
            {"hz", "robot/arm/state", "--count", "1"},
            {"record", "robot/arm", "-o", run, "--for", "1s"},
            {"save-last", "5s", "robot/arm", "-o", (home.path() / "last.mcap").string()},
            {"info", run},
            {"recover", run},
            {"cut", run, "-o", (home.path() / "part.mcap").string()},
            {"export", run, "--csv", (home.path() / "csv").string()},
            {"log"},
            {"log-level", "robot", "debug"},
            {"call", "robot/arm/Control.Stop"},
            {"candidates", "desk/teleoperation/Robot"},
            {"connect", "desk/teleoperation/Robot", "robot/arm/Control"},
            {"explain", "desk/teleoperation/Robot"},
            {"save", saved},
            {"diff", saved},
            {"plan", saved},
            {"import", ForeignFile(), imported, "--process", "robot"},
            {"load", "counter", "--in", "robot"},
            {"classes", "robot"},
            {"create", "SimulatedArm", "robot/spare"},
            {"configure", "robot/spare", "--arg", "{}"},
            {"set", "robot/spare", "noise", "0.001"},
            {"undo"},
            {"history"},
            {"start", "robot/spare"},
            {"suspend", "robot/spare"},
            {"restart", "robot/spare"},
            {"stop", "robot/spare"},
            {"rm", "robot/spare"},
            {"disconnect", "desk/supervisor/Robot"},
            {"apply", saved},
            {"kill", "extra"},
            {"forget", "extra"},
            {"top"},
            {"doctor"},
            {"version"},
            {"cert", "init", "--ca", ca},
            {"cert", "issue", "anna", "--role", "viewer", "--out", keys, "--ca", ca},
            {"cert", "check", keys + "/anna.crt", "--ca", ca},
            {"cert", "revoke", "anna", "--ca", ca},
            {"replay", run, "--as", "rehearsal", "--delay", "10ms", "--to", "500ms"}};
  }

  static constexpr const char* kGoal = R"({"position": [0.1, 0, 0, -1, 0, 1, 0], "duration": 0.2})";
  const std::vector<console::Verb> verbs = console::AllVerbs();
  std::set<std::string> seen;
  std::size_t documents = 0;
};

TEST_F(OutputTest, EveryJsonDocumentMatchesItsSchema) {
  home.Write("extra.json",
             R"({"version": 1, "name": "more", "processes": [
                 {"name": "extra", "start": {}, "components": []}]})");
  const Outcome started = Gcm({"apply", (home.path() / "extra.json").string()});
  ASSERT_EQ(started.exit_code, program::kOk) << started.err;
  for (const Program::Words& words : Lines()) ExpectFits(words);

  for (const console::Verb& verb : verbs) {
    EXPECT_NE(seen.contains(verb.name), kWithoutDocument.contains(verb.name))
        << verb.name << " has neither a schema nor the reason why it needs none, or both";
  }
  std::size_t schemas = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(TENDON_JSON_SCHEMAS)) {
    if (file.is_directory()) continue;
    EXPECT_TRUE(SchemaIn(file.path()).is_object()) << file.path();
    ++schemas;
  }
  EXPECT_EQ(schemas, documents);
}

TEST_F(OutputTest, DryRunAndGlobDocumentsMatchTheirSchemas) {
  ExpectFits({"connect", "desk/teleoperation/Robot", "robot/arm/Control", "--dry-run"});
  ExpectFits({"connect", "--match", "desk/**", "robot/**", "--dry-run"});
  ExpectFits({"connect", "--match", "desk/**", "robot/**"});
  ExpectFits({"disconnect", "desk/*/Robot", "--dry-run"});
  ExpectFits({"get", "robot/*/state.Joints"});
  ExpectFits({"show", "robot/*"});
  ExpectFits({"log-level", "r*", "info", "--dry-run"});
  ExpectFits({"disconnect", "desk/teleoperation/Robot", "--dry-run"});
}

TEST_F(OutputTest, ConnectionFiguresMatchTheSchemaOfTop) {
  const Outcome top = Gcm({"--json", "top", "--connections"});
  ASSERT_EQ(top.exit_code, program::kOk) << top.err;
  const json value = json::parse(top.out, nullptr, false);

  EXPECT_EQ(MisfitOf(value, SchemaIn(std::string(TENDON_JSON_SCHEMAS) + "/look/top.json")), "");
  ASSERT_EQ(value["connections"].size(), 1U);
  EXPECT_EQ(value["connections"][0]["required"], "desk/supervisor/Robot");
  EXPECT_FALSE(value.contains("tasks"));
}

TEST(MisfitOf, NamesThePlaceOfAWrongValue) {
  const json schema = json::parse(R"({"type": "object", "required": ["a"], "properties":
      {"a": {"type": "array", "items": {"type": "string"}}}, "additionalProperties": false})");
  EXPECT_EQ(MisfitOf(json::parse(R"({"a": ["x"]})"), schema), "");
  EXPECT_EQ(MisfitOf(json::parse(R"({"a": ["x", 1]})"), schema), "document.a[1] is no string: 1");
  EXPECT_EQ(MisfitOf(json::parse("{}"), schema), "document lacks a");
  EXPECT_EQ(MisfitOf(json::parse(R"({"a": [], "b": 1})"), schema),
            "document has b, which no reader knows");
}

}  // namespace
