#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>
#include <tendon/gcm/supervisor/launch.h>
#include <tendon/middleware/middleware.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace tendon {

namespace server {
class Server;
}

/// The global component manager: LCMs join it under their names and keep it informed; viewers watch
/// its catalogue and its log, and ask it to connect and disconnect. It carries no data. What it
/// knows it is told by the LCMs: killed and started anew it knows the same again when they have
/// joined again, and nothing that runs was disturbed. Only the history of steps is kept in a file.
///
/// Thread safety: all functions at any time. One thread of its own, and the middleware's.
class GlobalManager {
 public:
  /// Where it listens, and what it keeps.
  struct Options {
    std::string address = "127.0.0.1:10705";
    std::filesystem::path state_folder;   ///< of the history; empty: os::StateFolder()
    const Clock* clock = &SteadyClock();  ///< of the leases; outlives the manager
    /// Until an LCM's answer is given up: longer than that needs to find a peer that hangs, shorter
    /// than clients wait for us.
    std::chrono::milliseconds order_timeout{1500};
    Launch launch{};  ///< of the processes that it starts
    /// Where the broker is by which rows reach many viewers; empty: there is none.
    std::string fan_out{};
  };

  /// Errors are those of Middleware::Listen(): kExists where another GCM is at this address.
  static Result<std::unique_ptr<GlobalManager>> Start(std::shared_ptr<Middleware> middleware,
                                                      Options options);
  GlobalManager(const GlobalManager&) = delete;
  GlobalManager& operator=(const GlobalManager&) = delete;
  /// Closes all channels; LCMs run on and look for the next GCM. Not in a thread of the middleware.
  ~GlobalManager();

  /// Where others reach it, with the port that was taken.
  [[nodiscard]] std::string address() const { return listener_->address(); }
  /// New at each start.
  [[nodiscard]] std::uint64_t instance() const { return instance_; }
  /// A copy of the catalogue as it is now.
  [[nodiscard]] Catalog catalog() const;

  /// Judges the leases by the clock, as its thread does each 100 ms. For tests that turn the hands.
  void Tick();

 private:
  GlobalManager(std::shared_ptr<Middleware> middleware, std::shared_ptr<server::Server> server,
                std::unique_ptr<Listener> listener, std::uint64_t instance);

  const std::shared_ptr<Middleware> middleware_;
  const std::shared_ptr<server::Server> server_;
  std::unique_ptr<Listener> listener_;
  const std::uint64_t instance_;
};

}  // namespace tendon
