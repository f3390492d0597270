#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "gcm_console/system_fixture.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

ino_t InodeOf(const fs::path& file) {
  struct stat status {};
  EXPECT_EQ(stat(file.c_str(), &status), 0);
  return status.st_ino;
}

/// A GCM, and an `lcm` that has loaded a plug-in. The file of the plug-in changes while its code
/// runs.
class PluginAgeTest : public SystemFixture {
 protected:
  void SetUp() override {
    fs::create_directories(folder);
    fs::copy_file(kBuilt / "1" / "ageing.so", file);
    StartGcm();
  }
  void StartRobot(const Program::Words& more = {}) {
    Program::Words words = {Binary("lcm"), "--name",    "robot",     "--gcm",
                            address,       "--timeout", kTestTimeout};
    words.insert(words.end(), more.begin(), more.end());
    robot = std::make_unique<Program>(
        words, std::map<std::string, std::string>{{"TENDON_COMPONENTS", folder.string()}});
    ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive")) << robot->err();
  }
  /// Starts a component of the plug-in.
  void StartOld() {
    StartRobot();
    ASSERT_EQ(Create("old").exit_code, program::kOk);
    ASSERT_EQ(Gcm({"start", "robot/old"}).exit_code, program::kOk);
    ASSERT_TRUE(EventuallySays({"get", "robot/old/state.Generation"}, "1"));
  }
  Outcome Create(const std::string& name, const std::string& class_name = "Ageing") const {
    return Gcm({"create", class_name, "robot/" + name, "--library", "ageing"});
  }
  /// Overwrites the file like `cp`: the inode stays the same, and the file is empty for a moment.
  void OverwriteInPlace() const {
    const ino_t before = InodeOf(file);
    std::ifstream from(kBuilt / "2" / "ageing.so", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(from), {}};
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    ASSERT_EQ(InodeOf(file), before);
  }
  /// Replaces the file like a linker or an installation: the inode changes.
  void Replace() const {
    fs::copy_file(kBuilt / "2" / "ageing.so", folder / "next");
    fs::rename(folder / "next", file);
  }
  /// Returns how many of the next rows come from code of this generation. All rows come from cycles
  /// after this call.
  [[nodiscard]] std::size_t RowsOf(const std::string& component, int generation) const {
    const Outcome watched =
        Gcm({"watch", "robot/" + component + "/state.Generation.number", "--count", "200"});
    std::size_t rows = 0;
    std::istringstream lines(watched.out);
    for (std::string line; std::getline(lines, line);) {
      rows += line.ends_with("\t" + std::to_string(generation)) ? 1 : 0;
    }
    EXPECT_EQ(watched.exit_code, program::kOk) << watched.out << watched.err;
    return rows;
  }

  const fs::path kBuilt = Built("tests/gcm_console/ageing");
  const fs::path folder = home.path() / "components";
  const fs::path file = folder / "ageing.so";
  std::unique_ptr<Program> robot;
};

TEST_F(PluginAgeTest, OverwritingAPluginDoesNotChangeRunningCode) {
  StartOld();

  OverwriteInPlace();

  EXPECT_EQ(RowsOf("old", 1), 200U);
  ASSERT_EQ(Create("made_later").exit_code, program::kOk);
  ASSERT_EQ(Gcm({"start", "robot/made_later"}).exit_code, program::kOk);
  EXPECT_EQ(RowsOf("made_later", 1), 200U);
  EXPECT_EQ(Gcm({"restart", "robot/old"}).exit_code, program::kOk);
  EXPECT_EQ(RowsOf("old", 1), 200U);
  EXPECT_EQ(robot->Wait(std::chrono::seconds(0)), std::nullopt);
}

TEST_F(PluginAgeTest, EachVerbWarnsOfARewrittenPluginFile) {
  StartOld();
  const std::string of = file.string() + " of 20";
  const std::string old = "gcm: process 'robot' runs " + of;
  const std::string again = "; the file was written again at 20";
  const Outcome fresh = Gcm({"load", "ageing"});
  EXPECT_THAT(fresh.err, AllOf(HasSubstr("gcm: " + of), Not(HasSubstr("again"))));

  OverwriteInPlace();

  for (const Program::Words& words : {Program::Words{"load", "ageing"},
                                      {"load", "ageing", "--dry-run"},
                                      {"classes", "robot"},
                                      {"create", "Ageing", "robot/two"}}) {
    const Outcome told = Gcm(words);
    EXPECT_EQ(told.exit_code, program::kOk) << words[0];
    EXPECT_THAT(told.err, AllOf(HasSubstr(old), HasSubstr(again))) << words[0];
  }
  EXPECT_THAT(Gcm({"classes", "robot"}).out,
              HasSubstr("Ageing\tageing\t-\t" + file.string() + " of 20"));
  for (const Program::Words& words : {Program::Words{"show", "robot"}, {"show", "robot/old"}}) {
    EXPECT_TRUE(EventuallySays(words, "plug-in file\twritten again at 20"));
    EXPECT_THAT(Gcm(words).out, HasSubstr("library\tageing: " + of));
  }
  const Outcome doctor = Gcm({"doctor"});
  EXPECT_EQ(doctor.exit_code, program::kRefused);
  EXPECT_THAT(doctor.out, AllOf(HasSubstr("BAD  plug-in robot ageing"), HasSubstr(again.substr(2)),
                                HasSubstr("fix: restart the process to use the new file")));
  const Outcome status = Gcm({"status"});
  EXPECT_THAT(status.out, HasSubstr("plug-in\trobot ageing\tchanged\tprocess 'robot' runs " + of));
  EXPECT_THAT(status.err, HasSubstr("see gcm doctor"));
}

