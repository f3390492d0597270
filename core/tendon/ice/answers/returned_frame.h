#pragma once

#include <Ice/Incoming.h>
#include <tendon/ice/answers/open_calls.h>
#include <tendon/ice/links.h>

#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace tendon::ice {

/// A frame as the only parameter of what Ice sends back for a call that it dispatches.
class ReturnedFrame final : public LeftAnswer {
 public:
  ReturnedFrame(IceLink& link, IceInternal::Incoming& incoming)
      : link_(link), incoming_(incoming) {}

  /// Ice gets its answer from somebody else.
  [[nodiscard]] bool is_deferred() const { return is_deferred_; }

 private:
  std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) override;
  std::unique_ptr<LeftAnswer> MakeLater() override;

  IceLink& link_;
  IceInternal::Incoming& incoming_;
  bool is_deferred_ = false;
};

/// The same of a call that Ice has dispatched before.
class LaterFrame final : public LeftAnswer {
 public:
  explicit LaterFrame(std::shared_ptr<IceLink> link) : link_(std::move(link)) {}
  LaterFrame(const LaterFrame&) = delete;
  LaterFrame& operator=(const LaterFrame&) = delete;
  ~LaterFrame() override;

  /// Once: from now on `call` is answered by this, or with nothing.
  void Take(OpenCalls::Call call) noexcept;

 private:
  std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) override;
  void Leave() override;

  const std::shared_ptr<IceLink> link_;
  OpenCalls::Call call_;
};

}  // namespace tendon::ice
