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

class FanOut;

/// How many bytes may wait on a link for a peer that does not keep up.
inline constexpr std::size_t kSendWindow = std::size_t{8} << 20U;

/// One two-way, ordered connection that carries frames to one peer process. All functions are
/// thread-safe.
class Link {
 public:
  Link() = default;
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  virtual ~Link() = default;

  /// Takes a copy of a whole frame to be sent; frames arrive in the order of the calls. Never
  /// blocks: kQueueFull when the frame would make it more than kSendWindow bytes that wait to be
  /// sent (nothing of it is sent), kInvalid when the bytes are no frame of at most kMaxPieceSize,
  /// kNotConnected once the link is closed. kQueued does not mean delivered.
  virtual Status Send(std::span<const std::byte> frame) = 0;

  /// Send() for a request whose sender waits for the answer: where the peer gives it at once, it
  /// may come back by a shorter way. Keeps the order with what Send() takes, and is like it unless
  /// overridden.
  virtual Status Ask(std::span<const std::byte> frame) { return Send(frame); }

  /// The peer is one of ours: from now on it may send frames of kMaxPieceSize. Until then one of
  /// more than kMaxStrangersFrameSize ends the link; so do 3 s, where it was accepted, for a
  /// stranger must take neither memory nor a place. Idempotent; may be called from a handler.
  virtual void Admit() = 0;

  /// Ends the connection: frames on their way to the peer still arrive where it listens, nothing
  /// more is heard from it, and the handlers of both ends hear OnClosed(), within a second.
  /// Idempotent; may be called from a handler.
  virtual void Close() = 0;

  /// Where the peer is: "127.0.0.1:41234".
  [[nodiscard]] virtual std::string peer() const = 0;
  /// Where this end is, as the peer's peer().
  [[nodiscard]] virtual std::string local() const = 0;
  /// The peer's, which was found good when the link began; null on a link without TLS.
  [[nodiscard]] virtual const Certificate* certificate() const { return nullptr; }
};

/// A frame that goes back with the one that asked, written to where the link sends it from. Of one
/// thread at a time.
class LeftAnswer {
 public:
  LeftAnswer() = default;
  LeftAnswer(const LeftAnswer&) = delete;
  LeftAnswer& operator=(const LeftAnswer&) = delete;
  virtual ~LeftAnswer() = default;

  /// Once: room for the body of the frame with this header, all of which is written before End().
  /// Nothing where it can be left here no more: then it is as if nothing had happened. May throw
  /// std::bad_alloc; there is no frame then.
  std::optional<std::span<std::byte>> Begin(const FrameHeader& header) {
    assert(!has_begun_);
    has_begun_ = true;
    size_ = FrameHeader::kSize + header.size;
    const auto room = MakeRoom(header);
    has_begun_ = room.has_value();
    return room;
  }
  /// It is there. One that was begun and is not there is none, and its link may tell the peer so.
  void End() {
    is_there_ = true;
    Leave();
  }

  /// One that is left later, by any thread, in the place of this one, which is none then. Its link
  /// does not wait for what is dropped. Null where it has begun, or the link knows no such way.
  [[nodiscard]] std::unique_ptr<LeftAnswer> Defer() {
    if (has_begun_) return nullptr;
    auto later = MakeLater();
    has_begun_ = later != nullptr;
    return later;
  }

  [[nodiscard]] bool has_begun() const { return has_begun_; }
  [[nodiscard]] bool is_there() const { return is_there_; }
  /// Of the frame; 0 without one.
  [[nodiscard]] std::size_t size() const { return is_there_ ? size_ : 0; }

 private:
  /// Writes the header.
  virtual std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) = 0;
  virtual void Leave() {}
  virtual std::unique_ptr<LeftAnswer> MakeLater() { return nullptr; }

  bool has_begun_ = false;
  bool is_there_ = false;
  std::size_t size_ = 0;
};

/// Hears what arrives on a link, in a thread of the middleware, one call at a time, in order. Must
/// neither block nor throw. Held by the link until OnClosed().
class LinkHandler {
 public:
  LinkHandler() = default;
  LinkHandler(const LinkHandler&) = delete;
  LinkHandler& operator=(const LinkHandler&) = delete;
  virtual ~LinkHandler() = default;

  /// A whole frame, which was checked by ReadWholeFrame(). The bytes are valid during the
  /// call.
  virtual void OnFrame(std::span<const std::byte> frame) = 0;

