#include <gtest/gtest.h>
#include <tendon/gcm/system_file.h>
#include <tests/support/folder.h>

namespace tendon {
namespace {

const std::string kDemo = R"({
  "version": 1,
  "name": "demo",
  "processes": [
    {"name": "robot",
     "components": [
       {"name": "arm", "class": "SimulatedArm", "library": "simulated_arm",
        "configuration": {"gain": 0.5, "limits": [1, 2]}},
       {"name": "host", "class": "HostMonitor"}
     ]},
    {"name": "desk", "components": [{"name": "teleoperation", "class": "Teleoperation"}]}
  ],
  "connections": [
    {"required": "desk/teleoperation/Robot", "provided": "robot/arm/Control"}
  ]
}
)";

/// kDemo with `from`, which occurs in it, replaced.
std::string Demo(const std::string& from, const std::string& to) {
  std::string text = kDemo;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The error that the text gives, without "demo.json: ".
std::string ErrorOf(const std::string& text) {
  const auto system = ParseSystemFile(text, "demo.json");
  if (system) return "no error";
  EXPECT_EQ(system.error().code, ErrorCode::kInvalid);
  const std::string& message = system.error().message;
  EXPECT_TRUE(message.starts_with("demo.json: ")) << message;
  return message.substr(11);
}

TEST(SystemFile, ReadsProcessesComponentsAndConnections) {
  const auto system = ParseSystemFile(kDemo, "demo.json");

  ASSERT_TRUE(system) << system.error().message;
  EXPECT_EQ(system->name, "demo");
  ASSERT_EQ(system->processes.size(), 2U);
  const auto& arm = system->processes[0].components[0];
  EXPECT_EQ(arm.name, "arm");
  EXPECT_EQ(arm.class_name, "SimulatedArm");
  EXPECT_EQ(arm.library, "simulated_arm");
  EXPECT_EQ(arm.configuration, R"({"gain":0.5,"limits":[1,2]})");
  EXPECT_EQ(system->processes[0].components[1].library, "");
  ASSERT_EQ(system->connections.size(), 1U);
  EXPECT_EQ(system->connections[0].required, InterfaceName("desk", "teleoperation", "Robot"));
  EXPECT_EQ(system->connections[0].provided, InterfaceName("robot", "arm", "Control"));
  EXPECT_EQ(system->FindProcess("desk"), &system->processes[1]);
  EXPECT_EQ(system->FindProcess("none"), nullptr);
}

TEST(SystemFile, WhatIsWrittenReadsBackTheSame) {
  const test::Folder folder;
  const auto system = ParseSystemFile(kDemo, "demo.json");
  ASSERT_TRUE(system);
  const auto file = folder.path() / "saved.json";

  ASSERT_TRUE(WriteSystemFile(file, *system));
  const auto again = ReadSystemFile(file);

  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(*again, *system);
  EXPECT_TRUE(folder.Read("saved.json").starts_with("{\n  \"version\": 1,\n  \"name\": \"demo\""));
}

TEST(SystemFile, AConfigurationThatIsNoJsonIsNotWritten) {
  const test::Folder folder;
  SystemFile system{.name = "x", .processes = {{"robot", {{"arm", "Arm", "", "{"}}}}};

  EXPECT_FALSE(WriteSystemFile(folder.path() / "x", system));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(SystemFile, SyntaxErrorsNameLineAndColumn) {
  EXPECT_EQ(ErrorOf("{\n  \"version\": 1,\n  \"name\":, }").substr(0, 32),
            "line 3, column 10: unexpected ',");
  EXPECT_EQ(ErrorOf("{\"version\": 1,}").substr(0, 33), "line 1, column 15: unexpected '}'");
  EXPECT_EQ(ErrorOf("// a comment\n{}").substr(0, 24), "line 1, column 1: invali");
  EXPECT_EQ(ErrorOf(kDemo.substr(0, 60)).find("line 5, column "), 0U);
  EXPECT_EQ(ErrorOf("{true: 1}").find("line 1, column 2: unexpected true literal"), 0U);
  EXPECT_EQ(ErrorOf(kDemo + "x").find("line 17, column 1: "), 0U);
  EXPECT_NE(ErrorOf(Demo("0.5", "1e999")).find("number overflow parsing '1e999'"),
            std::string::npos);
  EXPECT_NE(ErrorOf(Demo("\"demo\"", "\"de\xffmo\"")).find("line 3, column "), std::string::npos);
  EXPECT_NE(ErrorOf(Demo("\"demo\"", std::string("\"de\0mo\"", 7))).find("line 3, column "),
            std::string::npos);
}

TEST(SystemFile, NoErrorRepeatsBytesThatAreNoText) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string letter(1, static_cast<char>(byte));
    for (const std::string& text : {letter, "{\"" + letter + "\":1}", "{\"a" + letter + letter}) {
      for (const char shown : ErrorOf(text)) {
        const bool is_text = (shown >= 0x20 && shown < 0x7f) || static_cast<signed char>(shown) < 0;
        EXPECT_TRUE(is_text) << byte;
      }
    }
  }
}

