#include <benchmarks/memory.h>
#include <benchmarks/ram_folder.h>
#include <benchmarks/remote/remote_system.h>
#include <program/exit_code.h>
#include <support/wait.h>
#include <tendon/recording/playback.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/recording_format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace tendon::benchmark {
namespace {

using namespace std::chrono_literals;
using std::chrono::milliseconds;

constexpr std::size_t kProcesses = 3;
constexpr std::size_t kSignals = 100;  // the total of all processes

/// A recording of all signals by this program.
class SignalRecording {
 public:
  /// Returns when all processes are recorded.
  SignalRecording(const RemoteSystem& system, const std::string& pattern)
      : client_(system.Options().middleware,
                GcmClient::Options{.name = "gcm record", .address = system.addresses().gcm},
                queue_) {
    RequireDone(client_.WaitUntilWatching());
    recorder_ = Required(recording::Recorder::Start(
        client_, queue_, {.patterns = {pattern}, .files = {.file = file_}, .has_log = false}));
    const auto is_recording = [this] {
      const auto status = recorder_->status();
      return status.tables == kProcesses && status.counts.rows > 0;
    };
    Require(EventuallyTrue(is_recording), "the processes with the signals are not recorded");
  }

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Completes the file. Returns the number of rows that count as lost.
  std::uint64_t End() {
    RequireDone(recorder_->Stop());
    return recorder_->status().losses.all_rows().all();
  }

 private:
  const RamFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "signals.mcap";
  const std::shared_ptr<recording::RecordingQueue> queue_ =
      std::make_shared<recording::RecordingQueue>();
  GcmClient client_;
  std::unique_ptr<recording::Recorder> recorder_;
};

/// The lateness of the cycles of each process, ns.
using Lateness = std::array<std::vector<double>, kProcesses>;

/// Three processes with a hundred signals of 1 kHz in total. They exist only while they are
/// recorded, because they would disturb other cases.
class SignalSystem {
 public:
  /// Returns when all processes have joined.
  explicit SignalSystem(RemoteSystem& system) : name_(system.NewName() + "signals") {
    const std::string program = os::ProgramFolder() / "report_signals";
    for (std::size_t i = 0; i < kProcesses; ++i) {
      const std::size_t signals = kSignals / kProcesses + (i < kSignals % kProcesses ? 1 : 0);
      sources_.push_back(
          std::make_unique<Program>(Program::Words{program, name_ + std::to_string(i),
                                                   system.addresses().gcm, std::to_string(signals)},
                                    system.environment()));
    }
    for (const auto& source : sources_) (void)AwaitLine(*source, 0);
  }

  /// The paths of all signals, to record them. Processes of earlier cases have other names.
  [[nodiscard]] std::string pattern() const { return name_ + "*/source/state.Signal*"; }

  /// Adds the lateness of all cycles of this time.
  void AddLateness(milliseconds duration, Lateness& to) {
    TakeLateness();
    std::this_thread::sleep_for(duration);
    const Lateness taken = TakeLateness();
    for (std::size_t i = 0; i < kProcesses; ++i) {
      to[i].insert(to[i].end(), taken[i].begin(), taken[i].end());
    }
  }

 private:
  /// Returns the lateness since the last call.
  Lateness TakeLateness() {
    Lateness lateness;
    for (std::size_t i = 0; i < kProcesses; ++i) {
      const std::size_t said = sources_[i]->out().size();
      sources_[i]->Signal(SIGUSR1);
      std::istringstream values(AwaitLine(*sources_[i], said));
      for (double one = 0; values >> one;) lateness[i].push_back(one);
    }
    return lateness;
  }

  /// Returns the line after the first `said` bytes of the output.
  static std::string AwaitLine(const Program& source, std::size_t said) {
    std::string out;
    const auto has_line = [&] {
      out = source.out();
      return out.size() > said && out.ends_with('\n');
    };
    Require(EventuallyTrue(has_line), "a process with signals does not reply");
    return out.substr(said);
  }

