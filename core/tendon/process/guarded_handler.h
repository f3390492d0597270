#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/audit_log.h>
#include <tendon/security/rights.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace tendon {
namespace message {

/// A notice from the opener of a channel, whose body is a Role as std::uint8_t. From now on, the
/// opener is limited to this role. It cannot raise the role again.
inline constexpr auto kLowerRole = static_cast<MessageType>(0x210);

}  // namespace message

/// Decides what the program at the other end of a channel may do. Every LCM and every GCM checks
/// every message with this class. The functions below never get a message that kRights does not
/// allow for the peer's role.
///
/// A message above 1 MiB is refused from every peer, because viewers send only small messages.
///
/// With TLS, a program has the role that its certificate names. Without TLS, a peer on this machine
/// is an operator, because it knows the user's cookie. A peer may lower its role. The audit log has
/// a line for each refusal and for each request that changes something.
class GuardedHandler : public ChannelHandler {
 public:
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) final;
  void OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                std::span<const std::byte> body) final;
  std::optional<Error> RefusalOfLargeMessage(const Channel& channel,
                                             const FrameHeader& header) final;

 private:
  virtual void OnAllowedRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                                std::span<const std::byte> body, Responder responder) = 0;
  virtual void OnAllowedNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                               std::span<const std::byte> body) = 0;
  /// Returns the object that a request concerns, for the audit log: "arm/Control.Stop". The body is
  /// untrusted and may be malformed.
  [[nodiscard]] virtual std::string ObjectOf(const FrameHeader& header,
                                             std::span<const std::byte> body) const = 0;

  [[nodiscard]] Role RoleOf(const Channel& channel) const;
  std::optional<Error> Refusal(const Channel& channel, const FrameHeader& header,
                               std::span<const std::byte> body);

  Role role_ = Role::kOperator;  // the limit that the peer has set with kLowerRole
  AuditLog audit_;
};

/// Lowers the role of this program on a channel that it has just opened.
void LowerRole(Channel& channel, Role role);

}  // namespace tendon
