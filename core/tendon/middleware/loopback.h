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

/// A frame that is being sent. The address of an accepting end is that of its listener; an opener
/// has an address of its own.
struct Frame {
  std::span<const std::byte> bytes;
  std::string_view from;
  std::string_view to;
};

enum class FaultAction { kPass, kDrop, kHold };

/// The fault injected into a frame. The sender notices nothing until the link is full.
struct Fault {
  FaultAction action = FaultAction::kPass;
  std::chrono::nanoseconds delay{0};  ///< only for a frame that is delivered
};

inline constexpr Fault kPass{};
inline constexpr Fault kDrop{.action = FaultAction::kDrop};
/// Holds the frame until ReleaseHeld(). As with every delay, later frames of the link wait behind
/// it. Frames that wait when the link is closed are lost.
inline constexpr Fault kHold{.action = FaultAction::kHold};
}  // namespace loopback

/// The network that the LoopbackMiddlewares of one process share: their addresses, and the faults
/// that a test injects. Thread-safe.
class LoopbackNetwork {
 public:
  /// Chooses the fault of each frame. Called in the sender's thread. Null lets everything pass.
  using FaultInjector = std::function<loopback::Fault(const loopback::Frame& frame)>;
  void SetFaultInjector(FaultInjector fault_injector);
  void ReleaseHeld();

 private:
  friend class LoopbackMiddleware;
  friend class loopback::End;
  friend struct loopback::ListeningEndpoint;

  loopback::Fault Decide(const loopback::Frame& frame);
  void Remember(std::weak_ptr<loopback::End> holder);
  /// Fills in port 0. Returns false if the address is taken.
  bool Add(HostPort& address, const std::shared_ptr<loopback::ListeningEndpoint>& endpoint);
  void Remove(const loopback::ListeningEndpoint& endpoint);
  void RemoveAll(const loopback::DeliveryThread& thread);
  std::shared_ptr<loopback::ListeningEndpoint> Find(const std::string& address);
  std::string NameOfNextCaller();

  std::mutex mutex_;
  FaultInjector fault_injector_;
  std::vector<std::weak_ptr<loopback::End>> holders_;  // ends that hold frames back
  std::uint32_t last_port_ = 49151;
  std::map<std::string, std::shared_ptr<loopback::ListeningEndpoint>> endpoints_;
};

/// The reference implementation of Middleware, within one process and without a socket. Each
/// instance stands for a process. It has one thread, which makes all calls of its handlers.
class LoopbackMiddleware final : public Middleware {
 public:
  explicit LoopbackMiddleware(std::shared_ptr<LoopbackNetwork> network);
  ~LoopbackMiddleware() override;

  [[nodiscard]] std::string_view name() const override { return "loopback"; }
  Result<std::unique_ptr<Listener>> Listen(const std::string& address, AcceptLink accept) override;
  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override;

  /// Behaves as if the process were killed: the peers get OnClosed(), its addresses become free,
  /// and it sends and receives nothing more.
  void Crash();

 private:
  std::shared_ptr<LoopbackNetwork> network_;
  std::shared_ptr<loopback::DeliveryThread> thread_;
};

}  // namespace tendon
