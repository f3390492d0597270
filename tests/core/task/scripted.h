#pragma once

#include <tendon/manager/local_manager.h>
#include <tendon/task/callback_task.h>
#include <tendon/task/continuous_task.h>
#include <tendon/task/main_task.h>
#include <tendon/task/periodic_task.h>
#include <tendon/task/signal_task.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

namespace tendon_test {

/// The functions that an author writes in a component. They count their calls. The test chooses a
/// function that throws or blocks.
class Script {
 public:
  enum Function { kNone, kConfigure, kStartup, kRun, kHandler, kCleanup };

  /// The function that throws, until the test changes it.
  std::atomic<Function> throws = kNone;
  std::atomic<bool> throws_a_number = false;  // true: throws a number instead of a std::exception
  // True: throws an exception that was caused by another one.
  std::atomic<bool> throws_nested = false;
  /// The function that blocks until the test changes this.
  std::atomic<Function> blocks = kNone;
  std::atomic<bool> is_blocked = false;  // true while the function blocks

  std::atomic<int> configures = 0;
  std::atomic<int> startups = 0;
  std::atomic<std::uint64_t> runs = 0;
  std::atomic<int> pokes = 0;
  std::atomic<int> cleanups = 0;
  std::atomic<std::thread::id> thread;  // the thread of the last Startup(), Run() or Cleanup()
  std::function<void()> on_run;         // set before the start

  void Play(Function function) {
    thread = std::this_thread::get_id();
    while (blocks == function) {
      is_blocked = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    is_blocked = false;
    if (throws != function) return;
    if (throws_a_number) throw 17;
    try {
      throw std::runtime_error("cable cut");
    } catch (const std::runtime_error&) {
      if (throws_nested) std::throw_with_nested(std::logic_error("no arm"));
      throw;
    }
  }
};

/// A component that is not a task. Its Run() is never called.
class WithoutCycles : public tendon::Component {
 public:
  using Component::Component;

 private:
  virtual void Run() {}
};

template <typename Base>
using WithRun = std::conditional_t<std::derived_from<Base, tendon::Task>, Base, WithoutCycles>;

/// A component of any kind that executes a script.
template <std::derived_from<tendon::Component> Base>
class Scripted final : public WithRun<Base>, public Script {
  static constexpr bool kIsTask = std::derived_from<Base, tendon::Task>;

 public:
  template <typename... Arguments>
  explicit Scripted(std::string name, Arguments... arguments)
      : WithRun<Base>(std::move(name), arguments...) {
    auto& control = this->AddProvidedInterface("Control");
    control.AddCommandVoid(&Scripted::Poke, this, "Poke");
    control.AddEvent(poked, "Poked");
    if constexpr (kIsTask) {
      this->state_table().Add(row_, "Runs");
      control.AddCommandReadState(this->state_table(), row_, "GetRuns");
    }
  }

  tendon::VoidEvent poked;

  const tendon::StateTable& table() const requires kIsTask { return *this->tables().front(); }
  template <typename T>
  T Newest(const char* column) const {
    T value{};
    (void)dynamic_cast<const tendon::Column<T>&>(*table().Find(column)).ReadNewest(value);
    return value;
  }

 private:
  void Configure() override {
    ++configures;
    Play(kConfigure);
  }
  void Startup() override {
    ++startups;
    Play(kStartup);
  }
  void Run() override {
    row_ = ++runs;
    if (on_run) on_run();
    if constexpr (kIsTask) this->ProcessQueuedCommands();
    Play(kRun);
  }
  void Cleanup() override {
    ++cleanups;
    Play(kCleanup);
  }
  void Poke() {
    ++pokes;
    Play(kHandler);
    poked();
  }

  std::uint64_t row_ = 0;
};

using Periodic = Scripted<tendon::PeriodicTask>;
using Continuous = Scripted<tendon::ContinuousTask>;
using Signal = Scripted<tendon::SignalTask>;
using Callback = Scripted<tendon::CallbackTask>;
using Main = Scripted<tendon::MainTask>;
using Threadless = Scripted<tendon::Component>;

/// A client without a thread: the test's thread makes its calls.
class Client final : public tendon::Component {
 public:
  explicit Client(std::string name) : Component(std::move(name)) {
    auto& server = AddRequiredInterface("Server");
    server.AddFunction(poke, "Poke");
    server.AddFunction(get_runs, "GetRuns", tendon::Need::kOptional);
  }
  tendon::VoidFunction poke;
  tendon::ReadFunction<std::uint64_t> get_runs;
};

}  // namespace tendon_test
