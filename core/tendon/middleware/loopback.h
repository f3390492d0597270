#pragma once

#include <tendon/middleware/middleware.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace tendon {

namespace loopback {
class Courier;
class End;
struct Door;
}  // namespace loopback

/// What the LoopbackMiddlewares of one process have in common: the addresses. Thread-safe.
class LoopbackNetwork {
 public:
  /// Whether a frame arrives; called in the sender's thread. For tests that lose frames.
  using Filter = std::function<bool(std::span<const std::byte> frame)>;
  void SetFilter(Filter filter);

 private:
  friend class LoopbackMiddleware;
  friend class loopback::End;
  friend struct loopback::Door;

  bool Passes(std::span<const std::byte> frame);
  /// Fills in port 0; false where the address is taken.
  bool Add(HostPort& address, const std::shared_ptr<loopback::Door>& door);
  void Remove(const std::string& address);
  std::shared_ptr<loopback::Door> Find(const std::string& address);
  std::string NameOfNextCaller();

  std::mutex mutex_;
  Filter filter_;
  std::uint32_t last_port_ = 49151;
  std::map<std::string, std::shared_ptr<loopback::Door>> doors_;
};

/// The reference of a middleware, within one process and without a socket. Each instance stands for
/// a process: it has one thread, which delivers all that arrives in it.
class LoopbackMiddleware final : public Middleware {
 public:
  explicit LoopbackMiddleware(std::shared_ptr<LoopbackNetwork> network);
  ~LoopbackMiddleware() override;

  [[nodiscard]] std::string_view name() const override { return "loopback"; }
  Result<std::unique_ptr<Listener>> Listen(const std::string& address, AcceptLink accept) override;
  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override;

 private:
  std::shared_ptr<LoopbackNetwork> network_;
  std::shared_ptr<loopback::Courier> courier_;
};

}  // namespace tendon