TEST_F(PluginAgeTest, DoctorWarnsAlsoForAnUnreachableProcess) {
  StartRobot({"--advertise", "127.0.0.1:9"});
  ASSERT_EQ(Create("old").exit_code, program::kOk);
  OverwriteInPlace();
  ASSERT_TRUE(EventuallySays({"show", "robot"}, "plug-in file\twritten again"));

  const Outcome doctor = Gcm({"doctor"});

  EXPECT_EQ(doctor.exit_code, program::kRefused);
  EXPECT_THAT(doctor.out, testing::ContainsRegex("BAD  process robot .*does not answer at"));
  EXPECT_THAT(doctor.out, AllOf(HasSubstr("BAD  plug-in robot ageing"),
                                HasSubstr("fix: restart the process to use the new file")));
}

TEST_F(PluginAgeTest, ShowReportsAChangeThatAnotherVerbFound) {
  StartOld();
  OverwriteInPlace();

  ASSERT_EQ(Gcm({"classes", "robot"}).exit_code, program::kOk);  // this verb checks the files

  EXPECT_TRUE(EventuallySays({"show", "robot"}, "plug-in file\twritten again"));
}

TEST_F(PluginAgeTest, JsonReportsAChangedPlugin) {
  StartOld();
  Replace();
  ASSERT_TRUE(EventuallySays({"show", "robot"}, "plug-in file\twritten again"));

  const json created =
      json::parse(Gcm({"create", "Ageing", "robot/two", "--json"}).out, nullptr, false);
  EXPECT_EQ(created["plugin"]["file"], file.string());
  EXPECT_EQ(created["plugin"]["state"], "changed");
  const json classes = json::parse(Gcm({"classes", "robot", "--json"}).out, nullptr, false);
  EXPECT_EQ(classes["loaded"][0]["state"], "changed");
  const json shown = json::parse(Gcm({"show", "robot", "--json"}).out, nullptr, false);
  EXPECT_EQ(shown["process"]["plugins"][0]["state"], "changed");
  EXPECT_NE(shown["process"]["plugins"][0]["written_now"], "");
}

TEST_F(PluginAgeTest, APlanChecksTheLoadedCodeNotTheFile) {
  StartOld();
  Replace();
  const auto write = [&](const std::string& class_name) {
    home.Write("wanted.json", R"({"version": 1, "name": "wanted", "processes": [{"name": "robot",
        "components": [{"name": "old", "class": "Ageing", "library": "ageing"},
                       {"name": "new", "class": ")" +
                                  class_name + R"(", "library": "ageing"}]}]})");
    return (home.path() / "wanted.json").string();
  };

  const Outcome refused = Gcm({"plan", write("Newcomer")});
  EXPECT_EQ(refused.exit_code, program::kRefused);
  EXPECT_THAT(
      refused.err,
      AllOf(HasSubstr("robot/new cannot be created as the file says: process 'robot' has no "
                      "class 'Newcomer' in ageing"),
            HasSubstr("the file was written again at 20")));

  const Outcome planned = Gcm({"plan", write("Ageing")});
  EXPECT_EQ(planned.exit_code, program::kOk) << planned.err;
  EXPECT_THAT(planned.err, HasSubstr("gcm: process 'robot' runs " + file.string() + " of 20"));
  const Outcome applied = Gcm({"apply", write("Ageing")});
  EXPECT_EQ(applied.exit_code, program::kOk) << applied.err;
  EXPECT_THAT(applied.err, HasSubstr("restart the process to use the new file"));
  EXPECT_EQ(RowsOf("new", 1), 200U);
}

TEST_F(PluginAgeTest, AFileWithTheSameBytesIsUnchanged) {
  StartOld();
  fs::copy_file(kBuilt / "1" / "ageing.so", folder / "next");
  fs::rename(folder / "next", file);

  EXPECT_THAT(Gcm({"load", "ageing"}).err, Not(HasSubstr("again")));
  EXPECT_THAT(Gcm({"status"}).err, HasSubstr("all is well"));
}

