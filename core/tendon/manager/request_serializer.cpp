#include <tendon/manager/request_serializer.h>

#include <tendon/task/task.h>

#include <algorithm>

namespace tendon {

RequestSerializer::Turn::Turn(RequestSerializer& serializer, const Component& component,
                              std::unique_lock<std::recursive_mutex>& lock, SteadyTime deadline)
    : serializer_(serializer), component_(component) {
  const SteadyTime last = std::max<SteadyTime>(deadline, SteadyClock().Now() + kShortest);
  while (!serializer_.in_progress_.insert(&component_).second) {
    const SteadyTime now = SteadyClock().Now();
    is_ours_ = now < last;
    if (!is_ours_) return;
    constexpr std::chrono::milliseconds kBetweenLooks(10);
    serializer_.ended_.wait_until(lock, std::min<SteadyTime>(last, now + kBetweenLooks));
  }
}

RequestSerializer::Turn::~Turn() {
  if (!is_ours_) return;
  serializer_.in_progress_.erase(&component_);
  serializer_.ended_.notify_all();
}

bool RequestSerializer::IsInUse(const Component& component) const {
  return std::ranges::any_of(in_progress_, [&component](const Component* one) {
    return one == &component || RunsAfter(*one, component);
  });
}

}  // namespace tendon