  const std::string name_;  // the beginning of the names of the processes
  std::vector<std::unique_ptr<Program>> sources_;
};

/// Compares the 99th percentiles of the lateness, of all cycles with a recorder and of all cycles
/// without one. Returns the process with the greatest ratio. Recorder and no recorder alternate in
/// the order 0 1 1 0 0 1 1 0, so that a disturbance that lasts for some segments, and one that
/// grows, have the same effect on both.
Pair CompareLateness(RemoteSystem& system, int segments, milliseconds segment) {
  constexpr double kShare = 0.99;
  SignalSystem signals(system);
  Lateness recorded;
  Lateness alone;
  for (int i = 0; i < segments; ++i) {
    std::optional<SignalRecording> recording;
    if (i % 4 == 1 || i % 4 == 2) recording.emplace(system, signals.pattern());
    signals.AddLateness(segment, recording ? recorded : alone);
  }
  Pair worst{.ours = 0, .floor = 1};
  for (std::size_t i = 0; i < kProcesses; ++i) {
    Require(!recorded[i].empty() && !alone[i].empty(), "a process has no cycles");
    const Pair one{.ours = Quantile(recorded[i], kShare), .floor = Quantile(alone[i], kShare)};
    if (one.ours / *one.floor > worst.ours / *worst.floor) worst = one;
  }
  return worst;
}

/// The rows of a table in a file.
struct TableRows {
  std::uint64_t rows = 0;
  std::uint64_t lost = 0;        // counted as lost between the first and the last row
  std::uint64_t lost_since = 0;  // counted as lost since the last row
  std::uint64_t first_tick = 0;
  std::uint64_t last_tick = 0;

  [[nodiscard]] std::uint64_t written() const { return last_tick - first_tick + 1; }
};

std::string TableOf(const std::string& column) { return column.substr(0, column.rfind('.')); }

/// Throws unless the file has all signals of all processes, each table has written at least this
/// many rows, and each of them is in the file, with all its signals, or counted as lost.
void CheckRows(const std::filesystem::path& file, std::uint64_t least) {
  const auto playback = Required(recording::Playback::Open(Required(mcap::Reader::Open(file))));
  std::map<std::string, std::string> first_columns;  // by table
  for (const std::string& path : playback->columns()) first_columns.emplace(TableOf(path), path);
  std::vector<std::string> chosen;
  for (const auto& [table, path] : first_columns) chosen.push_back(path);
  playback->Choose(chosen);
  std::map<std::string, TableRows> tables;
  playback->PlayUpTo(playback->last_time(), [&](const recording::PlayedItem& item) {
    if (const auto* const value = std::get_if<recording::PlayedValue>(&item.content)) {
      TableRows& table = tables[TableOf(value->channel->path)];
      const std::uint64_t lost_before = std::exchange(table.lost_since, 0);
      if (table.rows++ == 0) {
        table.first_tick = value->tick;
      } else {
        table.lost += lost_before;
      }
      table.last_tick = value->tick;
    } else if (const auto* const loss = std::get_if<recording::Loss>(&item.content)) {
      tables[loss->path].lost_since += loss->table + loss->network + loss->recorder;
    }
  });
  for (const auto& [path, table] : tables) {
    if (table.rows + table.lost == table.written() && table.written() >= least) continue;
    throw std::runtime_error(path + " has written " + std::to_string(table.written()) +
                             " rows, and at least " + std::to_string(least) +
                             " are expected; its recording has " + std::to_string(table.rows) +
                             " rows and counts " + std::to_string(table.lost) + " as lost");
  }
  std::map<std::string, std::uint64_t> values;  // by column
  for (const auto& [id, count] : playback->reader().statistics().value().channel_message_counts) {
    values[recording::MetadataValue(*playback->reader().FindChannel(id), recording::kPathKey)] +=
        count;
  }
  const auto is_complete = [&](const auto& column) {
    const auto table = tables.find(TableOf(column.first));
    return table != tables.end() && table->second.rows == column.second;
  };
  const auto signals = static_cast<std::size_t>(std::ranges::count_if(values, is_complete));
  if (tables.size() == kProcesses && signals == kSignals) return;
  throw std::runtime_error("the recording has all rows of " + std::to_string(signals) +
                           " signals in " + std::to_string(tables.size()) +
                           " tables; it must have " + std::to_string(kSignals) + " in " +
                           std::to_string(kProcesses));
}

/// A long recording by the program gcm.
struct LongRecording {
  double growth = 0;  // of the memory of gcm after a tenth of the time, MB
  double size = 0;    // of the file, MB
};

/// Looks at the memory of gcm 600 times, once in each `pause`, and records meanwhile.
LongRecording RecordLong(RemoteSystem& system, milliseconds pause, std::uint64_t least) {
  constexpr int kLooks = 600;
  constexpr double kMega = 1e6;
  const SignalSystem signals(system);
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "long.mcap";
  Program gcm({TENDON_GCM, "record", signals.pattern(), "--no-log", "-o", file, "--gcm",
               system.addresses().gcm},
              system.environment());
  Require(EventuallyTrue([&] { return gcm.err().find("recording") != std::string::npos; }),
          "gcm record does not begin");
  std::vector<double> memory;
  for (int i = 0; i < kLooks; ++i) {
    std::this_thread::sleep_for(pause);
    memory.push_back(MemoryFigure(std::to_string(gcm.pid()), "VmRSS"));
  }
  gcm.Signal(SIGINT);
  if (gcm.Wait() != program::kInterrupted) {
    throw std::runtime_error("gcm record fails: " + gcm.err());
  }
  CheckRows(file, least);
  const auto later = memory.begin() + kLooks / 10;
  return {.growth = (*std::max_element(later, memory.end()) - *later) / kMega,
          .size = static_cast<double>(std::filesystem::file_size(file)) / kMega};
}

}  // namespace

