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

/// A started process, which continues when this object is destroyed.
class StartedProcess {
 public:
  virtual ~StartedProcess() = default;
  [[nodiscard]] virtual std::int64_t pid() const = 0;
  /// Empty while it runs.
  virtual std::optional<ProcessEnd> Ended() = 0;
  /// Asks the process to end in order.
  virtual void Terminate() = 0;
  /// Ends the process at once.
  virtual void Kill() = 0;
};

/// The log of a process.
struct ProcessLog {
  std::string last_lines;  ///< the last lines of its log, on one line
  std::string path;
};

/// Starts processes on this host. Its functions may wait for the disk; only one thread calls them.
class Launcher {
 public:
  /// The process to start.
  struct Order {
    std::string process;
    std::chrono::milliseconds patience{0};  ///< time limit for finding the GCM
    std::optional<SystemFile> system{};     ///< the components to create
  };

  virtual ~Launcher() = default;
  virtual Result<std::shared_ptr<StartedProcess>> Start(const Order& order) = 0;
  /// The log of the process that was last started under that name.
  virtual ProcessLog LogOf(const std::string& process) = 0;
  /// Limits the size of the log of a running process; call it often. Logs a failure once, and again
  /// only after a success.
  virtual void ShortenLog(const std::string& process) = 0;
};

}  // namespace tendon::server
