#include <tendon/interface/execution/patient_calls.h>

namespace tendon {
namespace {

thread_local SteadyTime waits_until = SteadyTime::min();

}  // namespace

PatientCalls::PatientCalls() noexcept : before_(waits_until) {
  if (before_ == SteadyTime::min()) waits_until = SteadyClock().Now() + kPatience;
}

PatientCalls::~PatientCalls() { waits_until = before_; }

SteadyTime PatientCalls::deadline() noexcept { return waits_until; }

}  // namespace tendon
