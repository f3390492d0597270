#pragma once

#include <tendon/interface/offer.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/proxy/reports/refused_payloads.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace tendon {

/// Asks for the value in the caller's thread, which waits for at most `deadline`: kTimeout, or
/// kNotConnected when the peer is gone.
class ReadOfferProxy final : public Offer {
 public:
  /// The command at the other end.
  struct Remote {
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;
    std::chrono::milliseconds deadline{0};
    RefusedPayloads* refused_payloads = nullptr;  ///< of the interface
  };
  ReadOfferProxy(MemberDescription description, Remote remote)
      : Offer(std::move(description)), remote_(std::move(remote)) {}

  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

 private:
  Remote remote_;
};

/// What a refusal of kRead or kWait means to the caller; nothing where the peer has not refused it.
[[nodiscard]] std::optional<Status> StatusOfRefusal(const Error& error);

/// Behind the value, in the body of the answer to kRead and kWait.
[[nodiscard]] inline std::byte CodeOf(Status status) {
  return static_cast<std::byte>(status.code());
}
void AppendStatus(Status status, Bytes& answer);
/// Takes it off again; kInvalid where there is none, or one that says no end: kQueued.
Status TakeStatus(std::span<const std::byte>& answer);
Status TakeStatus(Bytes& answer);

}  // namespace tendon
