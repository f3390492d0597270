#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/access/audit_log.h>
#include <tendon/security/rights.h>

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace tendon {
namespace message {

/// Notice, from whoever has opened a channel: Role, as std::uint8_t. From now on it has no other;
/// a higher one than before is not given.
inline constexpr auto kLowerRole = static_cast<MessageType>(0x210);

}  // namespace message

/// Where it is decided what the program at the other end of one channel may do: the same in each
/// process that serves others, LCM or GCM, for every message. What kRights does not allow to its
/// role never reaches the functions below.
///
/// What viewers may send is small: more than 1 MiB of it is refused, whoever sends it.
///
/// Under TLS a program has the role of its certificate. Who is let in on this machine without one
/// knows the user's cookie, and is an operator. Either may ask to be less. The audit log has a line
/// for each request that changes something and for each refusal.
class GuardedHandler : public ChannelHandler {
 public:
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) final;
  void OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                std::span<const std::byte> body) final;
  std::optional<Error> WhyNotTaken(const Channel& channel, const FrameHeader& header) final;

 private:
  virtual void OnAllowedRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                                std::span<const std::byte> body, Responder responder) = 0;
  virtual void OnAllowedNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                               std::span<const std::byte> body) = 0;
  /// What a request is about, for the audit log: "arm/Control.Stop". Of a body from outside, which
  /// may be malformed.
  [[nodiscard]] virtual std::string ObjectOf(const FrameHeader& header,
                                             std::span<const std::byte> body) const = 0;

  [[nodiscard]] Role RoleOf(const Channel& channel) const;
  std::optional<Error> Refusal(const Channel& channel, const FrameHeader& header,
                               std::span<const std::byte> body);

  Role role_ = Role::kOperator;  // at most this
  AuditLog audit_;
};

/// Gives up, on a channel that was just opened, what is not in `role`.
void LowerRole(Channel& channel, Role role);

}  // namespace tendon
