#include <tendon/proxy/outstanding_calls.h>
#include <tendon/proxy/read_proxy.h>

#include <utility>

namespace tendon {

Status TakeOutcome(Result<Bytes> answer, Bytes& result) {
  // If the peer has not refused the call, the call may have been executed, because it was sent.
  if (!answer) return StatusOfRefusal(answer.error()).value_or(Status::kOutcomeUnknown);
  result = *std::move(answer);
  return TakeStatus(result);
}

}  // namespace tendon
