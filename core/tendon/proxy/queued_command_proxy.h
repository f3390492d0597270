#pragma once

#include <tendon/interface/offer.h>
#include <tendon/lockfree/counter.h>
#include <tendon/proxy/outbox.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// The overflow policy of `member`, given the members that keep the latest only.
[[nodiscard]] Overflow OverflowOf(const std::vector<std::string>& latest_only,
                                  const std::string& member);

/// A command of another process, or a handler of its events. Calls are sent to that process. Takes
/// encoded values only, and copies them into buffers that keep their capacity. A member that keeps
/// the latest only does so here as well.
class QueuedOfferProxy final : public Offer {
 public:
  QueuedOfferProxy(MemberDescription description, Outbox& outbox, std::uint32_t handle);

  [[nodiscard]] Mailbox::SlotShape shape() const override;
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

  /// Calls refused: no room, too large, or not connected.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_.value(); }

 private:
  Outbox& outbox_;
  std::uint32_t handle_;
  mutable SharedCounter<> refused_;
};

}  // namespace tendon
