#pragma once

#include <Ice/Ice.h>
#include <tendon/ice/pending_calls.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/middleware.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace tendon::ice {

class Links;

/// One end of an Ice connection. Callbacks of Ice hold this object only by shared pointers.
class IceLink final : public Link, public std::enable_shared_from_this<IceLink> {
 public:
  /// `listener` identifies the listener that accepted the link; 0 if this process opened the link.
  IceLink(std::shared_ptr<Ice::Connection> connection, std::uint64_t listener);

  Status Send(std::span<const std::byte> frame, Delivery delivery) override;
  void Admit() override;
  void Close() override;
  [[nodiscard]] std::string peer() const override { return peer_; }
  [[nodiscard]] std::string local() const override { return local_; }
  [[nodiscard]] const Certificate* certificate() const override {
    return certificate_ ? &*certificate_ : nullptr;
  }

  /// Must be called before the first frame is delivered.
  void SetHandler(std::shared_ptr<LinkHandler> handler);
  /// Delivers one frame to the handler. Returns false if the peer may not send this frame.
  bool Deliver(std::span<const std::byte> frame);
  /// Like Deliver(), but for a frame with Delivery::kDirect. An immediate or deferred reply may be
  /// sent as the response of the Ice call.
  ///
  /// Ice queues any number of these replies and does not report when they were sent. If 2 MiB of
  /// them may be unsent, a marker is sent after them, because Ice reports when the marker was sent.
  /// If 4 MiB may be unsent, further replies are sent with Send(), which limits the unsent bytes.
  bool DeliverDirect(std::span<const std::byte> frame, ReplySlot& slot);
  /// Returns true if a reply may be sent as the response of its call: fewer than 4 MiB of these
  /// replies may be unsent.
  [[nodiscard]] bool MayReturn() const { return OnWay() < kMaxUnsentReplies; }
  /// Counts a reply of `size` bytes that was sent as the response of its call.
  void CountReturned(std::size_t size) { returned_.Add(size); }
  /// The calls with deferred replies. They are released when the link ends.
  [[nodiscard]] PendingCalls& pending_calls() { return pending_calls_; }
  /// Closes the link because of an error of the peer. The reply to the present call of the peer is
  /// still sent.
  void Fail(const Error& reason);
  void CloseAtOnce();
  /// Called kAdmissionTime after the link was accepted. Closes the link if it is not admitted yet.
  void CheckAdmission();

  // The next three functions are called with the outcome of a message. `size` is the number of
  // bytes that the link counts as unsent for this message. The functions set it to 0.

  /// Called when the message was sent. Then all earlier replies were sent, too: the first
  /// `returned_before` bytes of CountReturned().
  void OnSent(std::size_t& size, std::uint64_t returned_before);
  /// Called when the message could not be sent or has no reply. If the peer has thrown an
  /// exception, delivers a refusal of `request`.
  void OnFailed(std::size_t& size, const std::optional<FrameHeader>& request,
                const Ice::Exception& why);
  /// Called when the message was answered. `reply` is one parameter, which is a frame or empty.
  /// Its bytes are valid as long as `owner` is held. If `owner` is null, they are valid only during
  /// the call.
  void OnReply(std::size_t& size, std::span<const std::byte> reply,
               std::shared_ptr<const void> owner);

 private:
  friend class Links;

  /// The limits for reply bytes that may be unsent; see DeliverDirect().
  static constexpr std::size_t kMaxUnsentReplies = std::size_t{4} << 20U;
  static constexpr std::size_t kMarkerThreshold = std::size_t{2} << 20U;

  [[nodiscard]] std::uint64_t OnWay() const { return returned_.value() - confirmed_.Get(); }
  Status Begin(const std::shared_ptr<Ice::ObjectPrx>& peer, const std::string& operation,
               std::span<const std::byte> bytes,
               const std::optional<FrameHeader>& request = std::nullopt);
  Status Enter(std::size_t size);
  void OnNotSent(std::size_t& size);
  void SendMarker();
  bool Forward(std::span<const std::byte> frame, std::size_t most,
               std::shared_ptr<const void> owner);
  bool StartClosing(const Error& reason);
  /// Called when the connection has ended for any reason.
  void OnGone();

  const std::shared_ptr<Ice::Connection> connection_;
  const std::shared_ptr<Ice::ObjectPrx> two_way_;  // proxy of the peer's endpoint
  const std::shared_ptr<Ice::ObjectPrx> oneway_;
  const std::uint64_t listener_;
  const std::string peer_;
  const std::string local_;
  const std::optional<Certificate> certificate_;

  std::mutex delivery_;  // held while the handler is called
  std::shared_ptr<LinkHandler> handler_;

  std::mutex mutex_;
  std::optional<Error> reason_;  // the reason why the link is closed or is being closed
  std::size_t unsent_ = 0;       // in bytes; small requests count until they are answered

  /// The largest size of a frame that the peer may send; 0 after the link was closed.
  Published<std::size_t> limit_{kMaxUnauthenticatedFrameSize};
  SharedCounter<> returned_;            // bytes of all returned replies
  Published<std::uint64_t> confirmed_;  // the part of these bytes that is certainly sent
  Flag is_marker_on_way_;
  PendingCalls pending_calls_;
};

/// Returns the identity of an Endpoint, which is the same at both ends.
Ice::Identity EndpointIdentity();

}  // namespace tendon::ice
