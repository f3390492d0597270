// One of the processes whose signals are recorded: signals NAME GCM COLUMNS. Its task writes a row
// of COLUMNS doubles each millisecond. It prints an empty line when it has joined the GCM. At each
// SIGUSR1, it prints a line with the lateness of all cycles since the previous SIGUSR1, in
// nanoseconds. Runs until it is killed.

#include <tendon/base/log.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/process/process.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace std::chrono_literals;

constexpr int kPriority = 50;

class Source final : public tendon::PeriodicTask {
 public:
  Source(std::string name, int columns)
      : PeriodicTask(std::move(name), 1ms), signals_(static_cast<std::size_t>(columns)) {
    SetThreadOptions({.policy = tendon::SchedulingPolicy::kFifo, .priority = kPriority});
    for (std::size_t i = 0; i < signals_.size(); ++i) {
      state_table().Add(signals_[i], "Signal" + std::to_string(i));
    }
  }
  ~Source() override { Join(); }

  /// Adds the lateness of all cycles since the last call, in nanoseconds.
  void TakeLateness(std::vector<double>& lateness) {
    const auto& column =
        dynamic_cast<const tendon::Column<tendon::CycleStatistics>&>(*state_table().Find("Cycle"));
    tendon::CycleStatistics statistics;
    std::uint64_t lost = 0;
    next_ = column.ReadSince(next_, statistics, lost,
                             [&](const auto& /*stamp*/, const tendon::CycleStatistics& cycle) {
                               lateness.push_back(cycle.lateness * 1e9);
                             });
  }

 private:
  void Run() override {
    for (double& signal : signals_) signal += 0.001;
  }

  std::vector<double> signals_;
  std::uint64_t next_ = 0;
};

}  // namespace

int main(int /*count*/, char** words) {
  using namespace tendon;
  SetLogLevel(LogLevel::kWarning);
  sigset_t ask;
  sigemptyset(&ask);
  sigaddset(&ask, SIGUSR1);
  pthread_sigmask(SIG_BLOCK, &ask, nullptr);  // all later threads inherit this mask
  Process process(words[1],
                  {.middleware = MakeIceMiddleware(Exposure::kLoopbackOnly), .gcm = words[2]});
  Source& source = process.Add<Source>("source", std::stoi(words[3]));
  if (!process.StartAll() || !process.WaitUntilJoined(30s)) return 1;
  std::cout << std::endl;
  std::vector<double> lateness;
  while (true) {
    // Often enough, because the table holds only the last second.
    const timespec often{.tv_sec = 0, .tv_nsec = 200'000'000};
    const bool is_asked = sigtimedwait(&ask, nullptr, &often) == SIGUSR1;
    source.TakeLateness(lateness);
    if (!is_asked) continue;
    for (const double one : std::exchange(lateness, {})) std::cout << one << ' ';
    std::cout << std::endl;
  }
}
