#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <tendon/base/log.h>
#include <tendon/base/os/thread.h>
#include <tendon/payload/json.h>
#include <tendon/task/thread_setup.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/task/scripted.h"
#include "support/refusal.h"
#include "support/wait.h"

namespace {

using tendon::SchedulingPolicy;
using tendon::ThreadOptions;
using tendon_test::Periodic;
using namespace std::chrono_literals;

TEST(ThreadOptions, TheThreadRunsOnItsProcessorsWithItsSlackUnderItsName) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Periodic>("a-task-of-a-long-name", 1ms);
  cpu_set_t allowed;
  ASSERT_EQ(sched_getaffinity(0, sizeof(allowed), &allowed), 0);
  int last = 0;
  for (int cpu = 0; cpu < tendon::os::ProcessorCount(); ++cpu) {
    if (CPU_ISSET(static_cast<std::size_t>(cpu), &allowed)) last = cpu;
  }
  task.SetThreadOptions({.cpus = {last}, .timer_slack = 123us});
  std::atomic<int> processors = 0;
  std::atomic<int> slack = 0;
  std::array<char, 16> name{};
  task.on_run = [&] {
    if (task.runs > 1) return;
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof(set), &set) == 0) processors = CPU_COUNT(&set);
    prctl(PR_GET_NAME, name.data());
    slack = prctl(PR_GET_TIMERSLACK);
  };
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] { return task.runs > 1; }));
  ASSERT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(processors, 1);
  EXPECT_EQ(slack, 123000);
  EXPECT_STREQ(name.data(), "a-task-of-a-lon");
}

TEST(ThreadOptions, TheThreadHasItsPolicyAndPriorityIfAllowed) {
  std::string refusal;
  std::thread([&] { refusal = tendon::os::SetRealTimePriority(3, true).reason; }).join();
  if (!refusal.empty()) GTEST_SKIP() << "real-time priorities are refused here: " << refusal;
  tendon::LocalManager manager;
  auto& fifo = manager.Add<Periodic>("fifo", 1ms);
  auto& shared = manager.Add<Periodic>("shared", 1ms);
  fifo.SetThreadOptions({.policy = SchedulingPolicy::kFifo, .priority = 3});
  shared.SetThreadOptions({.policy = SchedulingPolicy::kRoundRobin, .priority = 2});
  struct Found {
    std::atomic<int> policy = -1;
    std::atomic<int> priority = -1;
    void Look() {
      sched_param parameters{};
      policy = sched_getscheduler(0);
      sched_getparam(0, &parameters);
      priority = parameters.sched_priority;
    }
  } first, second;
  fifo.on_run = [&] { first.Look(); };
  shared.on_run = [&] { second.Look(); };

  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] { return fifo.runs > 1 && shared.runs > 1; }));
  ASSERT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(first.policy, SCHED_FIFO);
  EXPECT_EQ(first.priority, 3);
  EXPECT_EQ(second.policy, SCHED_RR);
  EXPECT_EQ(second.priority, 2);
}

TEST(ThreadOptions, TheStackIsMappedBeforeTheFirstCycle) {
  std::thread([] {
    const auto faults = [] {
      rusage usage{};
      getrusage(RUSAGE_THREAD, &usage);
      return usage.ru_minflt;
    };
    tendon::os::TouchStack(1 << 20);
    const long before = faults();
    tendon::os::TouchStack(1 << 20);
    EXPECT_LT(faults() - before, 20);  // 256, if the pages were not present
  }).join();
}

TEST(ThreadOptions, ASpinningTaskIsNeverEarly) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Periodic>("task", 1ms);
  task.SetThreadOptions({.spin = 200us});
  std::atomic<int> early = 0;
  task.on_run = [&] {
    if (task.Newest<tendon::CycleStatistics>("Cycle").lateness < 0.0) ++early;
  };

  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(EventuallyTrue([&] { return task.runs > 50; }));
  ASSERT_TRUE(manager.StopAll().ok());

  EXPECT_EQ(early, 0);
}

/// Prints the log of a process without privileges about its thread options, and how its tasks run.
[[noreturn]] void RunWithoutPrivileges() {
  rlimit none{0, 0};
  setrlimit(RLIMIT_RTPRIO, &none);
  setrlimit(RLIMIT_MEMLOCK, &none);
  if (geteuid() == 0 && setuid(65534) != 0) std::_Exit(2);
  static std::atomic<int> warnings = 0;
  tendon::AddLogSink([](tendon::LogLevel level, std::string_view, std::string_view text) {
    const bool is_refusal = text.find("refuses") != text.npos;
    if (level == tendon::LogLevel::kWarning && is_refusal) ++warnings;
    std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data());
  });
  tendon::LocalManager manager;
  const ThreadOptions wanted{
      .policy = SchedulingPolicy::kFifo, .priority = 50, .lock_memory = true};
  auto& first = manager.Add<Periodic>("first", 1ms);
  auto& second = manager.Add<Periodic>("second", 1ms);
  first.SetThreadOptions(wanted);
  second.SetThreadOptions(wanted);
  const bool started = manager.StartAll().ok();
  const bool runs = EventuallyTrue([&] { return first.runs > 3 && second.runs > 3; });
  (void)manager.StopAll();
  std::_Exit(started && runs && warnings == 1 ? 0 : 1);
}

