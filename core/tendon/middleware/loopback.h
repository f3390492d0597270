#pragma once

#include <tendon/middleware/middleware.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

namespace loopback {
class DeliveryThread;
class End;
struct ListeningEndpoint;

/// A frame that is being sent, with the addresses of both ends. The accepting end has the address
/// of its listener; the opening end has an address of its own.
struct Frame {
  std::span<const std::byte> bytes;
  std::string_view from;
  std::string_view to;
};

enum class FaultAction { kPass, kDrop, kHold };

/// The fault that is injected into a frame. The sender does not notice the fault, unless the link
/// becomes full.
struct Fault {
  FaultAction action = FaultAction::kPass;
  std::chrono::nanoseconds delay{0};  ///< used only with kPass
};

inline constexpr Fault kPass{};
inline constexpr Fault kDrop{.action = FaultAction::kDrop};
/// Holds the frame until ReleaseHeld(). A delayed frame also delays all later frames of the link.
/// When the link is closed, all its held or delayed frames are lost.
inline constexpr Fault kHold{.action = FaultAction::kHold};
}  // namespace loopback

/// The simulated network that the LoopbackMiddlewares of one process share: their addresses, and
/// the faults that a test injects. Thread-safe.
class LoopbackNetwork {
 public:
  /// Returns the fault for a frame. Called in the sender's thread. Without an injector, all frames
  /// pass.
  using FaultInjector = std::function<loopback::Fault(const loopback::Frame& frame)>;
  void SetFaultInjector(FaultInjector fault_injector);
  void ReleaseHeld();

 private:
  friend class LoopbackMiddleware;
  friend class loopback::End;
  friend struct loopback::ListeningEndpoint;

  loopback::Fault Decide(const loopback::Frame& frame);
  void Remember(std::weak_ptr<loopback::End> holder);
  /// Registers a listener. If the port is 0, chooses a free one. Returns false if the address is in
  /// use.
  bool Add(HostPort& address, const std::shared_ptr<loopback::ListeningEndpoint>& endpoint);
  void Remove(const loopback::ListeningEndpoint& endpoint);
  void RemoveAll(const loopback::DeliveryThread& thread);
  std::shared_ptr<loopback::ListeningEndpoint> Find(const std::string& address);
  std::string NameOfNextCaller();

  std::mutex mutex_;
  FaultInjector fault_injector_;
  std::vector<std::weak_ptr<loopback::End>> holders_;  // ends with held frames
  std::uint32_t last_port_ = 49151;
  std::map<std::string, std::shared_ptr<loopback::ListeningEndpoint>> endpoints_;
};

/// The reference implementation of Middleware, inside one process and without sockets. Each
/// instance represents a process. It has one thread, which calls all its handlers.
class LoopbackMiddleware final : public Middleware {
 public:
  explicit LoopbackMiddleware(std::shared_ptr<LoopbackNetwork> network);
  ~LoopbackMiddleware() override;

  [[nodiscard]] std::string_view name() const override { return "loopback"; }
  Result<std::unique_ptr<Listener>> Listen(const std::string& address, AcceptLink accept) override;
  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override;

  /// Simulates that the process is killed: OnClosed() is called at the peers, the addresses become
  /// free, and this object sends and receives nothing more.
  void Crash();

 private:
  std::shared_ptr<LoopbackNetwork> network_;
  std::shared_ptr<loopback::DeliveryThread> thread_;
};

}  // namespace tendon
