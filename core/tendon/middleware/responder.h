#pragma once

#include <tendon/middleware/body.h>
#include <tendon/middleware/middleware.h>
#include <tendon/middleware/part_sender.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace tendon {

class Channel;

/// Replies to one request. The reply can be sent at once or later, from any thread. If this object
/// is destroyed before it has replied, the request is refused. A second reply is ignored.
class Responder {
 public:
  Responder(std::weak_ptr<Channel> channel, std::uint64_t request);
  Responder(Responder&& other) noexcept = default;
  Responder& operator=(Responder&& other) noexcept;
  Responder(const Responder&) = delete;
  Responder& operator=(const Responder&) = delete;
  ~Responder();

  /// Sends the reply. Throws std::bad_alloc if there is not enough memory; then the request is not
  /// answered yet.
  void Reply(std::span<const std::byte> body, Lane lane = kCommonLane) {
    (void)TryReply(body, lane);
  }
  /// Like Reply(), but returns false if the reply cannot be sent. Then the request is refused, if
  /// the peer is still connected.
  [[nodiscard]] bool TryReply(std::span<const std::byte> body, Lane lane = kCommonLane);
  /// Returns memory of the link for a reply of `size` bytes (at least one) on kOwnLane, so that the
  /// reply need not be copied. Returns an empty span, and changes nothing, if the link has no such
  /// memory. Throws like Reply().
  ///
  /// The caller must write all bytes in this thread and then call EndReply(). If the reply is not
  /// deferred, this must be done before the thread returns to the channel.
  [[nodiscard]] std::span<std::byte> BeginReply(std::size_t size);
  void EndReply();
  /// Keeps the direct path back (Delivery::kDirect) for a later Reply() on kOwnLane, which may be
  /// called in any thread. Must be called in the thread that handles the request, before it returns
  /// to the channel. Returns false if the link has no such path.
  bool Defer();
  void Refuse(const Error& error);

  /// Calls Reply() or Refuse(), depending on the result.
  template <Message T>
  void ReplyWith(const Result<T>& result) {
    if (result) {
      Reply(EncodeBody(*result));
    } else {
      Refuse(result.error());
    }
  }
  void ReplyWith(const Result<void>& result);

 private:
  [[nodiscard]] ReplySlot* EmptySlot(const Channel& channel) const;
  [[nodiscard]] ReplySlot* SlotFor(Channel& channel, std::size_t size) const;
  bool ReplyInSlot(Channel& channel, std::span<const std::byte> body);

  std::weak_ptr<Channel> channel_;  // empty when the request is answered
  std::uint64_t request_ = 0;
  std::unique_ptr<ReplySlot> later_;  // the slot for a deferred reply
};

/// Marks that this thread handles `request` of `channel`. While this object exists, the Responder
/// of the request may write the reply to `slot` (see LinkHandler::OnDirectFrame()). A thread may
/// have only one object at a time.
class CurrentRequest {
 public:
  CurrentRequest(const Channel& channel, std::uint64_t request, ReplySlot& slot);
  CurrentRequest(const CurrentRequest&) = delete;
  CurrentRequest& operator=(const CurrentRequest&) = delete;
  ~CurrentRequest();

  /// Returns the slot for the reply to `request`; null if this thread does not handle this request.
  [[nodiscard]] static ReplySlot* SlotOf(const Channel& channel, std::uint64_t request);

 private:
  const Channel& channel_;
  const std::uint64_t request_;
  ReplySlot& slot_;
};

}  // namespace tendon
