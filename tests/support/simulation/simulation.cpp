#include <support/simulation/fiber.h>
#include <support/simulation/simulation.h>

#include <algorithm>
#include <cassert>
#include <memory>
#include <optional>
#include <utility>

namespace tendon::simulation {
namespace {

using Location = MemoryModel::Location;

/// The decisions of one execution, in order. The next execution repeats these decisions up to the
/// last one that has an untried alternative. There it takes the alternative.
class Decisions {
 public:
  std::size_t Take(std::size_t alternatives) {
    if (alternatives <= 1) return 0;
    if (position_ == taken_.size()) taken_.push_back({0, alternatives});
    assert(taken_[position_].alternatives == alternatives);
    return taken_[position_++].choice;
  }

  /// Returns false when every alternative has been tried.
  bool Next() {
    position_ = 0;
    while (!taken_.empty() && ++taken_.back().choice == taken_.back().alternatives) {
      taken_.pop_back();
    }
    return !taken_.empty();
  }

 private:
  struct Decision {
    std::size_t choice;
    std::size_t alternatives;
  };
  std::vector<Decision> taken_;
  std::size_t position_ = 0;
};

/// One execution. Only one thread runs at a time. At each step, another thread may continue
/// instead.
class Execution {
 public:
  Execution(Decisions& decisions, const Limits& limits)
      : decisions_(decisions), preemptions_(limits.preemptions), stale_reads_(limits.stale_reads) {}

  void Run(const std::function<void(Scenario&)>& build);
  [[nodiscard]] std::string Failure() const;
  void Fail(std::string_view sentence);

  std::uint64_t Load(Location location, std::memory_order order);
  void Store(Location location, std::uint64_t value, std::memory_order order);
  std::uint64_t Modify(Location location, std::memory_order order,
                       const std::function<std::uint64_t(std::uint64_t)>& change);
  void Fence(std::memory_order order) { memory.Fence(running, order); }
  void AwaitAnyStore();
  void Sleep(Location location, std::uint64_t expected);
  void Wake(Location location);
  /// Lets other threads run before the next operation of this thread.
  void Step();

  MemoryModel memory;
  std::size_t running = kSetUp;

 private:
  struct Thread {
    std::unique_ptr<Fiber> fiber;
    std::optional<Location> sleeps_on;
    std::optional<std::size_t> awaits_more_stores_than;
    std::size_t stores_at_first_load = 0;  // since the last AwaitAnyStore()
    bool has_loaded = false;
  };
  struct Operation {
    std::size_t thread;
    std::string_view what;
    Location location;
    std::uint64_t value;
  };

  [[nodiscard]] bool CanRun(std::size_t thread) const;
  [[nodiscard]] std::vector<std::size_t> OthersThatCanRun() const;
  void SwitchTo(std::size_t thread);
  void RunAll();
  void RunToTheEnd();
  void Note(std::string_view what, Location location, std::uint64_t value);

