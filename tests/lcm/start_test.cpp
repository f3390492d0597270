#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "gcm_console/system_fixture.h"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// An LCM that must not start. It prints the reason in one sentence, and the GCM has never seen it.
class LcmStart : public SystemFixture {
 protected:
  void ExpectRefused(Program::Words words, int exit_code, const std::string& sentence) {
    words.insert(words.begin(), {Binary("lcm"), "--gcm", address});
    const Outcome outcome = RunProgram(words);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("lcm: "));
    EXPECT_THAT(outcome.err, HasSubstr(sentence));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    if (gcm) {
      EXPECT_EQ(Gcm({"ls"}).out, "");
    }
  }
  void ExpectFileRefused(const std::string& file, const std::string& sentence,
                         int exit_code = program::kUsage) {
    ExpectRefused({"--name", "robot", "--system", file}, exit_code, sentence);
  }
  void ExpectTextRefused(const std::string& text, const std::string& sentence) {
    const std::string file = folder / "system.json";
    std::ofstream(file, std::ios::binary) << text;
    ExpectFileRefused(file, file + ": " + sentence);
  }

  const fs::path folder = home.path();
};

TEST_F(LcmStart, RejectsAMistypedCommandLine) {
  ExpectRefused({}, program::kUsage, "--name is missing; lcm --help tells more");
  ExpectRefused({"--nam", "robot"}, program::kUsage, "no option '--nam'; did you mean '--name'?");
  ExpectRefused({"--name", "robot", "--sytem", "x"}, program::kUsage,
                "no option '--sytem'; did you mean '--system'? lcm --help tells more");
  ExpectRefused({"--name", "a", "--name", "b"}, program::kUsage, "--name is given 2 times");
  ExpectRefused({"--name"}, program::kUsage, "--name needs a value");
  ExpectRefused({"--name", "robot", "arm"}, program::kUsage, "'arm' is one word too many");
}

TEST_F(LcmStart, RejectsABadName) {
  StartGcm();
  ExpectRefused({"--name", "ro bot"}, program::kUsage, "process name 'ro bot' has ' ' at 3");
  ExpectRefused({"--name", ""}, program::kUsage, "process name is empty");
  ExpectRefused({"--name", std::string(65, 'x')}, program::kUsage, "has 65 characters");
  ExpectRefused({"--name", "\x1b[2J"}, program::kUsage, "process name '\\x1b[2J' has '\\x1b' at 1");
}

TEST_F(LcmStart, RejectsAnUnusableListenAddress) {
  StartGcm();
  const std::string taken = "127.0.0.1:" + std::to_string(FreePort());
  const Program other({Binary("gcm"), "--gcm", taken, "serve"});
  ASSERT_TRUE(EventuallyTrue([&] { return other.out().starts_with("GCM at "); })) << other.err();
  ExpectRefused({"--name", "robot", "--listen", taken}, program::kRefused,
                taken + " is in use by pid " + std::to_string(other.pid()) +
                    " (gcm); give another port with --listen, or 0 for a free port");
  ExpectRefused({"--name", "robot", "--listen", "localhost:" + port}, program::kUsage,
                "--listen and --gcm are both " + address +
                    ", but two programs cannot share a port; give --listen another port");
  ExpectRefused({"--name", "robot", "--listen", "192.0.2.1:0"}, program::kDenied, "--insecure");
  ExpectRefused({"--name", "robot", "--listen", "127.0.0.1:abc"}, program::kUsage,
                "port 'abc': expected 0..65535");
  ExpectRefused({"--name", "robot", "--listen", "nowhere"}, program::kUsage, "expected host:port");
  ExpectRefused({"--name", "robot", "--advertise", "127.0.0.1:0"}, program::kUsage,
                "port '0': expected 1..65535");
}

TEST_F(LcmStart, RejectsABadGcmAddress) {
  ExpectRefused({"--name", "robot", "--gcm", "127.0.0.1:1"}, program::kUsage, "given 2 times");
  for (const char* bad : {"127.0.0.1:abc", "127.0.0.1:0", "127.0.0.1:65536", "127.0.0.1:-1"}) {
    const Outcome outcome = RunProgram({Binary("lcm"), "--name", "robot", "--gcm", bad});
    EXPECT_EQ(outcome.exit_code, program::kUsage) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("expected 1..65535"));
  }
  const Outcome away = RunProgram({Binary("lcm"), "--name", "robot", "--gcm", "192.0.2.1"});
  EXPECT_EQ(away.exit_code, program::kDenied) << away.err;
}

