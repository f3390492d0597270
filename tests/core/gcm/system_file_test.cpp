#include <gmock/gmock.h>
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

/// Returns kDemo with `from` replaced by `to`. `from` must occur in kDemo.
std::string Demo(const std::string& from, const std::string& to) {
  std::string text = kDemo;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// Returns the error for this text, without "demo.json: ".
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

TEST(SystemFile, ReadsThreadsStatesAndLayout) {
  const auto system = ParseSystemFile(
      Demo("\"class\": \"HostMonitor\"}\n     ]}",
           R"("class": "HostMonitor", "period": 0.5, "state": "suspended", "comment": "slow",
              "thread": {"policy": "fifo", "priority": 40}},
             {"name": "own", "class": null}], "comment": "of the lab"})"),
      "demo.json");

  ASSERT_TRUE(system) << system.error().message;
  const auto* host = system->FindComponent("robot", "host");
  ASSERT_NE(host, nullptr);
  EXPECT_EQ(host->period, 0.5);
  EXPECT_EQ(host->state, ComponentState::kSuspended);
  EXPECT_EQ(host->comment, "slow");
  ThreadOptions thread;
  thread.policy = SchedulingPolicy::kFifo;
  thread.priority = 40;
  EXPECT_EQ(host->thread, thread);
  EXPECT_EQ(system->FindComponent("robot", "own")->class_name, "");
  EXPECT_EQ(system->FindComponent("robot", "arm")->state, ComponentState::kActive);
  EXPECT_EQ(system->processes[0].comment, "of the lab");

  const auto drawn = ParseSystemFile(
      Demo("\"connections\": [", R"("layout": {"robot/arm": [12, -3.5]}, "connections": [)"), "x");
  ASSERT_TRUE(drawn) << drawn.error().message;
  EXPECT_EQ(drawn->layout.at("robot/arm"), (SystemFile::Position{12, -3.5}));
}

TEST(SystemFile, ChecksTheKeysOfAComponent) {
  const auto error = [](const std::string& member) {
    const std::string text = ErrorOf(Demo("\"HostMonitor\"", "\"HostMonitor\", " + member));
    const std::string place = "line 9, column 49: processes[0].components[1]";
    EXPECT_TRUE(text.starts_with(place)) << text;
    return text.substr(std::min(place.size(), text.size()));
  };

  EXPECT_EQ(error(R"("period": "1ms")"), ".period: expected number (seconds), got string '1ms'");
  EXPECT_EQ(error(R"("preiod": 1)"), ": unknown key 'preiod'; did you mean 'period'?");
  EXPECT_EQ(error(R"("period": 0)"), ".period: period must be 10 us..3600 s, got 0");
  EXPECT_EQ(error(R"("period": -0.0)"), ".period: period must be 10 us..3600 s, got -0.0");
  EXPECT_EQ(error(R"("period": 9223372036854775808)"),
            ".period: period must be 10 us..3600 s, got 9223372036854775808");
  EXPECT_EQ(
      error(R"("state": "activ")"),
      ".state: expected one of active, suspended, finished, constructed, got 'activ'; did you "
      "mean 'active'?");
  EXPECT_EQ(error(R"("state": "faulted")"),
            ".state: expected one of active, suspended, finished, constructed, got 'faulted'");
  EXPECT_EQ(error(R"("thread": 7)"), ".thread: expected an object, got number");
  EXPECT_THAT(error(R"("thread": {"policy": "fifi"})"), testing::HasSubstr("policy"));
  EXPECT_THAT(error(R"("thread": {"policy": "fifo", "priority": 400})"),
              testing::HasSubstr("priority"));
  EXPECT_THAT(ErrorOf(Demo("\"HostMonitor\"", R"("HostMonitor", "thread": {"polcy": "fifo"})")),
              testing::HasSubstr("thread: unknown key 'polcy'; did you mean 'policy'?"));
}

std::string WithStart(const std::string& start, const std::string& component = "") {
  return R"({"version": 1, "name": "x", "processes": [{"name": "a", "start": )" + start +
         R"(, "components": [)" + component + "]}]}";
}

