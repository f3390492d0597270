#include <tendon/manager/watchdog.h>

#include <tendon/base/os/thread.h>
#include <tendon/task/task.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace tendon {
namespace {

/// Returns a time as text: "10 ms", "0.5 ms".
std::string InFourDigits(std::chrono::duration<double> time) {
  constexpr int kDigits = 4;
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.begin(), text.end(), time.count() * 1e3,
                                 std::chars_format::general, kDigits)
                       .ptr;
  return std::string(text.data(), end) + " ms";
}

}  // namespace

Watchdog::~Watchdog() {
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
  }
  stopped_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Watchdog::Watch(const Task& task) {
  const std::scoped_lock lock(mutex_);
  tasks_.push_back({.task = &task, .warning = {}});
  if (!thread_.joinable()) thread_ = std::thread([this] { Run(); });
}

void Watchdog::Forget(const Component& component) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(tasks_, [&component](const WatchedTask& one) { return one.task == &component; });
}

std::string Watchdog::WarningOf(const Component& component) const {
  const std::scoped_lock lock(mutex_);
  const auto found =
      std::find_if(tasks_.begin(), tasks_.end(),
                   [&component](const WatchedTask& one) { return one.task == &component; });
  return found == tasks_.end() ? std::string() : found->warning;
}

bool Watchdog::IsOverdue(std::chrono::duration<double> period,
                         std::chrono::nanoseconds since_last_cycle) {
  return period.count() > 0.0 && since_last_cycle > kPeriods * period + kGrace;
}

void Watchdog::Inspect(SteadyTime now) {
  std::vector<Finding> findings;
  {
    const std::scoped_lock lock(mutex_);
    for (WatchedTask& one : tasks_) Check(one, now, findings);
  }
  for (const Finding& one : findings) Log(one.level, one.task, one.text);
  if (!findings.empty()) on_change_();
}

void Watchdog::Check(WatchedTask& watched, SteadyTime now, std::vector<Finding>& findings) {
  const Task& task = *watched.task;
  const std::chrono::duration<double> period = task.started_period();
  const std::chrono::nanoseconds elapsed = task.SinceLastCycle(now);
  const bool is_overdue = IsOverdue(period, elapsed);
  if (is_overdue == !watched.warning.empty()) return;
  if (is_overdue) {
    watched.since = now - elapsed;
    watched.warning = "missed " + std::to_string(static_cast<std::int64_t>(elapsed / period)) +
                      " x " + InFourDigits(period);
    findings.push_back(
        {task.name(), LogLevel::kWarning,
         watched.warning + ": the last cycle began " + InFourDigits(elapsed) + " ago"});
  } else {
    watched.warning.clear();
    findings.push_back({task.name(), LogLevel::kInfo,
                        "is no longer overdue, after " + InFourDigits(now - watched.since)});
  }
}

void Watchdog::Run() {
  os::NameThisThread("watchdog");
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    stopped_.wait_for(lock, kBetweenLooks);
    if (stopping_) return;
    lock.unlock();
    Inspect(SteadyClock().Now());
    lock.lock();
  }
}

}  // namespace tendon