TEST_F(LcmStart, RejectsAMissingOrSpecialFile) {
  ExpectFileRefused(folder / "none.json", "there is no such file", program::kNotFound);
  ExpectFileRefused(folder, "is a folder, not a file");
  ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
  ExpectFileRefused(folder / "fifo", "is not a regular file");
  ExpectFileRefused("/dev/zero", "is not a regular file");
  fs::create_symlink(folder / "b", folder / "a");
  fs::create_symlink(folder / "a", folder / "b");
  ExpectFileRefused(folder / "a", "symbolic links");
}

TEST_F(LcmStart, RejectsAnOversizedFile) {
  std::ofstream(folder / "large.json").put('{');
  fs::resize_file(folder / "large.json", std::uintmax_t{1} << 30U);  // sparse
  ExpectFileRefused(folder / "large.json", "is larger than 16 MB");
}

TEST_F(LcmStart, RejectsInvalidJson) {
  ExpectTextRefused("", "is empty");
  ExpectTextRefused("\xef\xbb\xbf{}", "begins with a byte-order mark");
  ExpectTextRefused("{\"version\": 1,\n  \"name\": ,}", "line 2, column 11: unexpected ','");
  ExpectTextRefused("{\"version\": 1,\n", "line 2, column");
  ExpectTextRefused("{\"version\": 1, // one\n}", "line 1, column");
  ExpectTextRefused(std::string(10'000, '['), "nesting deeper than 64");
  ExpectTextRefused("{\"name\": \"\xff\"}", "line 1, column");
  ExpectTextRefused("{\"version\": 1e999}", "line 1, column");
}

TEST_F(LcmStart, RejectsAnInvalidSystemFile) {
  const auto with = [](const std::string& processes) {
    return R"({"version": 1, "name": "x", "processes": )" + processes + "}";
  };
  ExpectTextRefused(R"({"version": 99})",
                    "line 1, column 2: the file has version 99, but this program reads version 1");
  ExpectTextRefused(with("7"), "line 1, column 29: processes: expected a list, got number");
  ExpectTextRefused(with(R"([{"name": "a", "name": "b"}])"),
                    "line 1, column 57: processes[0]: key 'name' occurs twice");
  ExpectTextRefused(with(R"([{"nam": "robot"}])"),
                    "line 1, column 44: processes[0]: unknown key 'nam'; did you mean 'name'?");
  ExpectTextRefused(
      with(R"([{"name": "robot", "components": [{"name": "arm", "class": 7}]}])"),
      "line 1, column 92: processes[0].components[0].class: expected string, got number");
  ExpectTextRefused(
      with(R"([{"name": "robot", "components": [
                      {"name": "arm", "class": "A", "library": "../../x.so"}]}])"),
      "line 2, column 53: processes[0].components[0].library: library '../../x.so' is a path");
}

TEST_F(LcmStart, RejectsInvalidComponentEntries) {
  const std::string file = folder / "system.json";
  const auto with = [&](const std::string& component) {
    std::ofstream(file) << R"({"version": 1, "name": "x", "processes": [{"name": "robot",
                               "components": [{"name": "arm", )" +
                               component + "}]}]}";
    return file;
  };
  ExpectFileRefused(with(R"("class": null)"),
                    "component 'arm' has no class in the file, because another program creates it");
  ExpectFileRefused(with(R"("class": "SimulatedArm")"),
                    "component 'arm' has no \"library\" in the file: add the name of the plug-in "
                    "that has class SimulatedArm; available: ");
  ExpectFileRefused(with(R"("class": "SimulatedArm", "library": "simulated_arm",
                            "thread": {"priority": 7})"),
                    "system.json: line 3, column 29: processes[0].components[0].thread: ");
  ExpectFileRefused(with(R"("class": "SimulatedArm", "library": "simulated_arm",
                            "thread": {"timer_slack": 3600})"),
                    "timer slack must be 1 ns..100 ms, got 3600000000000 ns");
}

}  // namespace