TEST(SystemFile, AFileThatIsNoneIsSaidToBe) {
  EXPECT_EQ(ErrorOf(""), "is empty");
  EXPECT_EQ(ErrorOf(" \n"), "is empty");
  EXPECT_EQ(ErrorOf("\xef\xbb\xbf" + kDemo),
            "begins with a byte-order mark; save it as UTF-8 without one");
  EXPECT_EQ(ErrorOf("[]"), "expected an object, got a list");
  EXPECT_EQ(ErrorOf(Demo("\"version\": 1", "\"version\": 99")),
            "file is version 99, this program reads 1");
  EXPECT_EQ(ErrorOf(Demo("\"version\": 1", "\"version\": \"1\"")),
            "version: expected 1, got text '1'");
  EXPECT_EQ(ErrorOf(Demo("\"version\": 1", "\"version\": 9223372036854775808")),
            "file is version 9223372036854775808, this program reads 1");
}

TEST(SystemFile, NestingHasALimitThatIsNamed) {
  const auto nested = [](std::size_t depth) {
    return Demo("[1, 2]", std::string(depth, '[') + std::string(depth, ']'));
  };
  EXPECT_EQ(ErrorOf(nested(58)), "no error");
  EXPECT_EQ(ErrorOf(nested(59)), "nesting deeper than 64");
  EXPECT_EQ(ErrorOf(nested(1'000'000)), "nesting deeper than 64");
  EXPECT_EQ(ErrorOf(std::string(1'000'000, '[')), "nesting deeper than 64");
}

TEST(SystemFile, KeysAreCheckedWithTheirPlace) {
  EXPECT_EQ(ErrorOf(Demo("\"class\": \"HostMonitor\"", "\"class\": 7")),
            "processes[0].components[1].class: expected text, got number");
  EXPECT_EQ(ErrorOf(Demo("\"class\": \"HostMonitor\"", "\"clas\": \"HostMonitor\"")),
            "processes[0].components[1]: unknown key 'clas'; did you mean 'class'?");
  EXPECT_EQ(ErrorOf(Demo(", \"class\": \"HostMonitor\"", "")),
            "processes[0].components[1]: key 'class' is missing");
  EXPECT_EQ(ErrorOf(Demo("\"class\": \"HostMonitor\"", "\"class\": \"A\", \"class\": \"B\"")),
            "processes[0].components[1]: key 'class' occurs twice");
  EXPECT_EQ(ErrorOf(Demo("{\"gain\": 0.5", "{\"gain\": 1, \"gain\": 0.5")),
            "processes[0].components[0].configuration: key 'gain' occurs twice");
  EXPECT_EQ(ErrorOf(Demo("{\"gain\": 0.5, \"limits\": [1, 2]}", "\"fast\"")),
            "processes[0].components[0].configuration: expected an object, got text 'fast'");
  EXPECT_EQ(ErrorOf("{\"version\": 1, \"name\": \"x\"}"), "key 'processes' is missing");
  EXPECT_EQ(ErrorOf("{\"name\": \"x\", \"processes\": []}"), "key 'version' is missing");
  EXPECT_EQ(ErrorOf("{\"version\": 1, \"name\": \"x\", \"processes\": {}}"),
            "processes: expected a list, got an object");
}

