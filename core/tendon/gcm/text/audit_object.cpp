#include <tendon/gcm/gcm_messages.h>
#include <tendon/gcm/text/audit_object.h>
#include <tendon/middleware/body.h>

namespace tendon {
namespace {

std::string ObjectOf(const message::LifeOrder& order) {
  const std::string& object = order.component.empty() ? order.library : order.component;
  const std::string class_name = order.class_name.empty() ? "" : " of " + order.class_name;
  return std::string(ToString(order.verb)) + " " + order.process + "/" + object + class_name;
}

}  // namespace

std::string AuditObject(MessageType type, std::span<const std::byte> body) {
  if (type == message::kForget) {
    const auto forget = DecodeBody<message::Forget>(body);
    return forget ? forget->process : std::string();
  }
  if (type == message::kSetLogLevel) {
    const auto order = DecodeBody<message::SetLogLevel>(body);
    return order ? order->process : std::string();
  }
  if (type == message::kLife) {
    const auto order = DecodeBody<message::LifeOrder>(body);
    return order ? ObjectOf(*order) : std::string();
  }
  if (type == message::kProcess) {
    const auto order = DecodeBody<message::ProcessOrder>(body);
    return order ? std::string(ToString(order->verb)) + " " + order->process : std::string();
  }
  const bool has_ends =
      type == message::kConnect || type == message::kReplace || type == message::kDisconnect;
  const auto wire = has_ends ? DecodeBody<message::Wire>(body) : Result(message::Wire());
  if (!has_ends || !wire) return {};
  const bool has_provided = type != message::kDisconnect;
  return ToString(wire->required) + (has_provided ? " " + ToString(wire->provided) : "");
}

}  // namespace tendon
