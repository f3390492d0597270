#pragma once

#include <tendon/base/result.h>
#include <tendon/base/status.h>
#include <tendon/middleware/frame.h>
#include <tendon/security/certificate.h>

#include <cassert>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tendon {

class Broadcast;
class ReplySlot;

/// Bytes that may wait on a link for a slow peer.
inline constexpr std::size_t kSendWindow = std::size_t{8} << 20U;

/// How a link delivers a frame.
enum class Delivery {
  kQueued,
  /// For a request whose sender waits for the answer. If the peer answers at once, the answer may
  /// take the direct path back. Keeps the order relative to queued frames. A link without such a
  /// path queues the frame.
  kDirect,
};

/// A two-way, ordered connection that carries frames to one peer process. Thread-safe.
class Link {
 public:
  Link() = default;
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  virtual ~Link() = default;

  /// Copies one whole frame and sends it. Frames arrive in the order of the calls. Never blocks.
  /// kQueueFull: more than kSendWindow bytes would wait, so nothing was sent. kInvalid: not a frame
  /// of at most kMaxPieceSize. kNotConnected: the link is closed. kQueued does not mean delivered.
  virtual Status Send(std::span<const std::byte> frame, Delivery delivery = Delivery::kQueued) = 0;

  /// Marks the peer as authenticated: it may now send frames of kMaxPieceSize. To limit the
  /// resources of unauthenticated peers, the link ends if a larger frame than
  /// kMaxUnauthenticatedFrameSize arrives before, or, on an accepted link, if Admit() is not called
  /// within 3 s. Idempotent; may be called from a handler.
  virtual void Admit() = 0;

  /// Closes the link. Frames already sent still reach the peer if it reads them; no more frames are
  /// received. The handlers of both ends get OnClosed() within a second. Idempotent; may be called
  /// from a handler.
  virtual void Close() = 0;

  /// The peer's address: "127.0.0.1:41234".
  [[nodiscard]] virtual std::string peer() const = 0;
  /// The address of this end, as the peer's peer() returns it.
  [[nodiscard]] virtual std::string local() const = 0;
  /// The peer's certificate, verified when the link was opened; null on a link without TLS.
  [[nodiscard]] virtual const Certificate* certificate() const { return nullptr; }
};

/// Receives the frames of a link, in a thread of the middleware, one call at a time, in order. Must
/// neither block nor throw. The link owns it until OnClosed().
class LinkHandler {
 public:
  LinkHandler() = default;
  LinkHandler(const LinkHandler&) = delete;
  LinkHandler& operator=(const LinkHandler&) = delete;
  virtual ~LinkHandler() = default;

  /// A whole frame that ReadWholeFrame() has checked. The bytes are valid only during the call.
  virtual void OnFrame(std::span<const std::byte> frame) = 0;

  /// OnFrame() for a large answer: the bytes are valid as long as `owner` is held. By default,
  /// calls OnFrame().
  virtual void OnLentFrame(std::span<const std::byte> frame, std::shared_ptr<const void> owner);

  /// OnFrame() for a frame with Delivery::kDirect, on a link with a direct path back. A reply
  /// written to `answer`, an empty slot, takes that path, behind all frames sent during the call.
  /// By default, calls OnFrame().
  virtual void OnDirectFrame(std::span<const std::byte> frame, ReplySlot& answer);

  /// Called exactly once, after the last frame, for whatever reason the link ended.
  virtual void OnClosed(const Error& reason) = 0;
};

/// Accepts links at an address until it is destroyed. The destructor also closes the accepted
/// links, and returns after their handlers got OnClosed(). Must not be destroyed by a handler.
class Listener {
 public:
  Listener() = default;
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  virtual ~Listener() = default;

  /// The address at which others can open links, with the real port: "127.0.0.1:10705".
  [[nodiscard]] virtual std::string address() const = 0;
};

/// Returns the handler of a new link. Called in a thread of the middleware, before the first frame.
/// Null refuses the link: its opener gets an error or OnClosed().
using AcceptLink = std::function<std::shared_ptr<LinkHandler>(const std::shared_ptr<Link>&)>;

/// A transport between processes: loopback, plain TCP, or Ice. Chosen once, at start. The
/// destructor closes all links that are still open; after it, no handler is called any more.
/// Listeners may outlive it; they accept nothing then. Must not be destroyed by a handler.
class Middleware {
 public:
  Middleware() = default;
  Middleware(const Middleware&) = delete;
  Middleware& operator=(const Middleware&) = delete;
  virtual ~Middleware() = default;

