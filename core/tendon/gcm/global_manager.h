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

/// The global component manager (GCM). LCMs join it under their names and report changes. Viewers
/// watch its catalogue and log, and ask it to connect and disconnect. No data of components passes
/// through the GCM, so running components continue without it. A restarted GCM builds its catalogue
/// again when the LCMs join. Only the history of steps is kept in a file.
///
/// Thread safety: any thread may call all functions at any time. The manager has one thread of its
/// own, and uses the threads of the middleware.
class GlobalManager {
 public:
  /// The address and the files of a GCM.
  struct Options {
    std::string address = "127.0.0.1:10705";
    std::filesystem::path state_folder;   ///< folder of the history; empty: os::StateFolder()
    const Clock* clock = &SteadyClock();  ///< for the leases; must outlive the manager
    /// The time that the GCM waits for the reply of an LCM. It must be longer than the time that
    /// an LCM needs to detect a hanging peer, and shorter than the time that clients wait for the
    /// GCM.
    std::chrono::milliseconds order_timeout{1500};
    LaunchOptions launch{};  ///< for the processes that the GCM starts
    /// The address of the multicast broker for rows; empty without a broker.
    std::string broker{};
  };

  /// Starts a GCM. Fails like Middleware::Listen(), for example with kExists if another GCM has
  /// this address. Also fails if the certificate of the middleware is not for a GCM, or if the
  /// loopback cookie cannot be read.
  static Result<std::unique_ptr<GlobalManager>> Start(std::shared_ptr<Middleware> middleware,
                                                      Options options);
  GlobalManager(const GlobalManager&) = delete;
  GlobalManager& operator=(const GlobalManager&) = delete;
  /// Closes all channels. The LCMs continue to run and try to join a GCM again. Must not be called
  /// in a thread of the middleware.
  ~GlobalManager();

  /// The address that the GCM announces, with the actual port.
  [[nodiscard]] std::string address() const { return listener_->address(); }
  /// A number that is new at each start of a GCM.
  [[nodiscard]] std::uint64_t instance() const { return instance_; }
  /// A copy of the current catalogue.
  [[nodiscard]] Catalogue catalogue() const;

  /// Checks the leases. The manager's thread does this every 100 ms. Only tests with their own
  /// clock call this function.
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
