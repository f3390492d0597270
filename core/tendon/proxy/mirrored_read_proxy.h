#pragma once

#include <tendon/interface/offer.h>
#include <tendon/proxy/mirrored_value.h>

#include <memory>
#include <utility>

namespace tendon {

/// Answers a read from the local copy of a value, without asking the peer. kNoSample before the
/// first copy, kDisabled while the command is disabled there, kNotConnected when the peer is gone.
class MirroredReadProxy final : public Offer {
 public:
  MirroredReadProxy(MemberDescription description, std::shared_ptr<const MirroredValue> value)
      : Offer(std::move(description)), value_(std::move(value)) {}

  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

 private:
  const std::shared_ptr<const MirroredValue> value_;
};

}  // namespace tendon