  /// "loopback", "tcp", "ice".
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// Our certificate, shown to peers; null without TLS.
  [[nodiscard]] virtual const Certificate* certificate() const { return nullptr; }
  /// Multicast to many processes through a broker; null if there is none. Ends with the middleware.
  [[nodiscard]] virtual Broadcast* broadcast() { return nullptr; }

  /// Listens at "host:port"; port 0 takes a free one. Errors: kExists, with the holder of the
  /// address if it is known; kDenied for an address that Exposure does not allow; kInvalid.
  virtual Result<std::unique_ptr<Listener>> Listen(const std::string& address,
                                                   AcceptLink accept) = 0;

  /// Opens a new link. Blocks until the link is open or `timeout` has passed; resolving a host name
  /// may take longer. Errors: kUnreachable, kTimeout, kDenied as for Listen(), kInvalid. After an
  /// error, the handler was not called, or got OnClosed() before the return. Must not be called
  /// from a handler.
  virtual Result<std::shared_ptr<Link>> Open(const std::string& address,
                                             std::shared_ptr<LinkHandler> handler,
                                             std::chrono::milliseconds timeout) = 0;
};

/// How far links may reach: this machine only; any machine, unencrypted; or any machine, with TLS
/// on every link, also on this machine.
enum class Exposure { kLoopbackOnly, kInsecure, kCertified };

/// Host and port of an address.
struct HostPort {
  std::string host;
  std::uint16_t port = 0;
};

/// Splits and checks "host:port" or "[::1]:port"; the error reads "port 'abc': expected 1..65535".
/// Pass 0 as `lowest_port` for an address to listen at, else 1. "localhost" becomes 127.0.0.1.
Result<HostPort> ParseAddress(const std::string& address, std::uint16_t lowest_port);

/// "host:port"; an IPv6 address in brackets.
[[nodiscard]] std::string ToString(const HostPort& address);

/// kDenied unless `host` is 127.0.0.0/8, ::1 or localhost, or `exposure` allows it.
Result<void> CheckExposure(const std::string& host, Exposure exposure);

/// ParseAddress(), and CheckExposure() of the host.
Result<HostPort> ParseAllowedAddress(const std::string& address, std::uint16_t lowest_port,
                                     Exposure exposure);

// For implementations of links, and for the channels that use them.

/// A reply frame that is the link's response to a request (Delivery::kDirect). The body is written
/// directly into the memory that the link sends. One thread at a time.
class ReplySlot {
 public:
  ReplySlot() = default;
  ReplySlot(const ReplySlot&) = delete;
  ReplySlot& operator=(const ReplySlot&) = delete;
  virtual ~ReplySlot() = default;

  /// Call it at most once. Returns memory for the body of the frame with this header; write all of
  /// it before End(). Returns no value, without an effect, if the reply can no longer be sent as
  /// the response. May throw std::bad_alloc; then there is no frame.
  std::optional<std::span<std::byte>> Begin(const FrameHeader& header) {
    assert(!has_begun_);
    has_begun_ = true;
    size_ = FrameHeader::kSize + header.size;
    const auto room = MakeRoom(header);
    has_begun_ = room.has_value();
    return room;
  }
  /// Completes the frame. Without this call there is no frame, and the link may report that to the
  /// peer.
  void End() {
    is_there_ = true;
    OnEnd();
  }

  /// Returns another slot for the same reply, which any thread can write later; this slot stays
  /// empty. If the other slot is destroyed unused, the link stops waiting for the reply. Null after
  /// Begin(), or if the link cannot defer.
  [[nodiscard]] std::unique_ptr<ReplySlot> Defer() {
    if (has_begun_) return nullptr;
    auto later = MakeDeferred();
    has_begun_ = later != nullptr;
    return later;
  }

  [[nodiscard]] bool has_begun() const { return has_begun_; }
  [[nodiscard]] bool is_there() const { return is_there_; }
  /// Bytes of the frame; 0 without one.
  [[nodiscard]] std::size_t size() const { return is_there_ ? size_ : 0; }

 private:
  /// Also writes the header.
  virtual std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) = 0;
  virtual void OnEnd() {}
  virtual std::unique_ptr<ReplySlot> MakeDeferred() { return nullptr; }

  bool has_begun_ = false;
  bool is_there_ = false;
  std::size_t size_ = 0;
};

/// The reason for closing a link if the peer sends bytes that are not a frame, or too large a
/// frame.
[[nodiscard]] Error NoFrame(const std::string& peer);

/// A listener made of an address and a function that its destructor calls.
std::unique_ptr<Listener> MakeListener(std::string address, std::function<void()> close);

/// Logs a warning if `exposure` is kInsecure. A middleware calls it when it listens.
void WarnOfExposure(Exposure exposure, std::string_view middleware);

}  // namespace tendon
