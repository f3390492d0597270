#include <benchmarks/ram_folder.h>
#include <benchmarks/remote/remote_system.h>
#include <support/wait.h>
#include <tendon/recording/recorder.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tendon::benchmark {
namespace {

using namespace std::chrono_literals;

constexpr int kProcesses = 3;
constexpr int kSignals = 100;  // the total of all processes

/// Three processes with a hundred signals of 1 kHz in total, and a recorder in this process.
class SignalSystem {
 public:
  explicit SignalSystem(RemoteSystem& system) : system_(system) {
    const std::string program = os::ProgramFolder() / "report_signals";
    for (int i = 0; i < kProcesses; ++i) {
      const int signals = kSignals / kProcesses + (i < kSignals % kProcesses ? 1 : 0);
      names_.push_back("signals" + std::to_string(i));
      sources_.push_back(std::make_unique<Program>(
          Program::Words{program, names_.back(), system.addresses().gcm, std::to_string(signals)},
          system.environment()));
    }
    BeginClient();  // a joined process is ready for the signal of TakeLateness()
  }

  struct Recorded {
    std::uint64_t rows = 0;
    std::uint64_t lost = 0;
  };
  /// Records all signals for this time.
  Recorded Record(std::chrono::milliseconds duration) {
    BeginClient();
    auto recorder = recording::Recorder::Start(
        *client_, queue_,
        {.patterns = {"signals*/source/state.Signal*"},
         .files = {.file = folder_.path() / ("run" + std::to_string(++runs_) + ".mcap")},
         .has_log = false});
    Require(recorder.ok(), "the recording does not begin");
    Require(EventuallyTrue([&] { return (*recorder)->status().counts.rows > 0; }),
            "no row is recorded");
    std::this_thread::sleep_for(duration);
    Require((*recorder)->Stop().ok(), "the recording fails");
    const auto status = (*recorder)->status();
    const Recorded recorded{.rows = status.counts.rows, .lost = status.losses.all_rows().all()};
    std::error_code ignored;
    std::filesystem::remove((*recorder)->status().file, ignored);
    return recorded;
  }

  /// Returns the 99th percentile of the lateness since the last call, for the process with the
  /// greatest lateness.
  double TakeLateness() {
    double worst = 0;
    for (const auto& source : sources_) {
      const std::size_t said = source->out().size();
      source->Signal(SIGUSR1);
      Require(EventuallyTrue(
                  [&] { return source->out().size() > said && source->out().ends_with('\n'); }),
              "a process does not say its lateness");
      worst = std::max(worst, std::stod(source->out().substr(said)));
    }
    return worst;
  }

 private:
  /// Makes a new inbox and client. An queue serves only one recording, and a client only one queue.
  void BeginClient() {
    queue_ = std::make_shared<recording::RecordingQueue>();
    client_ = std::make_unique<GcmClient>(
        system_.Options().middleware,
        GcmClient::Options{.name = "gcm record", .address = system_.addresses().gcm}, queue_);
    Require(client_->WaitUntilWatching().ok() && EventuallyTrue([this] { return AreAllThere(); }),
            "the processes with the signals do not join");
  }
  [[nodiscard]] bool AreAllThere() const {
    const Catalogue catalogue = client_->catalogue();
    return std::ranges::all_of(names_, [&](const std::string& name) {
      return catalogue.FindComponent(name, "source") != nullptr;
    });
  }

  RemoteSystem& system_;
  const RamFolder folder_;
  std::shared_ptr<recording::RecordingQueue> queue_;
  std::unique_ptr<GcmClient> client_;
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<Program>> sources_;
  int runs_ = 0;
};

}  // namespace

std::vector<Case> RecordingLoadCases(const Effort& effort, const TheSystem& system) {
  const auto window = effort.is_tiny ? 50ms : 1000ms;
  const auto duration = effort.is_tiny ? 100ms : 60'000ms;
  // The processes exist only during these cases, because they would disturb other cases.
  const auto signals = std::make_shared<std::unique_ptr<SignalSystem>>();
  const auto begun = [=]() -> SignalSystem& {
    if (!*signals) *signals = std::make_unique<SignalSystem>(system());
    return **signals;
  };
  return {
      {.id = "W-load",
       .what = "1 kHz tasks, p99 lateness, recorded / not recorded",
       .gate = 1.2,
       .stretch = 1.05,
       .repetition =
           [=] {
             SignalSystem& one = begun();
             one.TakeLateness();
             std::this_thread::sleep_for(window);
             const double without = one.TakeLateness();
             one.Record(window);
             return std::optional(Pair{.ours = one.TakeLateness(), .floor = without});
           }},
      {.id = "W-lost",
       .what = "rows lost of 100 signals at 1 kHz in a minute",
       .unit = "1",
       .gate = 0,
       .stretch = 0,
       .repetition =
           [=] {
             const auto recorded = begun().Record(duration);
             signals->reset();
             return std::optional(Pair{.ours = static_cast<double>(recorded.lost)});
           },
       .runs_once = true},
  };
}

}  // namespace tendon::benchmark
