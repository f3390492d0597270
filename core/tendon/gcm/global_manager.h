#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/supervisor/launch_options.h>
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

/// The global component manager. LCMs join it under their names and report changes; viewers watch
/// its catalogue and log, and ask it to connect and disconnect. It carries no data. A restarted GCM
/// rebuilds its catalogue when the LCMs join again; its absence does not affect running components.
/// Only the history of steps is kept in a file.
///
/// Thread safety: all functions at any time. Has one thread of its own, and those of the
/// middleware.
class GlobalManager {
 public:
  /// The address and the files of a GCM.
  struct Options {
    std::string address = "127.0.0.1:10705";
    std::filesystem::path state_folder;   ///< for the history; empty: os::StateFolder()
    const Clock* clock = &SteadyClock();  ///< for the leases; outlives the manager
    /// How long to wait for an LCM's answer: longer than an LCM needs to detect a hanging peer,
    /// shorter than clients wait for the GCM.
    std::chrono::milliseconds order_timeout{1500};
    LaunchOptions launch{};  ///< for the processes that it starts
    /// The address of the multicast broker for rows; empty: there is none.
    std::string broker{};
  };

  /// Errors are those of Middleware::Listen(): kExists if another GCM has this address.
  static Result<std::unique_ptr<GlobalManager>> Start(std::shared_ptr<Middleware> middleware,
                                                      Options options);
  GlobalManager(const GlobalManager&) = delete;
  GlobalManager& operator=(const GlobalManager&) = delete;
  /// Closes all channels; LCMs continue and try to join a GCM again. Not in a thread of the
  /// middleware.
  ~GlobalManager();

  /// The announced address, with the actual port.
  [[nodiscard]] std::string address() const { return listener_->address(); }
  /// New at each start.
  [[nodiscard]] std::uint64_t instance() const { return instance_; }
  /// A copy of the current catalogue.
  [[nodiscard]] Catalogue catalogue() const;

  /// Checks the leases; the manager's thread does this every 100 ms. For tests that set the clock.
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