  /// The same for bytes that are valid as long as `owner` is held: a large answer. Unless
  /// overridden, OnFrame().
  virtual void OnLentFrame(std::span<const std::byte> frame, std::shared_ptr<const void> owner);

  /// The same for a frame that came by Link::Ask(), on a link that has a shorter way back: what is
  /// left in `answer`, in which there was no frame, takes it, behind all that is sent during the
  /// call. Unless overridden, OnFrame().
  virtual void OnAsked(std::span<const std::byte> frame, LeftAnswer& answer);

  /// Exactly once, after the last frame, whoever closed the link and however it broke.
  virtual void OnClosed(const Error& reason) = 0;
};

/// Accepts links at an address until it is destroyed, which also closes the links it accepted:
/// their handlers have heard OnClosed() when the destructor returns. Not to be destroyed by a
/// handler.
class Listener {
 public:
  Listener() = default;
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  virtual ~Listener() = default;

  /// Where others reach it, the port filled in: "127.0.0.1:10705".
  [[nodiscard]] virtual std::string address() const = 0;
};

/// Why a link ends on which something else came than frames of a size that the peer may send.
[[nodiscard]] Error NoFrame(const std::string& peer);

/// A listener that is nothing but its address and what its destructor does.
std::unique_ptr<Listener> MakeListener(std::string address, std::function<void()> close);

/// Returns the handler of a new link; called in a thread of the middleware, before its first frame.
/// Null refuses the link: its opener gets an error or hears OnClosed().
using AcceptLink = std::function<std::shared_ptr<LinkHandler>(const std::shared_ptr<Link>&)>;

/// A way for processes to talk: loopback, plain TCP, or Ice. Chosen once, at start. Its destructor
/// closes what is still open and returns when no handler will hear anything any more; listeners may
/// outlive it, deaf. Not to be destroyed by a handler.
class Middleware {
 public:
  Middleware() = default;
  Middleware(const Middleware&) = delete;
  Middleware& operator=(const Middleware&) = delete;
  virtual ~Middleware() = default;

  /// "loopback", "tcp", "ice".
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// What it shows to peers; null without TLS.
  [[nodiscard]] virtual const Certificate* certificate() const { return nullptr; }
  /// The way to many at once, by a broker; null where there is none. Ends with the middleware.
  [[nodiscard]] virtual FanOut* fan_out() { return nullptr; }

  /// Listens at "host:port"; port 0 takes a free one. Errors: kExists, with who holds it where that
  /// can be known; kDenied for an address that Exposure does not allow; kInvalid.
  virtual Result<std::unique_ptr<Listener>> Listen(const std::string& address,
                                                   AcceptLink accept) = 0;

  /// Opens a link, a connection of its own; blocks until it stands or `timeout` has passed (asking
  /// for a host's name may take longer). Errors: kUnreachable, kTimeout, kDenied as for Listen(),
  /// kInvalid; the handler hears nothing then, or OnClosed() before this returns. Not from a
  /// handler.
  virtual Result<std::shared_ptr<Link>> Open(const std::string& address,
                                             std::shared_ptr<LinkHandler> handler,
                                             std::chrono::milliseconds timeout) = 0;
};

/// How far links may go: on this machine only; anywhere although nothing is encrypted; or anywhere
/// because each link is under TLS, on this machine, too.
enum class Exposure { kLoopbackOnly, kInsecure, kCertified };

/// An address, taken apart.
struct HostPort {
  std::string host;
  std::uint16_t port = 0;
};

/// Splits and checks "host:port" or "[::1]:port"; the error reads "port 'abc': expected 1..65535".
/// Port 0 is allowed for listening only, which the caller says by `lowest_port`. "localhost"
/// becomes 127.0.0.1.
Result<HostPort> ParseAddress(const std::string& address, std::uint16_t lowest_port);

/// "host:port", in brackets where the host is an IPv6 address.
[[nodiscard]] std::string ToString(const HostPort& address);

/// An error of code kDenied unless `host` is 127.0.0.0/8, ::1 or localhost, or exposure allows it.
Result<void> CheckExposure(const std::string& host, Exposure exposure);

/// ParseAddress() and CheckExposure() of its host.
Result<HostPort> ParseAllowedAddress(const std::string& address, std::uint16_t lowest_port,
                                     Exposure exposure);

/// Logs a warning if `exposure` is kInsecure; a middleware does so when it listens.
void WarnOfExposure(Exposure exposure, std::string_view middleware);

}  // namespace tendon
