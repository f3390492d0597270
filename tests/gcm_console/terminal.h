#pragma once

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <map>
#include <memory>
#include <regex>
#include <string>

#include "support/program.h"
#include "support/wait.h"

/// A program with its own terminal, in which the test types keys and reads the output.
class Terminal {
 public:
  /// Runs `command` in this terminal.
  explicit Terminal(const std::string& command, std::map<std::string, std::string> environment = {},
                    unsigned short columns = 80)
      : master_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    grantpt(master_);
    unlockpt(master_);
    std::array<char, 64> name{};
    ptsname_r(master_, name.data(), name.size());
    const std::string line(name.data());
    keeper_ = open(line.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    constexpr unsigned short kUsualRows = 24;
    Resize(kUsualRows, columns);
    environment.insert({"TERM", "xterm"});
    environment.insert({"NO_COLOR", ""});
    const std::string streams = " <" + line + " >" + line + " 2>&1";
    program_ = std::make_unique<Program>(
        Program::Words{"/bin/sh", "-c", "exec setsid -c " + command + streams}, environment);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() {
    program_.reset();
    close(keeper_);
    close(master_);
  }

  void Resize(unsigned short rows, unsigned short columns) {
    const winsize size{.ws_row = rows, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    ioctl(master_, TIOCSWINSZ, &size);
  }
  void Type(const std::string& keys) {
    Read();
    seen_.clear();
    const auto written = write(master_, keys.data(), keys.size());
    static_cast<void>(written);
  }
  /// Waits until the output since the last keys contains `text`; returns false if this does not
  /// happen in time.
  bool Shows(const std::string& text) {
    return EventuallyTrue([&] {
      Read();
      return seen_.find(text) != std::string::npos;
    });
  }
  /// Does the same as Shows() for a regular expression.
  bool ShowsMatch(const std::string& pattern) {
    const std::regex expression(pattern);
    return EventuallyTrue([&] {
      Read();
      return std::regex_search(seen_, expression);
    });
  }
  /// The output since the last keys.
  const std::string& seen() {
    Read();
    return seen_;
  }
  Program& program() { return *program_; }

 private:
  void Read() {
    std::array<char, 4096> buffer{};
    for (auto count = read(master_, buffer.data(), buffer.size()); count > 0;
         count = read(master_, buffer.data(), buffer.size())) {
      seen_.append(buffer.data(), static_cast<std::size_t>(count));
    }
  }

  int master_ = -1;
  int keeper_ = -1;  // keeps the output readable after the program has ended
  std::string seen_;
  std::unique_ptr<Program> program_;
};
