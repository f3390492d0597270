#include <tendon/proxy/read_offer_proxy.h>

#include <tendon/proxy/connection_messages.h>

#include <string>
#include <utility>

namespace tendon {
namespace {

/// Returns the status of a failed read. It is never kOutcomeUnknown, because a read has no side
/// effects.
Status StatusOf(const Error& error) {
  if (const auto refusal = StatusOfRefusal(error)) return *refusal;
  switch (error.code) {
    case ErrorCode::kTimeout:
      return Status::kTimeout;
    case ErrorCode::kUnreachable:
      return Status::kNotConnected;
    default:
      return Status::kFailed;
  }
}

class ReadCommandProxy final : public CommandBase {
 public:
  ReadCommandProxy(std::string name, ReadOfferProxy::Remote remote)
      : CommandBase(layout::kNone, layout::kNone),
        name_(std::move(name)),
        remote_(std::move(remote)) {}

  Status ExecuteEncoded(std::span<const std::byte> in, ReplySink& out) override {
    if (in.size() > kMaxPayload) {
      remote_.refused_payloads->Log(name_, in.size());
      return Status::kInvalid;
    }
    const auto reply = remote_.channel->Call(message::kRead, remote_.handle, in, remote_.deadline,
                                             kOwnLane, Delivery::kDirect);
    if (!reply) return StatusOf(reply.error());
    std::span<const std::byte> value = reply->body();
    const Status status = TakeStatus(value);
    if (status) out.Take(value);
    return status;
  }

 private:
  const std::string name_;
  const ReadOfferProxy::Remote remote_;
};

}  // namespace

std::unique_ptr<CommandBase> ReadOfferProxy::Bind(Mailbox* /*mailbox*/) const {
  return std::make_unique<ReadCommandProxy>(description().name, remote_);
}

std::optional<Status> StatusOfRefusal(const Error& error) {
  switch (error.code) {
    case ErrorCode::kNotFound:  // the other process is closing the interface
      return Status::kNotConnected;
    case ErrorCode::kDenied:
      return Status::kDenied;
    case ErrorCode::kInvalid:
      return Status::kInvalid;
    default:
      return std::nullopt;
  }
}

void AppendStatus(Status status, Bytes& reply) {
  reply.reserve(reply.size() + 1);  // otherwise push_back() would double the capacity
  reply.push_back(CodeOf(status));
}

Status TakeStatus(std::span<const std::byte>& reply) {
  if (reply.empty() || reply.back() > static_cast<std::byte>(Status::kFailed)) {
    return Status::kInvalid;
  }
  const auto code = static_cast<Status::Code>(reply.back());
  reply = reply.first(reply.size() - 1);
  return code == Status::kQueued ? Status::kInvalid : code;
}

Status TakeStatus(Bytes& reply) {
  std::span<const std::byte> rest = reply;
  const Status status = TakeStatus(rest);
  reply.resize(rest.size());
  return status;
}

}  // namespace tendon
