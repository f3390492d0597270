#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <tendon/base/log.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/continuous_task.h>
#include <tendon/task/periodic_task.h>
#include <tendon/task/signal_task.h>
#include <unistd.h>

#include <atomic>
#include <memory>
#include <mutex>

#include "support/real_time_guard.h"
#include "support/wait.h"

// This test is a separate program: the guard replaces malloc, locks and system calls of the C
// library.

namespace {

using tendon_test::RealTimeGuard;
using namespace std::chrono_literals;

struct Sample {
  std::array<double, 7> value{};
};

}  // namespace

template <>
inline constexpr auto tendon::kPayload<Sample> =
    tendon::Describe("test.Sample", tendon::Field{"value", &Sample::value, "rad"});

namespace {

constexpr std::uint64_t kWarmUp = 1000;

/// A task that uses all features of a cycle: commands, events, functions and columns. After its
/// thousandth cycle, it is guarded for a given number of cycles.
template <std::derived_from<tendon::Task> Base>
class Guarded final : public Base {
 public:
  template <typename... Arguments>
  Guarded(std::string name, std::uint64_t cycles, Arguments... arguments)
      : Base(std::move(name), arguments...), last_(kWarmUp + cycles) {
    this->state_table().Add(sample_, "Sample");
    if constexpr (std::derived_from<Base, tendon::SignalTask>) {
      this->SetShortestInterval(
          1ms);  // a row takes most of the time of a cycle; periodic tasks write every row
    }
    auto& control = this->AddProvidedInterface("Control");
    control.AddCommandVoid(&Guarded::Poke, this, "Poke");
    control.AddCommandWrite(&Guarded::Set, this, "Set");
    control.AddCommandReadState(this->state_table(), sample_, "GetSample");
    control.AddEvent(changed_, "Changed");
    auto& peer = this->AddRequiredInterface("Peer");
    peer.AddFunction(poke_, "Poke");
    peer.AddFunction(set_, "Set");
    peer.AddFunction(get_sample_, "GetSample");
    peer.AddEventHandlerWrite(&Guarded::OnChanged, this, "Changed");
  }

  /// A mistake in a guarded cycle, for tests of the guard.
  std::function<void()> mistake;
  std::atomic<bool> is_done = false;
  std::atomic<std::uint64_t> handled = 0;  // number of executed commands and events
  RealTimeGuard::Counts counts;            // set when `is_done` is true