  Decisions& decisions_;
  int preemptions_;
  int stale_reads_;
  std::vector<Thread> threads_{1};
  std::size_t next_ = kSetUp;  // the next thread, chosen by the running one
  std::size_t stores_ = 0;
  std::vector<Operation> operations_;
  std::string failure_;
};

thread_local Execution* current = nullptr;

void Execution::Run(const std::function<void(Scenario&)>& build) {
  Scenario scenario;
  build(scenario);
  assert(scenario.threads.size() < MemoryModel::kMaxThreads);
  for (const auto& body : scenario.threads) {
    memory.Fork(kSetUp, threads_.size());
    threads_.emplace_back().fiber = std::make_unique<Fiber>(body);
  }
  RunAll();
  if (!failure_.empty()) RunToTheEnd();
  running = kSetUp;
  for (std::size_t thread = 1; thread < threads_.size(); ++thread) memory.Join(kSetUp, thread);
  if (failure_.empty() && scenario.finally) scenario.finally();
  // The shared objects end together with this execution.
  for (Thread& thread : threads_) thread.fiber.reset();
}

void Execution::RunAll() {
  running = kSetUp;
  while (failure_.empty()) {
    if (next_ == kSetUp) {
      const auto candidates = OthersThatCanRun();
      const auto unfinished = [](const Thread& thread) {
        return thread.fiber != nullptr && !thread.fiber->has_ended();
      };
      if (candidates.empty()) {
        if (std::ranges::any_of(threads_, unfinished))
          Fail("every thread waits, and none will wake");
        return;
      }
      next_ = candidates[decisions_.Take(candidates.size())];
    }
    running = std::exchange(next_, kSetUp);
    threads_[running].fiber->Resume();
    if (threads_[running].fiber->has_ended()) running = kSetUp;
  }
}

/// Called after a failure. Lets the threads run to their end, so that their stacks are unwound.
void Execution::RunToTheEnd() {
  constexpr int kTurns = 10'000;
  for (int turn = 0; turn < kTurns; ++turn) {
    for (running = 1; running < threads_.size(); ++running) {
      if (!threads_[running].fiber->has_ended()) threads_[running].fiber->Resume();
    }
  }
}

bool Execution::CanRun(std::size_t thread) const {
  const Thread& state = threads_[thread];
  if (state.fiber == nullptr || state.fiber->has_ended() || state.sleeps_on) return false;
  return !state.awaits_more_stores_than || stores_ > *state.awaits_more_stores_than;
}

std::vector<std::size_t> Execution::OthersThatCanRun() const {
  std::vector<std::size_t> found;
  for (std::size_t thread = 1; thread < threads_.size(); ++thread) {
    if (thread != running && CanRun(thread)) found.push_back(thread);
  }
  return found;
}

void Execution::SwitchTo(std::size_t thread) {
  next_ = thread;
  threads_[running].fiber->Yield();
}

void Execution::Step() {
  if (running == kSetUp || !failure_.empty() || preemptions_ == 0) return;
  const auto others = OthersThatCanRun();
  const std::size_t choice = decisions_.Take(1 + others.size());
  if (choice == 0) return;
  --preemptions_;
  SwitchTo(others[choice - 1]);
}

std::uint64_t Execution::Load(Location location, std::memory_order order) {
  Step();
  if (order == std::memory_order_seq_cst) memory.Fence(running, order);
  Thread& state = threads_[running];
  if (!state.has_loaded) state.stores_at_first_load = stores_;
  state.has_loaded = true;
  std::size_t choice = 0;
  if (running != kSetUp && failure_.empty() && stale_reads_ > 0) {
    choice = decisions_.Take(memory.Choices(running, location));
  }
  if (choice > 0) {
    --stale_reads_;
    state.stores_at_first_load = 0;  // a new value is already visible
  }
  const std::uint64_t value = memory.Load(running, location, order, choice);
  Note(choice > 0 ? "loads the old value" : "loads", location, value);
  return value;
}

void Execution::Store(Location location, std::uint64_t value, std::memory_order order) {
  Step();
  ++stores_;
  memory.Store(running, location, value, order);
  Note("stores", location, value);
}

std::uint64_t Execution::Modify(Location location, std::memory_order order,
                                const std::function<std::uint64_t(std::uint64_t)>& change) {
  Step();
  ++stores_;
  const std::uint64_t old = memory.Modify(running, location, order, change);
  Note("changes to", location, memory.Newest(location));
  return old;
}

void Execution::AwaitAnyStore() {
  Thread& state = threads_[running];
  if (running == kSetUp) return;
  state.has_loaded = false;
  if (!failure_.empty()) return SwitchTo(kSetUp);
  if (stores_ > state.stores_at_first_load) return;
  state.awaits_more_stores_than = stores_;
  SwitchTo(kSetUp);
  state.awaits_more_stores_than.reset();
}

void Execution::Sleep(Location location, std::uint64_t expected) {
  Step();
  if (memory.Newest(location) != expected) return;
  Note("sleeps on", location, expected);
  if (failure_.empty()) threads_[running].sleeps_on = location;
  SwitchTo(kSetUp);
  threads_[running].sleeps_on.reset();
}

void Execution::Wake(Location location) {
  Step();
  Note("wakes sleepers on", location, 0);
  for (Thread& thread : threads_) {
    if (thread.sleeps_on == location) thread.sleeps_on.reset();
  }
}

void Execution::Fail(std::string_view sentence) {
  if (failure_.empty()) failure_ = sentence;
}

void Execution::Note(std::string_view what, Location location, std::uint64_t value) {
  if (running != kSetUp && failure_.empty())
    operations_.push_back({running, what, location, value});
}

std::string Execution::Failure() const {
  if (failure_.empty()) return {};
  std::string text = failure_;
  for (const Operation& operation : operations_) {
    text += "\n  thread " + std::to_string(operation.thread) + ' ' + std::string(operation.what) +
            " atomic " + std::to_string(operation.location) + ": " +
            std::to_string(operation.value);
  }
  return text;
}

}  // namespace

Report Explore(const std::function<void(Scenario&)>& build, Limits limits) {
  Report report;
  Decisions decisions;
  do {
    Execution execution(decisions, limits);
    current = &execution;
    execution.Run(build);
    current = nullptr;
    ++report.executions;
    report.failure = execution.Failure();
    if (!report.failure.empty()) return report;
    if (report.executions == limits.executions) return report;
  } while (decisions.Next());
  report.is_complete = true;
  return report;
}

void Check(bool condition, std::string_view sentence) {
  if (!condition) current->Fail(sentence);
}

std::size_t RunningThread() { return current->running; }

Location AddAtomic(std::uint64_t value) {
  return current->memory.AddAtomic(current->running, value);
}
Location AddPlain() { return current->memory.AddPlain(); }
std::uint64_t Load(Location location, std::memory_order order) {
  return current->Load(location, order);
}
void Store(Location location, std::uint64_t value, std::memory_order order) {
  current->Store(location, value, order);
}
std::uint64_t Modify(Location location, std::memory_order order,
                     const std::function<std::uint64_t(std::uint64_t)>& change) {
  return current->Modify(location, order, change);
}
void Fence(std::memory_order order) { current->Fence(order); }
void ProcessBarrier() {
  current->Step();
  current->memory.ProcessBarrier();
}
void ReadPlain(Location location) {
  current->Step();
  if (!current->memory.ReadPlain(current->running, location)) {
    current->Fail("a plain read races with a write");
  }
}
void WritePlain(Location location) {
  current->Step();
  if (!current->memory.WritePlain(current->running, location)) {
    current->Fail("a plain write races");
  }
}
void AwaitAnyStore() { current->AwaitAnyStore(); }
void Sleep(Location location, std::uint64_t expected) { current->Sleep(location, expected); }
void Wake(Location location) { current->Wake(location); }

}  // namespace tendon::simulation
