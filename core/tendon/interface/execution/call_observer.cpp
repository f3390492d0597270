#include <tendon/interface/execution/call_observer.h>

#include <algorithm>
#include <array>

namespace tendon {
namespace {

/// Takes the empty reply of a handler.
class EmptyReplySink final : public ReplySink {
 public:
  std::span<std::byte> Room(std::size_t size) override {
    return std::span<std::byte>(none_).first(std::min(size, none_.size()));
  }
  void Take(std::span<const std::byte> /*reply*/) override {}

 private:
  std::array<std::byte, kEncodedSize<None>> none_{};
};

}  // namespace

void CallEvent::Raise(const ArgumentWriter& call) noexcept {
  CallHandlers([&call](CommandBase& handler) {
    // The codec may throw, which is no fault of the component.
    return ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {
      EmptyReplySink nothing;
      return handler.ExecuteFrom(call, nothing);
    });
  });
}

void CallEvent::OnSubscribersChanged(bool has_subscribers) {
  if (is_observed_ == nullptr || is_observed_->Get() == has_subscribers) return;
  // A caller that sees the flag may rely on it, so the mailboxes are marked before.
  if (has_subscribers && inbox_ != nullptr) inbox_->AddObserver();
  is_observed_->Set(has_subscribers);
  if (!has_subscribers && inbox_ != nullptr) inbox_->RemoveObserver();
}

}  // namespace tendon