 private:
  void Run() override {
    this->ProcessQueuedCommands();
    sample_.value[0] = static_cast<double>(++cycle_);
    if (cycle_ % 16384 != 0) (void)poke_();  // otherwise a signal task would not sleep
    if (cycle_ % 8 == 1) {                   // only sometimes, because a million cycles take long
      (void)set_(sample_);
      (void)get_sample_(read_);
      changed_(sample_);
    }
    if (cycle_ == kWarmUp) RealTimeGuard::Arm();
    if (cycle_ == kWarmUp + 5 && mistake) mistake();
    if (cycle_ != last_) return;
    counts = RealTimeGuard::Disarm();
    is_done = true;
  }
  void Poke() {
    handled.store(handled.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
  void Set(const Sample& /*sample*/) { Poke(); }
  void OnChanged(const Sample& /*sample*/) { Poke(); }

  std::uint64_t last_;
  std::uint64_t cycle_ = 0;
  Sample sample_;
  Sample read_;
  tendon::WriteEvent<Sample> changed_;
  tendon::VoidFunction poke_;
  tendon::WriteFunction<Sample> set_;
  tendon::ReadFunction<Sample> get_sample_;
};

class Poker final : public tendon::Component {
 public:
  explicit Poker(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("Task").AddFunction(poke, "Poke");
  }
  tendon::VoidFunction poke;
};

/// Runs a guarded task that is connected to itself, while another thread sends commands to it.
template <typename Base, typename... Arguments>
RealTimeGuard::Counts Watch(std::uint64_t cycles, std::function<void()> mistake,
                            Arguments... arguments) {
  tendon::LocalManager manager;
  auto& task = manager.Add<Guarded<Base>>("task", cycles, arguments...);
  auto& poker = manager.Add<Poker>("poker");
  task.mistake = std::move(mistake);
  EXPECT_TRUE(manager.Connect({"task", "Peer"}, {"task", "Control"}).ok());
  EXPECT_TRUE(manager.Connect({"poker", "Task"}, {"task", "Control"}).ok());
  EXPECT_TRUE(manager.StartAll().ok());
  const auto is_over = [&] {
    (void)poker.poke();
    return task.is_done || task.state() != tendon::ComponentState::kActive;
  };
  while (!is_over()) std::this_thread::sleep_for(20us);
  EXPECT_TRUE(task.is_done) << task.fault();
  EXPECT_GT(task.handled, cycles / 2);
  EXPECT_TRUE(manager.StopAll().ok());
  return task.counts;
}

struct RealTimeCycle : testing::Test {
  void SetUp() override {
    if (!RealTimeGuard::IsAvailable()) GTEST_SKIP() << "no guard together with sanitizers";
    RecordProperty("sees_every_system_call", RealTimeGuard::SeesEverySystemCall() ? "yes" : "no");
  }

  static void ExpectNothing(const RealTimeGuard::Counts& counts) {
    EXPECT_EQ(counts.allocations, 0U);
    EXPECT_EQ(counts.locks, 0U);
    EXPECT_EQ(counts.system_calls, 0U) << "the last was number " << counts.last_system_call;
  }
};

TEST_F(RealTimeCycle, OfAContinuousTaskAllocatesLocksAndCallsNothing) {
  ExpectNothing(Watch<tendon::ContinuousTask>(1'000'000, {}));
}

TEST_F(RealTimeCycle, OfASignalTaskAllocatesLocksAndCallsNothing) {
  const auto counts = Watch<tendon::SignalTask>(1'000'000, {});

  ExpectNothing(counts);
  EXPECT_GT(counts.sleeps, 0U);
}

TEST_F(RealTimeCycle, OfAPeriodicTaskAllocatesLocksAndCallsNothing) {
  const auto counts = Watch<tendon::PeriodicTask>(100'000, {}, 20us);

  ExpectNothing(counts);
  EXPECT_GT(counts.sleeps, 0U);
}

TEST_F(RealTimeCycle, MayLog) {
  std::atomic<int> heard = 0;
  static std::atomic<int>* hearer = nullptr;
  hearer = &heard;
  tendon::AddLogSink([](tendon::LogLevel, std::string_view source, std::string_view) {
    if (hearer != nullptr && source == "guarded") ++*hearer;
  });
  const auto log = [] {
    for (int i = 0; i < 10; ++i) {
      tendon::Log(tendon::LogLevel::kWarning, "guarded", "the third joint is near its limit");
    }
  };

  ExpectNothing(Watch<tendon::PeriodicTask>(100, log, 1ms));

  EXPECT_TRUE(EventuallyTrue([&] { return heard == 10; }));
  hearer = nullptr;
}

TEST_F(RealTimeCycle, AnAllocationIsDetected) {
  const auto mistake = [] { EXPECT_NE(std::make_unique<std::vector<int>>(100), nullptr); };

  EXPECT_GE(Watch<tendon::ContinuousTask>(10, mistake).allocations, 2U);
}

TEST_F(RealTimeCycle, ALockIsDetected) {
  std::mutex mutex;

  const auto counts =
      Watch<tendon::SignalTask>(10, [&mutex] { const std::scoped_lock lock(mutex); });

  EXPECT_EQ(counts.locks, 1U);
}

TEST_F(RealTimeCycle, ASystemCallIsDetected) {
  const auto counts = Watch<tendon::PeriodicTask>(
      10, [] { syscall(SYS_getppid); }, 1ms);

  EXPECT_EQ(counts.system_calls, 1U);
  EXPECT_EQ(counts.last_system_call, SYS_getppid);
  if (!RealTimeGuard::SeesEverySystemCall()) return;
  EXPECT_EQ(Watch<tendon::PeriodicTask>(
                10, [] { (void)getppid(); }, 1ms)
                .system_calls,
            1U);
}

}  // namespace
