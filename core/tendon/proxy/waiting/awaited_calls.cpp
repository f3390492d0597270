#include <tendon/proxy/read_proxy.h>
#include <tendon/proxy/waiting/awaited_calls.h>

#include <utility>

namespace tendon {
namespace {

/// Of a call that was sent, and to which the peer gave no result.
Status ToStatus(const Error& error) {
  switch (error.code) {
    case ErrorCode::kNotFound:  // the interface is just being closed over there
      return Status::kNotConnected;
    case ErrorCode::kDenied:
      return Status::kDenied;
    case ErrorCode::kInvalid:
      return Status::kInvalid;
    default:
      return Status::kOutcomeUnknown;
  }
}

}  // namespace

Status TakeOutcome(Result<Bytes> answer, Bytes& result) {
  if (!answer) return ToStatus(answer.error());
  result = *std::move(answer);
  return TakeStatus(result);
}

}  // namespace tendon