TEST(SystemFile, ReadsHowTheGcmStartsProcesses) {
  const auto never = ParseSystemFile(WithStart("{}"), "x");
  const auto again = ParseSystemFile(WithStart(R"({"restart": "on-failure"})"), "x");

  ASSERT_TRUE(never && again);
  EXPECT_EQ(never->processes[0].start, SystemFile::Start{RestartPolicy::kNever});
  EXPECT_EQ(again->processes[0].start, SystemFile::Start{RestartPolicy::kOnFailure});
  for (const auto& system : {*never, *again}) {
    EXPECT_EQ(*ParseSystemFile(*SystemFileText(system), "x"), system);
  }
}

TEST(SystemFile, ReadsWhetherItIsStrict) {
  const auto strict = [](const std::string& value) {
    return Demo("\"connections\": [", "\"strict\": " + value + ", \"connections\": [");
  };

  EXPECT_TRUE(ParseSystemFile(strict("true"), "x")->strict);
  EXPECT_FALSE(ParseSystemFile(strict("false"), "x")->strict);
  EXPECT_FALSE(ParseSystemFile(Demo("\"connections\": [", "\"connections\": ["), "x")->strict);
  EXPECT_TRUE(ErrorOf(strict("1")).ends_with("strict: expected true or false, got number"))
      << ErrorOf(strict("1"));
}

TEST(SystemFile, ChecksHowAProcessIsStarted) {
  EXPECT_THAT(ErrorOf(WithStart("true")),
              testing::EndsWith("processes[0].start: expected an object, got true or false"));
  EXPECT_THAT(ErrorOf(WithStart(R"({"program": "/bin/sh"})")),
              testing::EndsWith("processes[0].start: unknown key 'program'"));
  EXPECT_THAT(
      ErrorOf(WithStart(R"({"restart": "on-failur"})")),
      testing::EndsWith("processes[0].start.restart: expected one of never, on-failure, got "
                        "'on-failur'; did you mean 'on-failure'?"));
  EXPECT_THAT(
      ErrorOf(WithStart("{}", R"({"name": "b", "class": null})")),
      testing::EndsWith(
          "processes[0].start: the GCM starts this process as an lcm, but an lcm cannot create a "
          "component without a class: remove \"start\", or give each component a class"));
}

TEST(SystemFile, AComponentWithoutAClassTakesNoLibrary) {
  EXPECT_THAT(ErrorOf(Demo("\"SimulatedArm\"", "null")),
              testing::HasSubstr(
                  "library: a component without a class is created by the program of the process"));
}

TEST(SystemFile, TheLayoutNamesComponentsOfTheFile) {
  const auto error = [](const std::string& layout) {
    const std::string text =
        ErrorOf(Demo("\"connections\": [", "\"layout\": " + layout + ", \"connections\": ["));
    const std::size_t begin = text.find("layout");
    return begin == text.npos ? text : text.substr(begin);
  };

  EXPECT_EQ(error("[]"), "layout: expected an object, got a list");
  EXPECT_EQ(error(R"({"arm": [1, 2]})"),
            "layout.arm: 'arm' is not a component: expected process/component");
  EXPECT_EQ(error(R"({"robot/arn": [1, 2]})"),
            "layout.robot/arn: the file has no component 'robot/arn'; did you mean 'arm'?");
  EXPECT_EQ(error(R"({"robot/arm": [1]})"), "layout.robot/arm: expected [x, y], got a list");
}

TEST(SystemFile, AWrittenFileReadsBackEqual) {
  const test::Folder folder;
  auto system = ParseSystemFile(kDemo, "demo.json");
  ASSERT_TRUE(system);
  system->comment = "two robots";
  system->layout["robot/arm"] = {0.5, 1e6};
  system->strict = true;
  system->connections[0].comment = "by hand";
  auto& arm = system->processes[0].components[0];
  arm.period = 0.001;
  arm.thread.emplace().cpus = {0};
  arm.state = ComponentState::kConstructed;
  system->processes[0].components.push_back(
      {.name = "own", .class_name = "", .library = "", .configuration = ""});
  const auto file = folder.path() / "saved.json";

  ASSERT_TRUE(WriteSystemFile(file, *system));
  const auto again = ReadSystemFile(file);

  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(*again, *system);
  EXPECT_TRUE(folder.Read("saved.json").starts_with("{\n  \"version\": 1,\n  \"name\": \"demo\""));
}

