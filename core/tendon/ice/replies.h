#pragma once

#include <Ice/Incoming.h>
#include <tendon/ice/links.h>
#include <tendon/ice/pending_calls.h>

#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace tendon::ice {

/// A reply frame as the only parameter of Ice's reply to the call that it is dispatching.
class ImmediateReply final : public ReplySlot {
 public:
  ImmediateReply(IceLink& link, IceInternal::Incoming& incoming)
      : link_(link), incoming_(incoming) {}

  /// True if the call is answered later.
  [[nodiscard]] bool is_deferred() const { return is_deferred_; }

 private:
  std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) override;
  std::unique_ptr<ReplySlot> MakeDeferred() override;

  IceLink& link_;
  IceInternal::Incoming& incoming_;
  bool is_deferred_ = false;
};

/// The same for a call that was dispatched earlier.
class DeferredReply final : public ReplySlot {
 public:
  explicit DeferredReply(std::shared_ptr<IceLink> link) : link_(std::move(link)) {}
  DeferredReply(const DeferredReply&) = delete;
  DeferredReply& operator=(const DeferredReply&) = delete;
  ~DeferredReply() override;

  /// Makes this object reply to `call`, perhaps with an empty reply. Call it once.
  void Take(PendingCalls::Call call) noexcept;

 private:
  std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) override;
  void OnEnd() override;

  const std::shared_ptr<IceLink> link_;
  PendingCalls::Call call_;
};

}  // namespace tendon::ice
