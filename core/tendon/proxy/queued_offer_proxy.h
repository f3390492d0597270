#pragma once

#include <tendon/interface/offer.h>
#include <tendon/lockfree/counter.h>
#include <tendon/proxy/outbox.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// Returns the overflow policy of `member`. `latest_only` lists the members that keep only the
/// latest call.
[[nodiscard]] Overflow OverflowOf(const std::vector<std::string>& latest_only,
                                  const std::string& member);

/// Represents a command of another process, or an event handler of another process. Calls are
/// queued and sent to the other process. Each argument is encoded directly into a buffer, which is
/// reused. If the member keeps only the latest call, the queue here also keeps only the latest
/// call.
class QueuedOfferProxy final : public Offer {
 public:
  QueuedOfferProxy(MemberDescription description, Outbox& outbox, std::uint32_t handle);

  /// Call this before Bind() if the event handler observes a command; see
  /// RequiredInterface::ObserveCalls().
  void SetObservesCalls() { observes_calls_ = true; }

  [[nodiscard]] Mailbox::SlotShape shape() const override;
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

  /// Number of calls that were refused because the queue was full, the value was too large, or the
  /// connection had ended.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_.value(); }

 private:
  Outbox& outbox_;
  std::uint32_t handle_;
  bool observes_calls_ = false;
  mutable SharedCounter<> refused_;
};

}  // namespace tendon