TEST(SystemFile, NamesAreCheckedWithTheirPlace) {
  EXPECT_EQ(ErrorOf(Demo("\"name\": \"arm\"", "\"name\": \"a m\"")),
            "processes[0].components[0].name: component name 'a m' has ' ' at 2; allowed: letters "
            "digits _ - (max 64)");
  EXPECT_EQ(ErrorOf(Demo("\"name\": \"host\"", "\"name\": \"arm\"")),
            "processes[0].components[1].name: component 'arm' is there already");
  EXPECT_EQ(ErrorOf(Demo("\"name\": \"desk\"", "\"name\": \"robot\"")),
            "processes[1].name: process 'robot' is there already");
  EXPECT_EQ(ErrorOf(Demo("\"class\": \"HostMonitor\"", "\"class\": \"\"")),
            "processes[0].components[1].class: class name is empty");
}

TEST(SystemFile, ALibraryIsANameAndNoPath) {
  for (const std::string library : {"../../x.so", "/lib/x", "a/b", "..", "a\\\\b"}) {
    const std::string error = ErrorOf(Demo("\"simulated_arm\"", "\"" + library + "\""));
    EXPECT_EQ(error.find("processes[0].components[0].library: library '"), 0U) << error;
    EXPECT_NE(error.find("is a path; give the name alone"), std::string::npos) << error;
  }
  EXPECT_NE(ErrorOf(Demo("\"simulated_arm\"", "\"a\\u0000b\"")), "no error");
}

TEST(SystemFile, ConnectionsNameWhatTheFileHas) {
  EXPECT_EQ(ErrorOf(Demo("\"robot/arm/Control\"", "\"robot/arn/Control\"")),
            "connections[0].provided: the file has no component 'robot/arn'; did you mean 'arm'?");
  EXPECT_EQ(ErrorOf(Demo("\"desk/teleoperation/Robot\"", "\"desk2/teleoperation/Robot\"")),
            "connections[0].required: the file has no process 'desk2'; did you mean 'desk'?");
  EXPECT_EQ(ErrorOf(Demo("\"robot/arm/Control\"", "\"robot/arm\"")),
            "connections[0].provided: 'robot/arm' is no interface: expected "
            "process/component/interface");
  const std::string twice =
      "\"connections\": [{\"required\": \"desk/teleoperation/Robot\", \"provided\": "
      "\"robot/arm/Other\"},";
  EXPECT_EQ(ErrorOf(Demo("\"connections\": [", twice)),
            "connections[1].required: desk/teleoperation/Robot is connected to robot/arm/Other "
            "already");
}

TEST(SystemFile, OnlyARegularFileOfSensibleSizeIsRead) {
  const test::Folder folder;
  const auto error = [&](const std::string& name) {
    const auto system = ReadSystemFile(folder.path() / name);
    return system ? "no error" : system.error().message.substr(folder.path().string().size() + 1);
  };
  folder.Write("big", std::string(SystemFile::kMaxSize + 1, ' '));
  std::filesystem::create_directory(folder.path() / "folder");
  std::filesystem::create_symlink(folder.path() / "loop", folder.path() / "loop");

  EXPECT_EQ(error("big"), "big: is larger than 16 MB");
  EXPECT_EQ(error("folder"), "folder: is a folder, not a system file");
  EXPECT_EQ(error("none"), "none: there is no such file");
  EXPECT_NE(error("loop"), "no error");
  EXPECT_EQ(ReadSystemFile(folder.path() / "none").error().code, ErrorCode::kNotFound);
  EXPECT_NE(ReadSystemFile("/dev/null").error().message.find("no regular file"), std::string::npos);
}

}  // namespace
}  // namespace tendon
