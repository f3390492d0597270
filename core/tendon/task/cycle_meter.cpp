#include <tendon/task/cycle_meter.h>

namespace tendon {
namespace {

double Seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

void CycleMeter::Start(std::chrono::duration<double> period) noexcept {
  cycle_ = {};
  summary_ = {};
  wanted_period_ = period;
  last_begin_ = {};
  CloseWindow({});
  summary_ = {};
}

void CycleMeter::Begin(SteadyTime begin, SteadyTime due) noexcept {
  if (window_begin_ == SteadyTime{}) window_begin_ = begin;
  if (compute_.count() >= kFewestCycles && begin - window_begin_ >= kWindow) CloseWindow(begin);
  cycle_.period = last_begin_ == SteadyTime{} ? 0.0 : Seconds(begin - last_begin_);
  cycle_.lateness = Seconds(begin - due);
  if (last_begin_ != SteadyTime{}) period_.Add(begin - last_begin_);
  lateness_.Add(begin - due);
  last_begin_ = begin;
}

void CycleMeter::End(SteadyTime end) noexcept {
  cycle_.compute = Seconds(end - last_begin_);
  cycle_.load = wanted_period_.count() > 0.0 ? cycle_.compute / wanted_period_.count() : 0.0;
  compute_.Add(end - last_begin_);
}

void CycleMeter::CloseWindow(SteadyTime now) noexcept {
  summary_ = {.cycles = compute_.count(),
              .period = period_.Summary(),
              .lateness = lateness_.Summary(),
              .compute = compute_.Summary()};
  period_.Clear();
  lateness_.Clear();
  compute_.Clear();
  window_begin_ = now;
}

}  // namespace tendon
