#include <tendon/middleware/requests/current_request.h>

#include <cassert>

namespace tendon {
namespace {

thread_local const Asked* asked_here = nullptr;

}  // namespace

Asked::Asked(const Channel& channel, std::uint64_t request, ReplySlot& answer)
    : channel_(channel), request_(request), answer_(answer) {
  assert(asked_here == nullptr);
  asked_here = this;
}

Asked::~Asked() { asked_here = nullptr; }

ReplySlot* Asked::Find(std::uint64_t request, const Channel& channel) {
  const Asked* asked = asked_here;
  const bool is_it = asked != nullptr && &asked->channel_ == &channel && asked->request_ == request;
  return is_it ? &asked->answer_ : nullptr;
}

ReplySlot* Asked::AnswerTo(std::uint64_t request, const Channel& channel) {
  ReplySlot* const answer = Find(request, channel);
  return answer != nullptr && !answer->has_begun() ? answer : nullptr;
}

ReplySlot* Asked::Begun(std::uint64_t request, const Channel& channel) {
  ReplySlot* const answer = Find(request, channel);
  return answer != nullptr && answer->has_begun() ? answer : nullptr;
}

}  // namespace tendon
