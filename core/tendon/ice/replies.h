#pragma once

#include <Ice/Incoming.h>
#include <tendon/ice/ice_link.h>
#include <tendon/ice/pending_calls.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace tendon::ice {

/// A slot for a reply frame that is sent as the response to the call that Ice is dispatching now.
class ImmediateReply final : public ReplySlot {
 public:
  ImmediateReply(IceLink& link, IceInternal::Incoming& incoming)
      : link_(link), incoming_(incoming) {}

  /// Returns true if the call is answered later.
  [[nodiscard]] bool is_deferred() const { return is_deferred_; }

 private:
  std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) override;
  std::unique_ptr<ReplySlot> MakeDeferred() override;

  IceLink& link_;
  IceInternal::Incoming& incoming_;
  bool is_deferred_ = false;
};

/// A slot for a reply frame that is sent as the response to a call that was dispatched earlier.
class DeferredReply final : public ReplySlot {
 public:
  explicit DeferredReply(std::shared_ptr<IceLink> link) : link_(std::move(link)) {}
  DeferredReply(const DeferredReply&) = delete;
  DeferredReply& operator=(const DeferredReply&) = delete;
  ~DeferredReply() override;

  /// Makes this object responsible for the reply to `call`, which may become an empty reply. Must
  /// be called once.
  void Take(PendingCalls::Call call) noexcept;

 private:
  std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) override;
  void OnEnd() override;

  const std::shared_ptr<IceLink> link_;
  PendingCalls::Call call_;
};

}  // namespace tendon::ice
