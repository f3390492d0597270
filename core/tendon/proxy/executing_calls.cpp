#include <tendon/middleware/requests/reply_batcher.h>
#include <tendon/proxy/executing_calls.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace tendon {

void ExecutingCalls::Answer(SteadyTime now, SteadyTime& next) {
  const ReplyBatcher together;
  auto kept = begun_.begin();
  for (Begun& begun : begun_) {
    if (now >= begun.deadline || begun.command->HasEnded(begun.call)) {
      End(begun, Status::kTimeout);
      continue;
    }
    next = std::min({next, begun.deadline, now + kNextLook});
    if (&begun != &*kept) *kept = std::move(begun);
    ++kept;
  }
  begun_.erase(kept, begun_.end());
  // During a steady stream of calls, no call has to wake the network thread for its first check.
  if (now - newest_ < kNextLook) next = std::min(next, now + kNextLook);
}

void ExecutingCalls::GiveUp() {
  const ReplyBatcher together;
  for (Begun& begun : begun_) End(begun, Status::kNotConnected);
  begun_.clear();
}

void ExecutingCalls::End(Begun& begun, Status if_not_started) {
  const Status status = begun.command->EndEncoded(begun.call, result_);
  if (!status) result_.clear();
  owner_.OnEnd(begun, status == Status(Status::kTimeout) ? if_not_started : status, result_);
}

void AppendTimeout(std::chrono::nanoseconds timeout, Bytes& question) {
  const auto count = static_cast<std::uint64_t>(timeout.count());
  question.resize(question.size() + sizeof count);
  std::memcpy(question.data() + question.size() - sizeof count, &count, sizeof count);
}

std::optional<std::chrono::nanoseconds> TakeTimeout(std::span<const std::byte>& question) {
  std::uint64_t count = 0;
  if (question.size() < sizeof count) return std::nullopt;
  question = question.first(question.size() - sizeof count);
  std::memcpy(&count, question.data() + question.size(), sizeof count);
  const auto longest = static_cast<std::uint64_t>(kLongestWait.count());
  return std::chrono::nanoseconds(static_cast<std::int64_t>(std::min(count, longest)));
}

}  // namespace tendon
