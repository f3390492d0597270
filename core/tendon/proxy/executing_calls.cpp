#include <tendon/proxy/executing_calls.h>

#include <tendon/middleware/reply_batch.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace tendon {

void ExecutingCalls::SendReplies(SteadyTime now, SteadyTime& next) {
  const ReplyBatcher together;
  auto kept = executing_.begin();
  for (ExecutingCall& executing : executing_) {
    if (now >= executing.deadline || executing.command->HasEnded(executing.call)) {
      End(executing, Status::kTimeout);
      continue;
    }
    next = std::min({next, executing.deadline, now + kNextLook});
    if (&executing != &*kept) *kept = std::move(executing);
    ++kept;
  }
  executing_.erase(kept, executing_.end());
  // If new calls began recently, the network thread checks at this interval. A new call then need
  // not wake it for the first check.
  if (now - newest_ < kNextLook) next = std::min(next, now + kNextLook);
}

void ExecutingCalls::GiveUp() {
  const ReplyBatcher together;
  for (ExecutingCall& executing : executing_) End(executing, Status::kNotConnected);
  executing_.clear();
}

void ExecutingCalls::End(ExecutingCall& executing, Status if_not_started) {
  const Status status = executing.command->EndEncoded(executing.call, result_);
  if (!status) result_.clear();
  owner_.OnEnd(executing, status == Status(Status::kTimeout) ? if_not_started : status, result_);
}

void AppendTimeout(std::chrono::nanoseconds timeout, Bytes& argument) {
  const auto count = static_cast<std::uint64_t>(timeout.count());
  argument.resize(argument.size() + sizeof count);
  std::memcpy(argument.data() + argument.size() - sizeof count, &count, sizeof count);
}

std::optional<std::chrono::nanoseconds> TakeTimeout(std::span<const std::byte>& argument) {
  std::uint64_t count = 0;
  if (argument.size() < sizeof count) return std::nullopt;
  argument = argument.first(argument.size() - sizeof count);
  std::memcpy(&count, argument.data() + argument.size(), sizeof count);
  const auto longest = static_cast<std::uint64_t>(kLongestWait.count());
  return std::chrono::nanoseconds(static_cast<std::int64_t>(std::min(count, longest)));
}

}  // namespace tendon
