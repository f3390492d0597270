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

/// A started process. It continues to run when this object is destroyed.
class StartedProcess {
 public:
  virtual ~StartedProcess() = default;
  [[nodiscard]] virtual std::int64_t pid() const = 0;
  /// Returns how the process has ended; empty while it runs.
  virtual std::optional<ProcessEnd> Ended() = 0;
  /// Asks the process to shut down in an orderly way.
  virtual void Terminate() = 0;
  /// Ends the process at once.
  virtual void Kill() = 0;
};

/// The log of a process.
struct ProcessLog {
  std::string last_lines;  ///< the last lines of the log, joined into one line
  std::string path;
};

/// Starts processes on this host. The functions may block on the disk, and only one thread may call
/// them.
class Launcher {
 public:
  /// The process to start.
  struct Order {
    std::string process;
    std::chrono::milliseconds timeout{0};  ///< the time within which the process must find the GCM
    std::optional<SystemFile> system{};    ///< the components to create
  };

  virtual ~Launcher() = default;
  virtual Result<std::shared_ptr<StartedProcess>> Start(const Order& order) = 0;
  /// Returns the log of the process that was last started with this name.
  virtual ProcessLog LogOf(const std::string& process) = 0;
  /// Rotates the log of a running process if it is too large; must be called regularly. Logs a
  /// failure once, and logs the same failure again only after a success.
  virtual void ShortenLog(const std::string& process) = 0;
};

}  // namespace tendon::server
