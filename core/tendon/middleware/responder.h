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

/// Answers one request, once, from any thread, now or later. If it is destroyed without an answer,
/// the request is refused. A second answer is ignored.
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
  /// Returns memory of the link for a reply of `size` bytes (at least one), which is sent in
  /// kOwnLane. Write all bytes in this thread, then call EndReply(). If the reply is not deferred,
  /// do both before returning to the channel. Returns an empty span, without an effect, if the link
  /// has no such memory. Throws as Reply() does.
  [[nodiscard]] std::span<std::byte> BeginReply(std::size_t size);
  void EndReply();
  /// Lets a later Reply() in kOwnLane, from any thread, still take the direct path back of
  /// Delivery::kDirect. Call it in the thread that handles the request, before it returns to the
  /// channel. Returns false if the link has no such path.
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
  [[nodiscard]] ReplySlot* EmptySlot(const Channel& channel) const;
  [[nodiscard]] ReplySlot* SlotFor(Channel& channel, std::size_t size) const;
  bool ReplyInSlot(Channel& channel, std::span<const std::byte> body);

  std::weak_ptr<Channel> channel_;  // empty once answered
  std::uint64_t request_ = 0;
  std::unique_ptr<ReplySlot> later_;  // the slot for the reply, if it is deferred
};

/// While this object exists, this thread handles `request` of `channel`, and the Responder of the
/// request may write the reply to `slot` (LinkHandler::OnDirectFrame()). One object at a time in a
/// thread.
class CurrentRequest {
 public:
  CurrentRequest(const Channel& channel, std::uint64_t request, ReplySlot& slot);
  CurrentRequest(const CurrentRequest&) = delete;
  CurrentRequest& operator=(const CurrentRequest&) = delete;
  ~CurrentRequest();

  /// Null if this thread does not handle `request`.
  [[nodiscard]] static ReplySlot* SlotOf(const Channel& channel, std::uint64_t request);

 private:
  const Channel& channel_;
  const std::uint64_t request_;
  ReplySlot& slot_;
};

}  // namespace tendon
