#pragma once

#include <tendon/base/result.h>
#include <tendon/base/status.h>
#include <tendon/middleware/frame.h>
#include <tendon/security/certificate.h>

#include <cassert>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tendon {

class Broadcast;
class ReplySlot;

/// The largest number of bytes that may be buffered in a link for a slow peer.
inline constexpr std::size_t kSendWindow = std::size_t{8} << 20U;

/// An accepted link is closed if it is not admitted within this time.
inline constexpr std::chrono::seconds kAdmissionTime{3};

/// The error of a link that was not admitted in time.
[[nodiscard]] Error NotAdmitted(const std::string& peer);

/// How a link delivers a frame.
enum class Delivery {
  kQueued,
  /// For a request whose sender waits for the reply. If the link has a direct path back, the peer
  /// can send its reply on this path, as the response to this frame. Otherwise, the link queues
  /// the frame. The order relative to queued frames is kept.
  kDirect,
};

/// A two-way, ordered connection that carries frames to one peer process. Thread-safe.
class Link {
 public:
  Link() = default;
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  virtual ~Link() = default;

  /// Copies one whole frame and sends it; never blocks. Frames arrive in the order of the calls.
  /// kQueued does not mean that the frame was delivered. Fails with kQueueFull, and sends nothing,
  /// if more than kSendWindow bytes would be buffered. Fails with kInvalid if the bytes are not a
  /// frame of at most kMaxPieceSize bytes, and with kNotConnected if the link is closed.
  virtual Status Send(std::span<const std::byte> frame, Delivery delivery = Delivery::kQueued) = 0;

  /// Marks the peer as authenticated, so that it may send frames of up to kMaxPieceSize bytes.
  /// Before this call, a frame larger than kMaxUnauthenticatedFrameSize closes the link. An
  /// accepted link is also closed if Admit() is not called within kAdmissionTime. These rules
  /// limit the resources that an unauthenticated peer can use. Idempotent; may be called from a
  /// handler.
  virtual void Admit() = 0;

  /// Closes the link. Frames that were sent before still reach the peer if it reads them. No more
  /// frames are received. OnClosed() is called at both ends within a second. Idempotent; may be
  /// called from a handler.
  virtual void Close() = 0;

  /// The peer's address: "127.0.0.1:41234".
  [[nodiscard]] virtual std::string peer() const = 0;
  /// The address of this end. At the other end, peer() returns the same address.
  [[nodiscard]] virtual std::string local() const = 0;
  /// The peer's certificate, verified when the link was opened; null on a link without TLS.
  [[nodiscard]] virtual const Certificate* certificate() const { return nullptr; }
};

/// Receives the frames of a link in order, in a thread of the middleware, one call at a time. Must
/// neither block nor throw. The link holds the handler until OnClosed().
class LinkHandler {
 public:
  LinkHandler() = default;
  LinkHandler(const LinkHandler&) = delete;
  LinkHandler& operator=(const LinkHandler&) = delete;
  virtual ~LinkHandler() = default;

  /// Called with a whole frame, which ReadWholeFrame() has checked. The bytes are valid only during
  /// the call.
  virtual void OnFrame(std::span<const std::byte> frame) = 0;

  /// Called instead of OnFrame() for a large reply. The bytes are valid as long as `owner` is
  /// held. By default, calls OnFrame().
  virtual void OnLentFrame(std::span<const std::byte> frame, std::shared_ptr<const void> owner);

  /// Called instead of OnFrame() for a frame that was sent with Delivery::kDirect, if the link has
  /// a direct path back. `slot` is empty. A reply in this slot is sent on the direct path, after
  /// all frames that were sent during this call. By default, calls OnFrame().
  virtual void OnDirectFrame(std::span<const std::byte> frame, ReplySlot& slot);

  /// Called exactly once, after the last frame, when the link has ended for any reason.
  virtual void OnClosed(const Error& reason) = 0;
};

/// Accepts links at an address until it is destroyed. The destructor also closes the accepted
/// links, and returns when all calls of OnClosed() have returned. A handler must not destroy a
/// listener.
class Listener {
 public:
  Listener() = default;
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  virtual ~Listener() = default;

  /// The address at which others can open links, with the real port: "127.0.0.1:10705".
  [[nodiscard]] virtual std::string address() const = 0;
};

/// Returns the handler for a new link. Called in a thread of the middleware, before the first
/// frame. If it returns null, the link is refused: at the other end, Open() fails or OnClosed() is
/// called.
using AcceptLink = std::function<std::shared_ptr<LinkHandler>(const std::shared_ptr<Link>&)>;

/// A transport between processes: loopback, plain TCP, or Ice. A program chooses one when it
/// starts. The destructor closes all open links; afterwards no handler is called. A listener may be
/// destroyed later than its middleware, but accepts no more links. A handler must not destroy a
/// middleware.
class Middleware {
 public:
  Middleware() = default;
  Middleware(const Middleware&) = delete;
  Middleware& operator=(const Middleware&) = delete;
  virtual ~Middleware() = default;

