#include <tendon/proxy/outstanding_calls.h>

#include <tendon/proxy/read_offer_proxy.h>

#include <utility>

namespace tendon {

Status TakeOutcome(Result<Bytes> reply, Bytes& result) {
  // A call that was sent may have been executed, unless the peer has refused it.
  if (!reply) return StatusOfRefusal(reply.error()).value_or(Status::kOutcomeUnknown);
  result = *std::move(reply);
  return TakeStatus(result);
}

}  // namespace tendon
