#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/system_file.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace tendon::server {

/// How a process has ended.
struct ProcessEnd {
  bool is_failure = true;  ///< another exit code than 0, or a signal
  std::string how;         ///< "ended with exit code 3", "was ended by SIGKILL"
};

/// A process that was started; it goes on when this object ends.
class StartedProcess {
 public:
  virtual ~StartedProcess() = default;
  [[nodiscard]] virtual std::int64_t pid() const = 0;
  /// Nothing as long as it runs.
  virtual std::optional<ProcessEnd> Ended() = 0;
  /// Asks it to end, in order.
  virtual void Terminate() = 0;
  /// Ends it, at once.
  virtual void Kill() = 0;
};

/// What a process has left.
struct Traces {
  std::string last_words;  ///< the end of its log, in one line
  std::string log;         ///< where that is
};

/// Starts processes on this host. Its functions wait for the disk; they are called by one thread.
class Launcher {
 public:
  /// What is started.
  struct Order {
    std::string process;
    std::chrono::milliseconds patience{0};  ///< to look for the GCM
    std::optional<SystemFile> system{};     ///< with the components that it is to have
  };

  virtual ~Launcher() = default;
  virtual Result<std::shared_ptr<StartedProcess>> Start(const Order& order) = 0;
  /// Of the process that was started last under that name.
  virtual Traces TracesOf(const std::string& process) = 0;
  /// Keeps the log of one that runs from growing for ever; to be called often. What goes wrong is
  /// said once, and again when it went well in between.
  virtual void ShortenLog(const std::string& process) = 0;
};

}  // namespace tendon::server
