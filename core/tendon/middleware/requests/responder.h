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

/// Answers one request, once, from any thread, now or later. Refuses if it is destroyed unanswered.
/// Ignores a second answer.
class Responder {
 public:
  Responder(std::weak_ptr<Channel> channel, std::uint64_t request);
  Responder(Responder&& other) noexcept = default;
  Responder& operator=(Responder&& other) noexcept;
  Responder(const Responder&) = delete;
  Responder& operator=(const Responder&) = delete;
  ~Responder();

  /// Throws std::bad_alloc if memory is short; then the request is not answered yet.
  void Reply(std::span<const std::byte> body, Lane lane = kCommonLane) {
    (void)TryReply(body, lane);
  }
  /// Returns false if the answer cannot be sent; a peer that is still there then gets a refusal.
  [[nodiscard]] bool TryReply(std::span<const std::byte> body, Lane lane = kCommonLane);
  /// Returns room for a reply in kOwnLane of `size` bytes, at least one, in the memory that the
  /// link sends. Write all bytes in this thread and call EndReply(); unless deferred, before
  /// returning to the channel. Returns an empty span, without an effect, if there is no such
  /// memory. Throws as Reply() does.
  [[nodiscard]] std::span<std::byte> BeginReply(std::size_t size);
  void EndReply();
  /// Call it in the thread that handles the request, before it returns to the channel. A later
  /// Reply() in kOwnLane, from any thread, can then still take the shorter way of Link::Ask().
  /// Returns false if the link has no such way.
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
  std::unique_ptr<ReplySlot> later_;  // the place for the reply, if it is deferred
};

}  // namespace tendon
