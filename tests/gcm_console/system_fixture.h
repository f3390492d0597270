#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "support/folder.h"
#include "support/program.h"
#include "support/wait.h"

/// A GCM and, on demand, LCMs of the demo system. All are real processes, separate from any other
/// system on this machine.
class SystemFixture : public testing::Test {
 protected:
  /// Prints the logs of the GCM and of the processes that it has started. They help to explain a
  /// failure that does not occur again.
  void TearDown() override {
    if (!HasFailure()) return;
    if (gcm) std::cerr << "The GCM has logged:\n" << gcm->err();
    for (const auto& file : std::filesystem::recursive_directory_iterator(home.path())) {
      if (file.path().extension() != ".log") continue;
      const std::string name = std::filesystem::relative(file, home.path()).string();
      std::cerr << name << " has:\n" << home.Read(name);
    }
  }

  static std::string Binary(const std::string& name) { return Built("bin/" + name); }

  /// Runs `gcm WORDS...` with the fixture's GCM, with a timeout that is long enough for a busy
  /// machine.
  Outcome Gcm(Program::Words words) const {
    words.insert(words.begin(), {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout});
    return RunProgram(words);
  }
  /// Runs `gcm WORDS...` without any option, as a new user types it.
  Outcome Typed(Program::Words words) const {
    words.insert(words.begin(), Binary("gcm"));
    return RunProgram(words, {{"TENDON_GCM", address}});
  }
  /// Runs Gcm() in a shell, so that `words` may contain redirections.
  Outcome Shell(const std::string& words) const {
    return RunProgram(
        {"/bin/sh", "-c",
         Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " " + words});
  }
  void StartGcm() {
    gcm = std::make_unique<Program>(
        Program::Words{Binary("gcm"), "--gcm", address, "serve"},
        std::map<std::string, std::string>{{"XDG_STATE_HOME", home.path().string()}});
    ASSERT_TRUE(EventuallyTrue([this] { return gcm->out().starts_with("GCM at "); })) << gcm->err();
  }
  std::unique_ptr<Program> StartLcm(const std::string& name, const std::string& system) const {
    return std::make_unique<Program>(Program::Words{Binary("lcm"), "--name", name, "--gcm", address,
                                                    "--timeout", kTestTimeout, "--system", system});
  }
  /// Starts a process with only this component.
  std::unique_ptr<Program> StartOne(const std::string& process, const std::string& component,
                                    const std::string& class_name,
                                    const std::string& library) const {
    const std::string file = process + ".json";
    home.Write(file, R"({"version": 1, "name": ")" + process + R"(", "processes": [{"name": ")" +
                         process + R"(", "components": [{"name": ")" + component +
                         R"(", "class": ")" + class_name + R"(", "library": ")" + library +
                         R"("}]}]})");
    return StartLcm(process, (home.path() / file).string());
  }
  /// Waits until the output of `gcm WORDS...` contains `text`.
  testing::AssertionResult EventuallySays(const Program::Words& words,
                                          const std::string& text) const {
    Outcome last;
    const bool said = EventuallyTrue([&] {
      last = Gcm(words);
      return last.out.find(text) != std::string::npos;
    });
    if (said) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << text << "' was never said; the last words were:\n"
                                       << last.out << last.err;
  }

  static constexpr const char* kTestTimeout = "20000";  // ms

  const std::string port = std::to_string(FreePort());
  const std::string address = "127.0.0.1:" + port;
  const std::string demo = TENDON_DEMO_SYSTEM;
  const tendon::test::Folder home;  ///< for the state of the GCM and files of the test
  std::unique_ptr<Program> gcm;
};
