#pragma once

#include <tendon/interface/offer.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/proxy/proxy_reports.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace tendon {

/// Reads the value from the peer in the caller's thread, which waits for at most `deadline`.
/// Errors: kTimeout, or kNotConnected if the peer is gone.
class ReadOfferProxy final : public Offer {
 public:
  /// The remote command.
  struct Remote {
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;
    std::chrono::milliseconds deadline{0};
    RefusedPayloads* refused_payloads = nullptr;  ///< the list of the interface
  };
  ReadOfferProxy(MemberDescription description, Remote remote)
      : Offer(std::move(description)), remote_(std::move(remote)) {}

  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

 private:
  Remote remote_;
};

/// The caller's status for a refused kRead or kWait; empty if `error` is not a refusal by the peer.
[[nodiscard]] std::optional<Status> StatusOfRefusal(const Error& error);

/// The status follows the value in the reply to kRead and kWait.
[[nodiscard]] inline std::byte CodeOf(Status status) {
  return static_cast<std::byte>(status.code());
}
void AppendStatus(Status status, Bytes& answer);
/// Removes the status and returns it; kInvalid if it is missing or kQueued.
Status TakeStatus(std::span<const std::byte>& answer);
Status TakeStatus(Bytes& answer);

}  // namespace tendon
