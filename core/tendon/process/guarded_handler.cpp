#include <tendon/process/guarded_handler.h>

#include <tendon/base/text.h>

#include <algorithm>
#include <string>
#include <utility>

namespace tendon {
namespace {

std::string ActOf(const Right* right, MessageType type) {
  if (right != nullptr) return std::string(right->act);
  return "message " + std::to_string(static_cast<unsigned>(type));
}

}  // namespace

void GuardedHandler::OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                               std::span<const std::byte> body, Responder responder) {
  if (const auto refusal = Refusal(*channel, header, body)) return responder.Refuse(*refusal);
  OnAllowedRequest(channel, header, body, std::move(responder));
}

void GuardedHandler::OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                              std::span<const std::byte> body) {
  if (header.type == message::kLowerRole) {
    const auto wanted = DecodeBody<std::uint8_t>(body);
    // An unknown role counts as the lowest one.
    const bool is_operator = wanted && *wanted == static_cast<std::uint8_t>(Role::kOperator);
    role_ = std::min(role_, is_operator ? Role::kOperator : Role::kViewer);
    return;
  }
  if (!Refusal(*channel, header, body)) OnAllowedNotice(channel, header, body);
}

Role GuardedHandler::RoleOf(const Channel& channel) const {
  return std::min(role_, channel.peer().role);
}

std::optional<Error> GuardedHandler::RefusalOfLargeMessage(const Channel& channel,
                                                           const FrameHeader& header) {
  constexpr std::uint32_t kMaxOfViewers = std::uint32_t{1} << 20U;
  const Right* const right = FindRight(static_cast<std::uint16_t>(header.type));
  if (right == nullptr || !Includes(RoleOf(channel), right->role)) {
    return Refusal(channel, header, {});
  }
  if (right->role != Role::kViewer || header.size <= kMaxOfViewers) return std::nullopt;
  return Error{ErrorCode::kInvalid,
               "'" + std::string(right->act) + "' accepts messages of at most " +
                   std::to_string(kMaxOfViewers) + " bytes, got " + std::to_string(header.size)};
}

/// Returns the refusal; empty if the message is allowed.
std::optional<Error> GuardedHandler::Refusal(const Channel& channel, const FrameHeader& header,
                                             std::span<const std::byte> body) {
  const Right* right = FindRight(static_cast<std::uint16_t>(header.type));
  const Role role = RoleOf(channel);
  const bool is_allowed = right != nullptr && Includes(role, right->role);
  if (is_allowed && right->audit == Audit::kRefusals) return std::nullopt;
  const std::string act = ActOf(right, header.type);
  std::string object = Printable(ObjectOf(header, body), 256);
  if (!object.empty()) object.insert(0, " ");
  audit_.Write("one program", is_allowed ? LogLevel::kInfo : LogLevel::kWarning,
               NameAndRole(channel, role) + ": " + act + object + ": " +
                   (is_allowed ? "allowed" : "refused"));
  if (is_allowed) return std::nullopt;
  if (right == nullptr) return Error{ErrorCode::kDenied, act + " is not allowed for any role"};
  const std::string who = Printable(channel.peer().name, 64);
  const std::string needed(ToString(right->role));
  return Error{ErrorCode::kDenied, "'" + act + "' needs the role " + needed + ", but '" + who +
                                       "' is a " + std::string(ToString(role)) +
                                       " here: try again as " + needed};
}

void LowerRole(Channel& channel, Role role) {
  if (role == Role::kOperator) return;
  const bool is_said =
      static_cast<bool>(channel.Notify(message::kLowerRole, 0, static_cast<std::uint8_t>(role)));
  if (!is_said) channel.Close();
}

}  // namespace tendon