std::vector<Case> RecordingLoadCases(const Effort& effort, const TheSystem& system) {
  const bool is_tiny = effort.is_tiny;
  // A task skips the cycles in which the machine stalls.
  const auto least_of = [is_tiny](std::uint64_t cycles) { return is_tiny ? 1 : cycles / 100 * 95; };
  const auto long_recording = [=, made = std::make_shared<std::optional<LongRecording>>()] {
    if (!*made) *made = RecordLong(system(), is_tiny ? 5ms : 1000ms, least_of(600'000));
    return **made;
  };
  return {
      {.id = "W-load",
       .what = "1 kHz tasks, p99 lateness in 60 s, recorded / not",
       .gate = 1.2,
       .stretch = 1.05,
       .repetition =
           [=] {
             return std::optional(
                 CompareLateness(system(), is_tiny ? 2 : 24, is_tiny ? 100ms : 5000ms));
           },
       .runs_once = true},
      {.id = "W-lost",
       .what = "rows lost of 100 signals at 1 kHz in a minute",
       .unit = "1",
       .gate = 0,
       .stretch = 0,
       .repetition =
           [=] {
             const SignalSystem signals(system());
             SignalRecording recording(system(), signals.pattern());
             std::this_thread::sleep_for(is_tiny ? 300ms : 60'000ms);
             const std::uint64_t lost = recording.End();
             CheckRows(recording.file(), least_of(60'000));
             return std::optional(Pair{.ours = static_cast<double>(lost)});
           },
       .runs_once = true},
      {.id = "W-flat",
       .what = "growth of gcm record's memory, minutes 1 to 10",
       .unit = "MB",
       .gate = 8,
       .repetition = [=] { return std::optional(Pair{.ours = long_recording().growth}); },
       .runs_once = true},
      {.id = "W-size",
       .what = "the file of these 10 minutes",
       .unit = "MB",
       .repetition = [=] { return std::optional(Pair{.ours = long_recording().size}); },
       .runs_once = true},
  };
}

}  // namespace tendon::benchmark