TEST(ThreadOptionsDeathTest, ARefusedPrivilegeWarnsOncePerProcess) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(
      RunWithoutPrivileges(), testing::ExitedWithCode(0),
      "runs without locked memory, because the system refuses it .*; allow more with 'ulimit -l'. "
      "Further refusals in this process are not reported");
}

/// Returns the amount of locked memory of this process, as reported by the kernel.
std::string LockedMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmLck:")) return line;
  }
  return "";
}

[[noreturn]] void RunWithLockedMemory() {
  tendon::LocalManager manager;
  auto& task = manager.Add<Periodic>("task", 1ms);
  task.SetThreadOptions({.lock_memory = true, .stack_bytes = 65536});
  if (!manager.StartAll().ok()) std::_Exit(1);
  const bool is_locked = LockedMemory().find(" 0 kB") == std::string::npos;
  (void)manager.StopAll();
  std::_Exit(is_locked || !tendon::os::LockMemory().granted ? 0 : 1);
}

TEST(ThreadOptionsDeathTest, LocksTheMemoryOfTheProcessIfAllowed) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(RunWithLockedMemory(), testing::ExitedWithCode(0), "");
}

TEST(ThreadOptions, RefusesInvalidValues) {
  const auto refusal = [](const ThreadOptions& options) {
    return tendon::test::Refusal([&] { tendon::CheckThreadOptions(options, "arm"); });
  };
  const int processors = tendon::os::ProcessorCount();

  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({.priority = 5}),
            "thread options of 'arm': priority must be 0 with the policy normal, got 5; choose "
            "fifo");
  EXPECT_EQ(refusal({.policy = SchedulingPolicy::kFifo}),
            "thread options of 'arm': priority must be 1..99 with the policy fifo, got 0");
  EXPECT_EQ(refusal({.policy = SchedulingPolicy::kRoundRobin, .priority = 100}),
            "thread options of 'arm': priority must be 1..99 with the policy round_robin, got 100");
  EXPECT_EQ(refusal({.cpus = {processors}}),
            "thread options of 'arm': this machine has the processors 0.." +
                std::to_string(processors - 1) + ", not " + std::to_string(processors));
  EXPECT_THAT(refusal({.cpus = {-1}}), testing::EndsWith("a processor must be 0..1023, got -1"));
  EXPECT_THAT(refusal({.stack_bytes = 5 << 20}),
              testing::HasSubstr("must be at most 4194304, got 5242880"));
  EXPECT_THAT(refusal({.timer_slack = 0ns}),
              testing::EndsWith("timer slack must be 1 ns..100 ms, got 0 ns"));
  EXPECT_EQ(refusal({.timer_slack = 100ms}), "");
  EXPECT_THAT(refusal({.timer_slack = 100ms + 1ns}),
              testing::EndsWith("timer slack must be 1 ns..100 ms, got 100000001 ns"));
  EXPECT_THAT(refusal({.spin = -1ns}),
              testing::EndsWith("the time to spin must be 0..1 s, got -1 ns"));
  EXPECT_THAT(refusal({.spin = 1s + 1ns}), testing::EndsWith("0..1 s, got 1000000001 ns"));
}

TEST(ThreadOptions, AcceptsProcessorsThatOtherMachinesHave) {
  const ThreadOptions options{.cpus = {1023}};

  EXPECT_NO_THROW(tendon::CheckThreadRanges(options, "arm"));
  EXPECT_THAT(tendon::test::Refusal([] { tendon::CheckThreadRanges({.cpus = {1024}}, "arm"); }),
              testing::HasSubstr("0..1023, got 1024"));
}

TEST(ThreadOptions, AreAPayload) {
  const ThreadOptions options{.policy = SchedulingPolicy::kFifo,
                              .priority = 80,
                              .cpus = {0, 1},
                              .lock_memory = true,
                              .stack_bytes = 65536,
                              .spin = 50us};

  const auto read = tendon::FromJson<ThreadOptions>(tendon::ToJson(options));

  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(*read, options);
}

}  // namespace
