#pragma once

#include <tendon/interface/offer.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/proxy/proxy_reports.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace tendon {

/// Represents a read command of another process. The caller's thread sends the request and waits
/// for the reply, for at most `deadline`. Fails with kTimeout, or with kNotConnected if the
/// connection has ended.
class ReadOfferProxy final : public Offer {
 public:
  /// The remote command.
  struct Remote {
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;
    std::chrono::milliseconds deadline{0};
    RefusedPayloads* refused_payloads = nullptr;  ///< logs arguments that are too large
  };
  ReadOfferProxy(MemberDescription description, Remote remote)
      : Offer(std::move(description)), remote_(std::move(remote)) {}

  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

 private:
  Remote remote_;
};

/// Returns the status that the caller gets for a refused kRead or kWait request. Returns nothing if
/// `error` is not a refusal by the peer.
[[nodiscard]] std::optional<Status> StatusOfRefusal(const Error& error);

/// Returns the byte for a status, which follows the value in the reply to a kRead or kWait request.
[[nodiscard]] inline std::byte CodeOf(Status status) {
  return static_cast<std::byte>(status.code());
}
void AppendStatus(Status status, Bytes& reply);
/// Removes the status from the end of `reply` and returns it. Returns kInvalid if the status is
/// missing, invalid or kQueued.
Status TakeStatus(std::span<const std::byte>& reply);
Status TakeStatus(Bytes& reply);

}  // namespace tendon
