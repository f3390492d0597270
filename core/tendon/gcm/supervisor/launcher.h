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
  bool is_failure = true;  ///< an exit code other than 0, or a signal
  std::string how;         ///< "ended with exit code 3", "was ended by SIGKILL"
};

/// A started process; it runs on when this object is destroyed.
class StartedProcess {
 public:
  virtual ~StartedProcess() = default;
  [[nodiscard]] virtual std::int64_t pid() const = 0;
  /// Nothing while it runs.
  virtual std::optional<ProcessEnd> Ended() = 0;
  /// Asks it to end in order.
  virtual void Terminate() = 0;
  /// Ends it at once.
  virtual void Kill() = 0;
};

/// The output of a process.
struct Traces {
  std::string last_words;  ///< the end of its log, on one line
  std::string log;         ///< the path of its log
};

/// Starts processes on this host. Its functions wait for the disk; call them from one thread.
class Launcher {
 public:
  /// The process to start.
  struct Order {
    std::string process;
    std::chrono::milliseconds patience{0};  ///< for finding the GCM
    std::optional<SystemFile> system{};     ///< the components that it gets
  };

  virtual ~Launcher() = default;
  virtual Result<std::shared_ptr<StartedProcess>> Start(const Order& order) = 0;
  /// For the process that was last started under that name.
  virtual Traces TracesOf(const std::string& process) = 0;
  /// Bounds the log of a running process; call it often. Logs a failure once, and again after it
  /// worked in between.
  virtual void ShortenLog(const std::string& process) = 0;
};

}  // namespace tendon::server
