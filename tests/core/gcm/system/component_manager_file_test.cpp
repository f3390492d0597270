#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/gcm/system/component_manager_file.h>

namespace tendon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// An example from the documentation of cisst.
const std::string kStreamer = R"({
  "components": [
    {"shared-library": "sawSocketStreamer",
     "class-name": "mtsSocketStreamer",
     "constructor-arg": {"Name": "streamerMTML", "Period": 0.01, "IsHardRealTime": true},
     "configure-parameter": "streamerMTML.json"}
  ],
  "connections": [
    {"required": {"component": "streamerMTML", "interface": "Required"},
     "provided": {"component": "MTML", "interface": "Arm"}}
  ]
})";

std::string ImportError(const std::string& text) {
  const auto imported = ParseComponentManagerFile(text, "a.json", "robot");
  return imported ? "no error" : imported.error().message;
}

std::string Streamer(const std::string& from, const std::string& to) {
  std::string text = kStreamer;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ComponentManagerFile, ConvertsToASystemFile) {
  for (const std::string& text : {kStreamer, "{\"component-manager\": " + kStreamer + "}"}) {
    const auto imported = ParseComponentManagerFile(text, "a.json", "robot");

    ASSERT_TRUE(imported) << imported.error().message;
    const SystemFile& file = imported->file;
    ASSERT_EQ(file.processes.size(), 1U);
    EXPECT_EQ(file.processes[0].name, "robot");
    const auto* streamer = file.FindComponent("robot", "streamerMTML");
    ASSERT_NE(streamer, nullptr);
    EXPECT_EQ(streamer->class_name, "mtsSocketStreamer");
    EXPECT_EQ(streamer->library, "sawSocketStreamer");
    EXPECT_EQ(streamer->period, 0.01);
    EXPECT_EQ(streamer->comment, "configure-parameter: streamerMTML.json");
    ASSERT_NE(file.FindComponent("robot", "MTML"), nullptr);
    // The program of the process creates this component.
    EXPECT_EQ(file.FindComponent("robot", "MTML")->class_name, "");
    EXPECT_THAT(file.connections,
                ElementsAre(SystemFile::Connection{{"robot", "streamerMTML", "Required"},
                                                   {"robot", "MTML", "Arm"}}));
    EXPECT_THAT(imported->left_out,
                ElementsAre(HasSubstr("IsHardRealTime is left out"),
                            HasSubstr("write the content of 'streamerMTML.json'")));

    const auto written = SystemFileText(file);
    ASSERT_TRUE(written);
    const auto again = ParseSystemFile(*written, "b");
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(*again, file);
  }
}

TEST(ComponentManagerFile, ReportsComponentsWithoutAPlugIn) {
  const auto imported = ParseComponentManagerFile(
      Streamer("\"shared-library\": \"sawSocketStreamer\",", ""), "a.json", "robot");

  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_THAT(
      imported->left_out,
      testing::Contains(
          "components[0] has no \"shared-library\": write the name of the plug-in that has class "
          "mtsSocketStreamer into \"library\""));
}

TEST(ComponentManagerFile, AJsonParameterBecomesTheConfiguration) {
  const auto imported = ParseComponentManagerFile(
      Streamer("\"streamerMTML.json\"", R"("{\"port\": 5}")"), "a.json", "robot");

  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->file.processes[0].components[0].configuration, R"({"port":5})");
}

TEST(ComponentManagerFile, AConnectionMayNameItsProcesses) {
  const auto imported = ParseComponentManagerFile(
      Streamer(R"({"component": "MTML")", R"({"process": "arms", "component": "MTML")"), "a.json",
      "robot");

  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->file.connections[0].provided, InterfaceName("arms", "MTML", "Arm"));
  EXPECT_NE(imported->file.FindComponent("arms", "MTML"), nullptr);
}

