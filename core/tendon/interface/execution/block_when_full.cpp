#include <tendon/interface/execution/block_when_full.h>

namespace tendon {
namespace {

thread_local SteadyTime waits_until = SteadyTime::min();

}  // namespace

BlockWhenFull::BlockWhenFull() noexcept : before_(waits_until) {
  if (before_ == SteadyTime::min()) waits_until = SteadyClock().Now() + kMaxWait;
}

BlockWhenFull::~BlockWhenFull() { waits_until = before_; }

SteadyTime BlockWhenFull::deadline() noexcept { return waits_until; }

}  // namespace tendon
