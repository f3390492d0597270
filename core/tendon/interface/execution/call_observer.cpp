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
  is_observed_->Set(has_subscribers);
  if (inbox_ == nullptr) return;
  has_subscribers ? inbox_->AddObserver() : inbox_->RemoveObserver();
}

}  // namespace tendon
