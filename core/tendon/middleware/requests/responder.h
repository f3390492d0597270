#pragma once

#include <tendon/middleware/body.h>
#include <tendon/middleware/middleware.h>
#include <tendon/middleware/parts/lane.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace tendon {

class Channel;

/// Answers one request, once, from any thread, now or later. Dropped unanswered, it refuses; a
/// second answer is ignored.
class Responder {
 public:
  Responder(std::weak_ptr<Channel> channel, std::uint64_t request);
  Responder(Responder&& other) noexcept = default;
  Responder& operator=(Responder&& other) noexcept;
  Responder(const Responder&) = delete;
  Responder& operator=(const Responder&) = delete;
  ~Responder();

  /// Throws std::bad_alloc where memory is short; it is not answered then.
  void Reply(std::span<const std::byte> body, Lane lane = kCommonLane) {
    (void)TryReply(body, lane);
  }
  /// The same; false where it cannot be sent: then the peer is refused, if it is there.
  [[nodiscard]] bool TryReply(std::span<const std::byte> body, Lane lane = kCommonLane);
  /// Room for a Reply() in kOwnLane of `size` bytes, at least one, where it is sent from: all are
  /// written in this thread, before it returns to the channel unless deferred, and ended by
  /// EndReply(). Empty where there is no such place: then it is as if nothing had happened. Throws
  /// like Reply().
  [[nodiscard]] std::span<std::byte> BeginReply(std::size_t size);
  void EndReply();
  /// In the thread that was asked, before it returns to the channel: a later Reply() in kOwnLane,
  /// by any thread, still takes the shorter way of Link::Ask(). False where it does not, for there
  /// is none.
  bool Defer();
  void Refuse(const Error& error);

  /// Reply() or Refuse().
  template <Message T>
  void Answer(const Result<T>& result) {
    if (result) {
      Reply(EncodeBody(*result));
    } else {
      Refuse(result.error());
    }
  }
  void Answer(const Result<void>& result);

 private:
  std::weak_ptr<Channel> channel_;  // empty once answered
  std::uint64_t request_ = 0;
  std::unique_ptr<LeftAnswer> later_;  // where the answer is left, if it is deferred
};

}  // namespace tendon
