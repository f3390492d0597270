#include <tendon/task/thread_setup.h>

#include <tendon/base/error.h>
#include <tendon/base/log.h>
#include <tendon/base/os/thread.h>

#include <chrono>
#include <mutex>

namespace tendon {
namespace {

constexpr std::uint64_t kMaxStack = std::uint64_t{4} << 20;
constexpr std::int32_t kHighestPriority = 99;
constexpr std::int32_t kHighestProcessor = 1023;
constexpr std::chrono::milliseconds kMaxSlack(100);  // the longest allowed delay of a sleep
constexpr std::chrono::seconds kMaxSpin(1);

/// Returns a function that throws a ConfigurationError if its condition is false.
auto RequireFor(const std::string& task) {
  return [&task](bool is_right, const std::string& sentence) {
    if (!is_right) throw ConfigurationError("thread options of '" + task + "': " + sentence);
  };
}

std::string Nanoseconds(std::chrono::nanoseconds time) {
  return std::to_string(time.count()) + " ns";
}

/// Logs only the first refusal in the process, because the refusals for other tasks are probably
/// the same.
void WarnOnce(const std::string& task, const std::string& what, const std::string& reason,
              const std::string& remedy) {
  static std::once_flag once;
  std::call_once(once, [&] {
    Log(LogLevel::kWarning, task,
        "runs without " + what + ", because the system refuses it (" + reason + "); " + remedy +
            ". Further refusals in this process are not reported");
  });
}

void Apply(os::Permission permission, const std::string& task, const std::string& what,
           const std::string& remedy) {
  if (!permission.granted) WarnOnce(task, what, permission.reason, remedy);
}

}  // namespace

void CheckThreadRanges(const ThreadOptions& options, const std::string& task) {
  const auto require = RequireFor(task);
  const std::string priority = std::to_string(options.priority);
  if (options.policy == SchedulingPolicy::kNormal) {
    require(options.priority == 0,
            "priority must be 0 with the policy normal, got " + priority + "; choose fifo");
  } else {
    require(options.priority >= 1 && options.priority <= kHighestPriority,
            "priority must be 1..99 with the policy " + std::string(NameOf(options.policy)) +
                ", got " + priority);
  }
  for (const std::int32_t cpu : options.cpus) {
    require(cpu >= 0 && cpu <= kHighestProcessor,
            "a processor must be 0..1023, got " + std::to_string(cpu));
  }
  require(options.stack_bytes <= kMaxStack,
          "stack_bytes (the part of the stack that is touched before the first cycle) must be at "
          "most 4194304, got " +
              std::to_string(options.stack_bytes));
  require(options.timer_slack.count() >= 1 && options.timer_slack <= kMaxSlack,
          "timer slack must be 1 ns..100 ms, got " + Nanoseconds(options.timer_slack));
  require(options.spin.count() >= 0 && options.spin <= kMaxSpin,
          "the time to spin must be 0..1 s, got " + Nanoseconds(options.spin));
}

void CheckThreadOptions(const ThreadOptions& options, const std::string& task) {
  CheckThreadRanges(options, task);
  const auto require = RequireFor(task);
  const int processors = os::ProcessorCount();
  for (const std::int32_t cpu : options.cpus) {
    require(cpu < processors, "this machine has the processors 0.." +
                                  std::to_string(processors - 1) + ", not " + std::to_string(cpu));
  }
}

void SetUpThisThread(const ThreadOptions& options, const std::string& task) {
  os::NameThisThread(task);
  os::SetTimerSlack(static_cast<std::uint64_t>(options.timer_slack.count()));
  if (!options.cpus.empty()) {
    Apply(os::RunOnProcessors(options.cpus), task, "its selected processors",
          "check which processors this process may use");
  }
  if (options.lock_memory) {
    Apply(os::LockMemory(), task, "locked memory", "allow more with 'ulimit -l'");
  }
  if (options.stack_bytes > 0) os::TouchStack(options.stack_bytes);
  if (options.policy != SchedulingPolicy::kNormal) {
    const bool is_fifo = options.policy == SchedulingPolicy::kFifo;
    Apply(os::SetRealTimePriority(options.priority, is_fifo), task,
          "priority " + std::to_string(options.priority),
          "allow it with 'ulimit -r' or the capability CAP_SYS_NICE");
  }
}

}  // namespace tendon