  /// The name of the transport: "loopback", "tcp", "ice".
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// The certificate of this program, which peers see; null without TLS.
  [[nodiscard]] virtual const Certificate* certificate() const { return nullptr; }
  /// Multicast to many processes through a broker; null if this middleware has none. Valid as long
  /// as the middleware.
  [[nodiscard]] virtual Broadcast* broadcast() { return nullptr; }

  /// Listens at "host:port"; with port 0, takes a free port. Fails with kExists if the address is
  /// in use (the error names the program that uses it, if known), with kDenied if Exposure does not
  /// allow the address, and with kInvalid if it is not an address.
  virtual Result<std::unique_ptr<Listener>> Listen(const std::string& address,
                                                   AcceptLink accept) = 0;

  /// Opens a new link. Blocks until the link is open or `timeout` has passed; resolving a host name
  /// may take longer. Fails with kUnreachable, kTimeout, kInvalid, or with kDenied like Listen().
  /// After a failure, the handler was either never called, or OnClosed() has returned. Must not be
  /// called from a handler.
  virtual Result<std::shared_ptr<Link>> Open(const std::string& address,
                                             std::shared_ptr<LinkHandler> handler,
                                             std::chrono::milliseconds timeout) = 0;
};

/// The machines to which links may lead. kLoopbackOnly: only this machine. kInsecure: any machine,
/// unencrypted. kCertified: any machine, with TLS on every link, including links within this
/// machine.
enum class Exposure { kLoopbackOnly, kInsecure, kCertified };

/// Host and port of an address.
struct HostPort {
  std::string host;
  std::uint16_t port = 0;
};

/// Splits and checks "host:port" or "[::1]:port". `lowest_port` is 0 for an address to listen at,
/// otherwise 1. "localhost" becomes 127.0.0.1. An example of an error is "port 'abc': expected
/// 1..65535".
Result<HostPort> ParseAddress(const std::string& address, std::uint16_t lowest_port);

/// Returns "host:port"; an IPv6 address is put in brackets.
[[nodiscard]] std::string ToString(const HostPort& address);

/// Fails with kDenied if `exposure` is kLoopbackOnly and `host` is not 127.0.0.0/8, ::1 or
/// localhost.
Result<void> CheckExposure(const std::string& host, Exposure exposure);

/// Calls ParseAddress() and then CheckExposure() for the host.
Result<HostPort> ParseAllowedAddress(const std::string& address, std::uint16_t lowest_port,
                                     Exposure exposure);

// The rest of this file is for implementations of links, and for the channels that use them.

/// Memory of a link for a reply frame, which is the response to a direct request
/// (Delivery::kDirect). The body is written directly into the memory that the link sends. One
/// thread at a time.
class ReplySlot {
 public:
  ReplySlot() = default;
  ReplySlot(const ReplySlot&) = delete;
  ReplySlot& operator=(const ReplySlot&) = delete;
  virtual ~ReplySlot() = default;

  /// Writes the header and returns memory for the body, which must be filled before End(). Returns
  /// no value, and changes nothing, if the reply can no longer be sent as the response. Must be
  /// called at most once. May throw std::bad_alloc; then there is no frame.
  std::optional<std::span<std::byte>> Begin(const FrameHeader& header) {
    assert(!has_begun_);
    has_begun_ = true;
    size_ = FrameHeader::kSize + header.size;
    const auto room = MakeRoom(header);
    has_begun_ = room.has_value();
    return room;
  }
  /// Completes the frame. Without this call there is no frame, and the link may report this to the
  /// peer.
  void End() {
    is_there_ = true;
    OnEnd();
  }

  /// Returns another slot for the same reply, to which any thread can write later. This slot stays
  /// empty. If the other slot is destroyed unused, the link stops waiting for the reply. Returns
  /// null after Begin(), or if the link cannot defer replies.
  [[nodiscard]] std::unique_ptr<ReplySlot> Defer() {
    if (has_begun_) return nullptr;
    auto later = MakeDeferred();
    has_begun_ = later != nullptr;
    return later;
  }

  [[nodiscard]] bool has_begun() const { return has_begun_; }
  [[nodiscard]] bool is_there() const { return is_there_; }
  /// The size of the frame in bytes; 0 if there is no frame.
  [[nodiscard]] std::size_t size() const { return is_there_ ? size_ : 0; }

 private:
  /// Writes the header and returns memory for the body.
  virtual std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) = 0;
  virtual void OnEnd() {}
  virtual std::unique_ptr<ReplySlot> MakeDeferred() { return nullptr; }

  bool has_begun_ = false;
  bool is_there_ = false;
  std::size_t size_ = 0;
};

/// Returns the reason for closing a link whose peer has sent bytes that are not a frame, or a frame
/// that is too large.
[[nodiscard]] Error NoFrame(const std::string& peer);

/// Returns a listener with this address. Its destructor calls `close`.
std::unique_ptr<Listener> MakeListener(std::string address, std::function<void()> close);

/// Logs a warning if `exposure` is kInsecure. A middleware calls this function when it begins to
/// listen.
void WarnOfExposure(Exposure exposure, std::string_view middleware);

}  // namespace tendon
