#pragma once

#include <Ice/Ice.h>
#include <tendon/base/clock.h>
#include <tendon/ice/answers/open_calls.h>
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
struct Ends {
  std::string local = "unknown";
  std::string peer = "unknown";
};

/// One connection of Ice, either end of it. What Ice calls back holds it by shared pointers only.
class IceLink final : public Link, public std::enable_shared_from_this<IceLink> {
 public:
  /// `door` names the listener that accepted it, or is 0.
  IceLink(std::shared_ptr<Ice::Connection> connection, std::uint64_t door);

  Status Send(std::span<const std::byte> frame) override;
  Status Ask(std::span<const std::byte> frame) override;
  void Admit() override;
  void Close() override;
  [[nodiscard]] std::string peer() const override { return peer_; }
  [[nodiscard]] std::string local() const override { return local_; }
  [[nodiscard]] const Certificate* certificate() const override {
    return certificate_ ? &*certificate_ : nullptr;
  }

  /// Before the first frame is delivered.
  void SetHandler(std::shared_ptr<LinkHandler> handler);
  /// One message. False where it is no frame that the peer may send.
  bool Deliver(std::span<const std::byte> frame);
  /// A frame that asks, and gets the answer, if there is one yet, where that may go back with
  /// the call. Ice does not tell when such a one has left, and keeps as many as there are: beyond 2
  /// MiB a sign is sent behind them, and beyond 4 MiB that have not left, answers go by Send() and
  /// its window. Likewise.
  bool DeliverAsked(std::span<const std::byte> frame, LeftAnswer& answer);
  /// Whether an answer may go back with its call still.
  [[nodiscard]] bool MayReturn() const { return OnWay() < kMostReturned; }
  /// An answer of so many bytes went back.
  void CountReturned(std::size_t size) { returned_.Add(size); }
  /// Of those that are answered later; released once the link ends.
  [[nodiscard]] OpenCalls& open_calls() { return open_calls_; }
  /// Closes because of what the peer did, after answering it.
  void Fail(const Error& reason);
  void CloseAtOnce();
  /// Fails unless it was admitted: it was accepted long enough ago.
  void CheckAdmission();

  // Of a message that was begun. `size` is what it takes of the window; nothing afterwards.

  /// It has left, and so has what was returned before it was begun: bytes, of all that ever was.
  void OnSent(std::size_t& size, std::uint64_t returned_before);
  /// It has not, or its answer is missing: `question` is refused where the peer has thrown.
  void OnFailed(std::size_t& size, const std::optional<FrameHeader>& question,
                const Ice::Exception& why);
  /// It was answered: with one parameter, a frame or nothing, valid as long as `owner` is held
  /// where there is one.
  void OnAnswer(std::size_t& size, std::span<const std::byte> answer,
                std::shared_ptr<const void> owner);

 private:
  friend class Links;

  /// Bytes of answers that may not have left.
  static constexpr std::size_t kMostReturned = std::size_t{4} << 20U;
  static constexpr std::size_t kManyReturned = std::size_t{2} << 20U;

  [[nodiscard]] std::uint64_t OnWay() const { return returned_.value() - left_.Get(); }
  Status Begin(const std::shared_ptr<Ice::ObjectPrx>& peer, const std::string& operation,
               std::span<const std::byte> bytes,
               const std::optional<FrameHeader>& question = std::nullopt);
  Status Enter(std::size_t size);
  void OnNotSent(std::size_t& size);
  void SendSign();
  bool HandOn(std::span<const std::byte> frame, std::size_t most,
              std::shared_ptr<const void> owner);
  bool StartClosing(const Error& reason);
  /// The connection is gone, whatever the cause.
  void OnGone();

  const std::shared_ptr<Ice::Connection> connection_;
  const std::shared_ptr<Ice::ObjectPrx> two_way_;  // to the peer's endpoint
  const std::shared_ptr<Ice::ObjectPrx> oneway_;
  const std::uint64_t door_;
  const std::string peer_;
  const std::string local_;
  const std::optional<Certificate> certificate_;

  std::mutex delivery_;  // held during a call of the handler
  std::shared_ptr<LinkHandler> handler_;

  std::mutex mutex_;
  std::optional<Error> reason_;  // why it is closed, or about to be
  std::size_t unsent_ = 0;       // bytes; those of small questions until they are answered

  Published<std::size_t> limit_{kMaxStrangersFrameSize};  // of a frame; 0 once it is closed
  SharedCounter<> returned_;                              // bytes, of all answers
  Published<std::uint64_t> left_;                         // of them, as far as is known
  Flag is_sign_on_way_;
  OpenCalls open_calls_;
};

/// The links of one communicator. Thread-safe.
class Links {
 public:
  /// From now on the connection's frames reach the link, and its end, too.
  static void Add(const std::shared_ptr<Links>& links, const std::shared_ptr<IceLink>& link);

  std::shared_ptr<IceLink> Find(const std::shared_ptr<Ice::Connection>& connection);
  std::shared_ptr<IceLink> Find(const Ends& ends);

  /// Of all of them; see OpenCalls.
  void ReleaseOldCalls(SteadyTime now);

  /// Closes the links accepted at `door`, or for 0 all that there are or will be; when it returns
  /// their handlers have heard it.
  void CloseAll(std::uint64_t door);

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_shut_ = false;
  std::map<Ice::Connection*, std::shared_ptr<IceLink>> links_;
};

/// Null where there is none.
std::shared_ptr<Ice::IPConnectionInfo> AddressIn(std::shared_ptr<Ice::ConnectionInfo> info);
Ends EndsOf(const Ice::IPConnectionInfo& address);

/// Ice leaves its sockets to whatever programs this one starts, which would hold their ports, and
/// lets the kernel pace them: not that of this connection any more (os::AdoptSocket()). Takes
/// longer the more sockets there are.
void AdoptSocket(const Ice::Connection& connection);

/// The identity of the endpoint at both ends.
Ice::Identity EndpointIdentity();

}  // namespace tendon::ice