TEST_F(PluginAgeTest, ReportsAMissingPluginFile) {
  StartOld();
  fs::remove(file);

  EXPECT_THAT(Gcm({"load", "ageing"}).err,
              HasSubstr("; the file is missing: restore the plug-in file before"));
  EXPECT_EQ(RowsOf("old", 1), 200U);

  fs::copy_file(kBuilt / "1" / "ageing.so", file);
  EXPECT_THAT(Gcm({"load", "ageing"}).err, Not(HasSubstr("gone")));
}

TEST_F(PluginAgeTest, ARestartedProcessRunsTheNewCode) {
  StartOld();
  Replace();
  robot->Signal(SIGTERM);
  ASSERT_EQ(robot->Wait(), 0);

  StartRobot();
  ASSERT_EQ(Create("new").exit_code, program::kOk);
  ASSERT_EQ(Gcm({"start", "robot/new"}).exit_code, program::kOk);

  EXPECT_EQ(RowsOf("new", 2), 200U);
  EXPECT_EQ(Create("newer", "Newcomer").exit_code, program::kOk);
  EXPECT_THAT(Gcm({"load", "ageing"}).err, Not(HasSubstr("again")));
}

/// A test with its own run-time folder, in which it looks for files.
class PluginCopyTest : public PluginAgeTest {
 protected:
  void SetUp() override {
    fs::create_directories(copies.parent_path());
    fs::permissions(copies.parent_path().parent_path(), fs::perms::owner_all);
    fs::permissions(copies.parent_path(), fs::perms::owner_all);
    fs::create_directories(folder);
    fs::copy_file(kBuilt / "1" / "ageing.so", file);
    environment = {{"XDG_RUNTIME_DIR", (home.path() / "runtime").string()},
                   {"XDG_STATE_HOME", home.path().string()},
                   {"TENDON_COMPONENTS", folder.string()}};
    gcm = std::make_unique<Program>(Program::Words{Binary("gcm"), "--gcm", address, "serve"},
                                    environment);
    ASSERT_TRUE(EventuallyTrue([this] { return gcm->out().starts_with("GCM at "); }));
    home.Write("one.json", R"({"version": 1, "name": "one", "processes": [{"name": "robot",
        "components": [{"name": "old", "class": "Ageing", "library": "ageing"}]}]})");
  }
  void StartRobot() {
    robot = std::make_unique<Program>(
        Program::Words{Binary("lcm"), "--name", "robot", "--gcm", address, "--timeout",
                       kTestTimeout, "--system", (home.path() / "one.json").string()},
        environment);
    ASSERT_TRUE(EventuallyTrue([this] {
      return robot->err().find("runs 1 component") != std::string::npos;
    })) << robot->err();
  }
  [[nodiscard]] std::string Maps() const {
    std::ifstream maps("/proc/" + std::to_string(robot->pid()) + "/maps");
    return {std::istreambuf_iterator<char>(maps), {}};
  }
  [[nodiscard]] std::vector<fs::path> Copies() const {
    std::vector<fs::path> all;
    for (const auto& entry : fs::recursive_directory_iterator(copies)) {
      if (entry.is_regular_file()) all.push_back(entry.path());
    }
    return all;
  }

  const fs::path copies = home.path() / "runtime" / "tendon" / "plugins";
  std::map<std::string, std::string> environment;
};

TEST_F(PluginCopyTest, TheCopyKeepsItsNameAndEndsWithTheProcess) {
  StartRobot();
  ASSERT_EQ(Copies().size(), 1U);
  EXPECT_EQ(Copies()[0].filename(), "ageing.so");
  EXPECT_THAT(Maps(), AllOf(HasSubstr(Copies()[0].string()), Not(HasSubstr(file.string()))));

  robot->Signal(SIGTERM);
  ASSERT_EQ(robot->Wait(), 0);

  EXPECT_TRUE(fs::is_empty(copies));
}

TEST_F(PluginCopyTest, TheNextProcessRemovesTheCopyOfAKilledOne) {
  StartRobot();
  const fs::path left = Copies().at(0);
  robot->Signal(SIGKILL);
  ASSERT_EQ(robot->Wait(), 128 + SIGKILL);
  ASSERT_TRUE(fs::exists(left)) << "debuggers find it as long as nobody loads anything";

  StartRobot();

  EXPECT_FALSE(fs::exists(left));
  EXPECT_EQ(Copies().size(), 1U);
}

TEST_F(PluginCopyTest, TheCopyIsInMemoryIfItsFolderCannotBeMade) {
  std::ofstream(copies) << "somebody's file";
  StartRobot();
  EXPECT_THAT(Maps(), AllOf(HasSubstr("memfd:ageing.so"), Not(HasSubstr(file.string()))));

  OverwriteInPlace();

  EXPECT_TRUE(EventuallyTrue([this] {
    const Outcome shown = RunProgram(
        {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout, "show", "robot/old"},
        environment);
    return shown.out.find("state\tactive") != std::string::npos &&
           shown.out.find("plug-in file\twritten again") != std::string::npos;
  }));
  EXPECT_EQ(robot->Wait(std::chrono::seconds(0)), std::nullopt);
}

}  // namespace