TEST(SystemFile, RefusesToWriteAnInvalidConfiguration) {
  const test::Folder folder;
  SystemFile system{.name = "x", .processes = {{"robot", {{"arm", "Arm", "", "{"}}}}};

  EXPECT_FALSE(WriteSystemFile(folder.path() / "x", system));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(SystemFile, RefusesToWriteUnreadableFiles) {
  const auto error = [](const std::string& configuration) {
    const SystemFile system{.name = "x",
                            .processes = {{"robot", {{"arm", "Arm", "", configuration}}}}};
    const auto text = SystemFileText(system);
    return text ? "no error" : text.error().message;
  };
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');

  EXPECT_EQ(error(R"({"gain": 1})"), "no error");
  EXPECT_THAT(error("{"), testing::HasSubstr("the configuration of robot/arm: line 1, column 2: "));
  EXPECT_THAT(error(deep), testing::HasSubstr("nesting deeper than 64"));
  EXPECT_THAT(error("7"), testing::HasSubstr("configuration: expected an object, got number"));
  EXPECT_THAT(error("{\"a\": \"" + std::string(SystemFile::kMaxConfiguration, 'x') + "\"}"),
              testing::HasSubstr("configuration: expected a configuration of at most 65536 bytes"));
}

TEST(SystemFile, KeepsAConfigurationInAsciiButWritesItReadably) {
  const std::string umlaut = "\xc3\xa4";
  const auto system = ParseSystemFile(Demo("\"gain\": 0.5", "\"gain\": \"" + umlaut + "\""), "x");

  ASSERT_TRUE(system) << system.error().message;
  EXPECT_EQ(system->processes[0].components[0].configuration,
            R"({"gain":"\u00e4","limits":[1,2]})");
  const auto text = SystemFileText(*system);
  ASSERT_TRUE(text);
  EXPECT_NE(text->find(umlaut), text->npos);
}

TEST(SystemFile, ALargeConfigurationIsRefusedWithItsPosition) {
  const auto of_size = [](std::size_t size) {  // the size in the stored form
    const std::string rest = R"({"gain":"","limits":[1,2]})";
    return Demo("0.5", "\"" + std::string(size - rest.size(), 'x') + "\"");
  };
  constexpr std::size_t kMax = 65'536;

  EXPECT_EQ(ErrorOf(of_size(kMax)), "no error");
  EXPECT_EQ(ErrorOf(of_size(kMax + 1)),
            "line 8, column 9: processes[0].components[0].configuration: expected a configuration "
            "of at most 65536 bytes, got 65537");
}

TEST(SystemFile, ReadsThousandsOfComponents) {
  constexpr std::size_t kComponents = 10'000;  // half of the components are in separate processes
  std::string processes;
  std::string components;
  std::string connections;
  for (std::size_t i = 0; i < kComponents / 2; ++i) {
    const std::string name = std::to_string(i);
    const std::string component = R"({"name": "c)" + name + R"(", "class": "Arm"})";
    const std::string comma = i == 0 ? "" : ",\n";
    components += comma + component;
    processes += ",\n" + (R"({"name": "p)" + name + R"(", "components": [)" + component + "]}");
    connections += comma + R"({"required": "robot/c)" + name + R"(/Robot", "provided": "p)" + name +
                   "/c" + name + R"(/Control"})";
  }
  const std::string text = R"({"version": 1, "name": "large", "processes": [
      {"name": "robot", "components": [)" +
                           components + "]}" + processes + R"(], "connections": [)" + connections +
                           "]}";

  const auto system = ParseSystemFile(text, "large");

  ASSERT_TRUE(system) << system.error().message;
  EXPECT_EQ(system->processes.size(), kComponents / 2 + 1);
  EXPECT_EQ(system->processes[0].components.size(), kComponents / 2);
  EXPECT_EQ(system->connections.size(), kComponents / 2);
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

TEST(SystemFile, RefusesOrKeepsOddNumbersAndTexts) {
  EXPECT_EQ(ErrorOf(Demo("0.5", "NaN")).find("line 8, column 35: invalid literal"), 0U);
  EXPECT_EQ(ErrorOf(Demo("0.5", "9223372036854775808")), "no error");
  EXPECT_EQ(ErrorOf(Demo("0.5", "-0")), "no error");
  const std::string overlong = "\"de\xc0\xafmo\"";  // an overlong encoding: '/' in two bytes
  EXPECT_EQ(ErrorOf(Demo("\"demo\"", overlong)).find("line 3, column "), 0U);
}

TEST(SystemFile, ErrorsContainOnlyPrintableText) {
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

TEST(SystemFile, ReportsFilesThatAreNotSystemFiles) {
  EXPECT_EQ(ErrorOf(""), "is empty");
  EXPECT_EQ(ErrorOf(" \n"), "is empty");
  EXPECT_EQ(ErrorOf("\xef\xbb\xbf" + kDemo),
            "begins with a byte-order mark; save the text as UTF-8 without this mark");
  EXPECT_EQ(ErrorOf("[]"), "line 1, column 1: expected an object, got a list");
  EXPECT_EQ(ErrorOf(Demo("\"version\": 1", "\"version\": 99")),
            "line 2, column 3: the file has version 99, but this program reads version 1");
  EXPECT_EQ(ErrorOf(Demo("\"version\": 1", "\"version\": \"1\"")),
            "line 2, column 3: version: expected 1, got string '1'");
  EXPECT_EQ(ErrorOf(Demo("\"version\": 1", "\"version\": 9223372036854775808")),
            "line 2, column 3: the file has version 9223372036854775808, but this program reads "
            "version 1");
}

TEST(SystemFile, RefusesDeepNesting) {
  const auto nested = [](std::size_t depth) {
    return Demo("[1, 2]", std::string(depth, '[') + std::string(depth, ']'));
  };
  EXPECT_EQ(ErrorOf(nested(58)), "no error");
  EXPECT_EQ(ErrorOf(nested(59)), "nesting deeper than 64");
  EXPECT_EQ(ErrorOf(nested(1'000'000)), "nesting deeper than 64");
  EXPECT_EQ(ErrorOf(std::string(1'000'000, '[')), "nesting deeper than 64");
}

TEST(SystemFile, KeyErrorsNameTheirPosition) {
  EXPECT_EQ(ErrorOf(Demo("\"class\": \"HostMonitor\"", "\"class\": 7")),
            "line 9, column 25: processes[0].components[1].class: expected string, got number");
  EXPECT_EQ(
      ErrorOf(Demo("\"class\": \"HostMonitor\"", "\"clas\": \"HostMonitor\"")),
      "line 9, column 25: processes[0].components[1]: unknown key 'clas'; did you mean 'class'?");
  EXPECT_EQ(ErrorOf(Demo(", \"class\": \"HostMonitor\"", "")),
            "line 9, column 8: processes[0].components[1]: key 'class' is missing");
  EXPECT_EQ(ErrorOf(Demo("\"class\": \"HostMonitor\"", "\"class\": \"A\", \"class\": \"B\"")),
            "line 9, column 39: processes[0].components[1]: key 'class' occurs twice");
  EXPECT_EQ(ErrorOf(Demo("{\"gain\": 0.5", "{\"gain\": 1, \"gain\": 0.5")),
            "line 8, column 38: processes[0].components[0].configuration: key 'gain' occurs twice");
  EXPECT_EQ(ErrorOf(Demo("{\"gain\": 0.5, \"limits\": [1, 2]}", "\"fast\"")),
            "line 8, column 9: processes[0].components[0].configuration: expected an object, got "
            "string 'fast'");
  EXPECT_EQ(ErrorOf("{\"version\": 1, \"name\": \"x\"}"),
            "line 1, column 1: key 'processes' is missing");
  EXPECT_EQ(ErrorOf("{\"name\": \"x\", \"processes\": []}"),
            "line 1, column 1: key 'version' is missing");
  EXPECT_EQ(ErrorOf("{\"version\": 1, \"name\": \"x\", \"processes\": {}}"),
            "line 1, column 29: processes: expected a list, got an object");
}

TEST(SystemFile, NameErrorsNameTheirPosition) {
  EXPECT_EQ(ErrorOf(Demo("\"name\": \"arm\"", "\"name\": \"a m\"")),
            "line 7, column 9: processes[0].components[0].name: component name 'a m' has ' ' at 2; "
            "allowed: letters "
            "digits _ - (max 64)");
  EXPECT_EQ(ErrorOf(Demo("\"name\": \"host\"", "\"name\": \"arm\"")),
            "line 9, column 9: processes[0].components[1].name: component 'arm' already exists");
  EXPECT_EQ(ErrorOf(Demo("\"name\": \"desk\"", "\"name\": \"robot\"")),
            "line 11, column 6: processes[1].name: process 'robot' already exists");
  EXPECT_EQ(ErrorOf(Demo("\"class\": \"HostMonitor\"", "\"class\": \"a\\u001bb\"")),
            "line 9, column 25: processes[0].components[1].class: class name 'a\\x1bb' has a "
            "character that is not allowed in names");
  EXPECT_EQ(ErrorOf(Demo("\"class\": \"HostMonitor\"", "\"class\": \"\"")),
            "line 9, column 25: processes[0].components[1].class: class name is empty");
}

TEST(SystemFile, ALibraryIsANameNotAPath) {
  for (const std::string library : {"../../x.so", "/lib/x", "a/b", "..", "a\\\\b"}) {
    const std::string error = ErrorOf(Demo("\"simulated_arm\"", "\"" + library + "\""));
    EXPECT_EQ(error.find("line 7, column 49: processes[0].components[0].library: library '"), 0U)
        << error;
    EXPECT_NE(error.find("is a path; give only the name"), std::string::npos) << error;
  }
  EXPECT_NE(ErrorOf(Demo("\"simulated_arm\"", "\"a\\u0000b\"")), "no error");
}

TEST(SystemFile, ConnectionsNameInterfacesOfTheFile) {
  EXPECT_EQ(ErrorOf(Demo("\"robot/arm/Control\"", "\"robot/arn/Control\"")),
            "line 14, column 46: connections[0].provided: the file has no component 'robot/arn'; "
            "did you mean 'arm'?");
  EXPECT_EQ(ErrorOf(Demo("\"desk/teleoperation/Robot\"", "\"desk2/teleoperation/Robot\"")),
            "line 14, column 6: connections[0].required: the file has no process 'desk2'; did you "
            "mean 'desk'?");
  EXPECT_EQ(
      ErrorOf(Demo("\"robot/arm/Control\"", "\"robot/arm\"")),
      "line 14, column 46: connections[0].provided: 'robot/arm' is not an interface: expected "
      "process/component/interface");
  const std::string twice =
      "\"connections\": [{\"required\": \"desk/teleoperation/Robot\", \"provided\": "
      "\"robot/arm/Other\"},";
  EXPECT_EQ(ErrorOf(Demo("\"connections\": [", twice)),
            "line 14, column 6: connections[1].required: desk/teleoperation/Robot is connected to "
            "robot/arm/Other "
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

  EXPECT_EQ(error("big"), "big: the file is larger than 16 MB");
  EXPECT_EQ(error("folder"), "folder: is a folder, not a file");
  EXPECT_EQ(error("none"), "none: there is no such file");
  EXPECT_EQ(error("loop"), "loop: Too many levels of symbolic links");
  EXPECT_EQ(ReadSystemFile(folder.path() / "none").error().code, ErrorCode::kNotFound);
  EXPECT_NE(ReadSystemFile("/dev/null").error().message.find("not a regular file"),
            std::string::npos);
}

}  // namespace
}  // namespace tendon