TEST(ComponentManagerFile, MayHaveComments) {
  const std::string commented = "/* a robot\n * of two \"arms\" */\n" +
                                Streamer("\"connections\"", "// who uses whom\n\"connections\"") +
                                "\n// the end";

  const auto imported = ParseComponentManagerFile(commented, "a.json", "robot");

  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->file, ParseComponentManagerFile(kStreamer, "a.json", "robot")->file);
  const auto quoted = ParseComponentManagerFile(
      Streamer("streamerMTML.json", R"(/*a\"//b*/ http://c)"), "a.json", "robot");
  ASSERT_TRUE(quoted) << quoted.error().message;
  EXPECT_EQ(quoted->file.processes[0].components[0].comment,
            "configure-parameter: /*a\"//b*/ http://c");
}

TEST(ComponentManagerFile, ErrorPositionsAreRightAfterComments) {
  EXPECT_EQ(ImportError("/* one\ntwo */ {\"component\": []}"),
            "a.json: line 2, column 9: unknown key 'component'; did you mean 'components'?");
  EXPECT_EQ(ImportError("{/**/\"component\": []}"),
            "a.json: line 1, column 6: unknown key 'component'; did you mean 'components'?");
  EXPECT_THAT(ImportError("{/* \"components\": []}"), HasSubstr("a.json: line 1, column 2: "));
  EXPECT_THAT(ImportError("{/}"), HasSubstr("a.json: line 1, column 2: "));
}

TEST(ComponentManagerFile, ReportsOtherSectionsAsLeftOut) {
  const auto imported = ParseComponentManagerFile(
      R"({"io": {"port": "udp"}, "console-inputs": {}, "component-manager": )" + kStreamer + "}",
      "console.json", "robot");

  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_NE(imported->file.FindComponent("robot", "streamerMTML"), nullptr);
  ASSERT_EQ(imported->left_out.size(), 4U);
  EXPECT_THAT(imported->left_out[0], HasSubstr("console-inputs is left out"));
  EXPECT_THAT(imported->left_out[1], HasSubstr("io is left out"));
}

TEST(ComponentManagerFile, ReportsClassSpecificKeysAsLeftOut) {
  const auto imported = ParseComponentManagerFile(
      Streamer("\"Period\": 0.01", R"("Period": 0.01, "Arg": "/dev/tty", "Nane": 1)"), "a.json",
      "robot");

  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->file.FindComponent("robot", "streamerMTML")->period, 0.01);
  ASSERT_EQ(imported->left_out.size(), 4U);
  EXPECT_EQ(imported->left_out[0],
            "components[0].constructor-arg.Arg is left out: only the class of the component can "
            "read this key; write the value into \"configuration\"");
  EXPECT_THAT(imported->left_out[1], HasSubstr("did you mean 'Name'?"));
}

TEST(ComponentManagerFile, ErrorsNameLineColumnAndPath) {
  EXPECT_EQ(ImportError(Streamer("\"class-name\"", "\"class-nam\"")),
            "a.json: line 4, column 6: components[0]: unknown key 'class-nam'; did you mean "
            "'class-name'?");
  EXPECT_EQ(ImportError(Streamer("\"Period\": 0.01", "\"Period\": \"10ms\"")),
            "a.json: line 5, column 50: components[0].constructor-arg.Period: expected number "
            "(seconds), got string '10ms'");
  EXPECT_THAT(
      ImportError(Streamer("\"streamerMTML\", \"Period", "\"streamer MTML\", \"Period")),
      HasSubstr("components[0].constructor-arg.Name: component name 'streamer MTML' has ' '"));
  EXPECT_THAT(ImportError(Streamer("\"sawSocketStreamer\"", "\"/usr/lib/x.so\"")),
              HasSubstr("components[0].shared-library: library '/usr/lib/x.so' is a path"));
  EXPECT_EQ(ImportError(Streamer("\"Period\": 0.01", "\"Period\": -1")),
            "a.json: line 5, column 50: components[0].constructor-arg.Period: period must be 10 "
            "us..3600 s, got -1");
  EXPECT_EQ(ImportError(Streamer("\"Period\": 0.01", "\"Period\": 0")), "no error");
  EXPECT_EQ(ImportError("{\"component\": []}"),
            "a.json: line 1, column 2: unknown key 'component'; did you mean 'components'?");
  EXPECT_THAT(ImportError("{"), HasSubstr("a.json: line 1, column 2: "));
}

}  // namespace
}  // namespace tendon
