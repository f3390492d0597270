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
class Courier;
class End;
struct Door;

/// A frame on its way. An end of a link has the address of its listener, or one of its own.
struct Frame {
  std::span<const std::byte> bytes;
  std::string_view from;
  std::string_view to;
};

enum class Fate { kPass, kDrop, kHold };

/// What becomes of a frame. The sender does not notice, until there is no more room for what waits.
struct Verdict {
  Fate fate = Fate::kPass;
  std::chrono::nanoseconds delay{0};  ///< of what passes
};

inline constexpr Verdict kPass{};
inline constexpr Verdict kDrop{.fate = Fate::kDrop};
/// Until ReleaseHeld(). As with every delay, what its link carries later waits behind it; what
/// waits when the link is closed is lost.
inline constexpr Verdict kHold{.fate = Fate::kHold};
}  // namespace loopback

/// What the LoopbackMiddlewares of one process have in common: the addresses, and the faults that a
/// test wants of the network. Thread-safe.
class LoopbackNetwork {
 public:
  /// Called in the sender's thread; null: everything passes.
  using Judge = std::function<loopback::Verdict(const loopback::Frame& frame)>;
  void SetJudge(Judge judge);
  void ReleaseHeld();

 private:
  friend class LoopbackMiddleware;
  friend class loopback::End;
  friend struct loopback::Door;

  loopback::Verdict Decide(const loopback::Frame& frame);
  void Remember(std::weak_ptr<loopback::End> holder);
  /// Fills in port 0; false where the address is taken.
  bool Add(HostPort& address, const std::shared_ptr<loopback::Door>& door);
  void Remove(const loopback::Door& door);
  void RemoveAll(const loopback::Courier& courier);
  std::shared_ptr<loopback::Door> Find(const std::string& address);
  std::string NameOfNextCaller();

  std::mutex mutex_;
  Judge judge_;
  std::vector<std::weak_ptr<loopback::End>> holders_;  // of frames that are held
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

  /// As if its process was killed: the other ends of its links are told that they were closed, its
  /// addresses are free, and nothing leaves it or arrives in it any more.
  void Crash();

 private:
  std::shared_ptr<LoopbackNetwork> network_;
  std::shared_ptr<loopback::Courier> courier_;
};

}  // namespace tendon
