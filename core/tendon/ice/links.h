#pragma once

#include <Ice/Ice.h>
#include <tendon/base/clock.h>
#include <tendon/ice/pending_calls.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/middleware.h>

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace tendon::ice {

class Links;

/// The two ends of a connection's socket, as "host:port".
struct SocketAddresses {
  std::string local = "unknown";
  std::string peer = "unknown";
};

/// Either end of an Ice connection. Callbacks of Ice hold it only by shared pointers.
class IceLink final : public Link, public std::enable_shared_from_this<IceLink> {
 public:
  /// `listener` identifies the listener that accepted the link; 0 if the link was opened here.
  IceLink(std::shared_ptr<Ice::Connection> connection, std::uint64_t listener);

  Status Send(std::span<const std::byte> frame, Delivery delivery) override;
  void Admit() override;
  void Close() override;
  [[nodiscard]] std::string peer() const override { return peer_; }
  [[nodiscard]] std::string local() const override { return local_; }
  [[nodiscard]] const Certificate* certificate() const override {
    return certificate_ ? &*certificate_ : nullptr;
  }

  /// Call it before the first frame is delivered.
  void SetHandler(std::shared_ptr<LinkHandler> handler);
  /// Delivers one message. Returns false if the peer may not send it.
  bool Deliver(std::span<const std::byte> frame);
  /// Like Deliver(), for a frame with Delivery::kDirect. An immediate or deferred reply may be the
  /// response of the call. Ice does not report when such replies were sent, and queues any number
  /// of them. So above 2 MiB a marker is sent after them, and while more than 4 MiB are unsent,
  /// replies use Send() and its window.
  bool DeliverAsked(std::span<const std::byte> frame, ReplySlot& answer);
  /// True if a reply may still be the response of its call.
  [[nodiscard]] bool MayReturn() const { return OnWay() < kMostReturned; }
  /// Counts a reply of `size` bytes that was the response of its call.
  void CountReturned(std::size_t size) { returned_.Add(size); }
  /// Calls with deferred replies; released when the link ends.
  [[nodiscard]] PendingCalls& pending_calls() { return pending_calls_; }
  /// Closes the link because of an error of the peer, after answering it.
  void Fail(const Error& reason);
  void CloseAtOnce();
  /// Called some time after an accept: fails the link if it is not admitted.
  void CheckAdmission();

  // Outcomes of a message. `size` is the room that it occupies in the window; it becomes 0.

  /// The message was sent. So were the first `returned_before` bytes of all replies that were the
  /// responses of calls.
  void OnSent(std::size_t& size, std::uint64_t returned_before);
  /// The message has failed, or its answer is missing. If the peer has thrown an exception, refuses
  /// `request`.
  void OnFailed(std::size_t& size, const std::optional<FrameHeader>& request,
                const Ice::Exception& why);
  /// The message was answered with one parameter: a frame or nothing. Valid as long as `owner` is
  /// held; if it is null, only during the call.
  void OnAnswer(std::size_t& size, std::span<const std::byte> answer,
                std::shared_ptr<const void> owner);

 private:
  friend class Links;

  /// Limits of reply bytes that may be unsent.
  static constexpr std::size_t kMostReturned = std::size_t{4} << 20U;
  static constexpr std::size_t kManyReturned = std::size_t{2} << 20U;

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
  /// The connection is gone, for any reason.
  void OnGone();

  const std::shared_ptr<Ice::Connection> connection_;
  const std::shared_ptr<Ice::ObjectPrx> two_way_;  // to the peer's endpoint
  const std::shared_ptr<Ice::ObjectPrx> oneway_;
  const std::uint64_t listener_;
  const std::string peer_;
  const std::string local_;
  const std::optional<Certificate> certificate_;

  std::mutex delivery_;  // held during a call of the handler
  std::shared_ptr<LinkHandler> handler_;

  std::mutex mutex_;
  std::optional<Error> reason_;  // why the link is closed, or about to be
  std::size_t unsent_ = 0;       // bytes; those of small requests count until answered

  /// Largest size of a frame; 0 once closed.
  Published<std::size_t> limit_{kMaxUnauthenticatedFrameSize};
  SharedCounter<> returned_;            // bytes of all returned replies
  Published<std::uint64_t> confirmed_;  // of these, known to be sent
  Flag is_marker_on_way_;
  PendingCalls pending_calls_;
};

/// The links of one communicator. Thread-safe.
class Links {
 public:
  /// From now on, passes the frames and the end of the link's connection to the link.
  static void Add(const std::shared_ptr<Links>& links, const std::shared_ptr<IceLink>& link);

  std::shared_ptr<IceLink> Find(const std::shared_ptr<Ice::Connection>& connection);
  std::shared_ptr<IceLink> Find(const SocketAddresses& addresses);

  /// Calls PendingCalls::ReleaseOld() of all links.
  void ReleaseOldCalls(SteadyTime now);

  /// Closes the links accepted at `listener`; for 0 all present and future links. After the return,
  /// all their handlers have got OnClosed().
  void CloseAll(std::uint64_t listener);

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_shut_ = false;
  std::map<Ice::Connection*, std::shared_ptr<IceLink>> links_;
};

/// The IP information of a connection; null if there is none.
std::shared_ptr<Ice::IPConnectionInfo> AddressIn(std::shared_ptr<Ice::ConnectionInfo> info);
SocketAddresses AddressesOf(const Ice::IPConnectionInfo& address);

/// Changes the socket of a connection (os::AdoptSocket()), so that child processes cannot inherit
/// it and hold its port, and the kernel does not pace it. The cost grows with the number of
/// sockets.
void AdoptSocket(const Ice::Connection& connection);

/// The identity of the endpoint, at both ends.
Ice::Identity EndpointIdentity();

}  // namespace tendon::ice
