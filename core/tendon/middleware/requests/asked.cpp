#include <tendon/middleware/requests/asked.h>

#include <cassert>

namespace tendon {
namespace {

thread_local const Asked* asked_here = nullptr;

}  // namespace

Asked::Asked(const Channel& channel, std::uint64_t request, LeftAnswer& answer)
    : channel_(channel), request_(request), answer_(answer) {
  assert(asked_here == nullptr);
  asked_here = this;
}

Asked::~Asked() { asked_here = nullptr; }

LeftAnswer* Asked::Find(std::uint64_t request, const Channel& channel) {
  const Asked* asked = asked_here;
  const bool is_it = asked != nullptr && &asked->channel_ == &channel && asked->request_ == request;
  return is_it ? &asked->answer_ : nullptr;
}

LeftAnswer* Asked::AnswerTo(std::uint64_t request, const Channel& channel) {
  LeftAnswer* const answer = Find(request, channel);
  return answer != nullptr && !answer->has_begun() ? answer : nullptr;
}

LeftAnswer* Asked::Begun(std::uint64_t request, const Channel& channel) {
  LeftAnswer* const answer = Find(request, channel);
  return answer != nullptr && answer->has_begun() ? answer : nullptr;
}

}  // namespace tendon
