#include <program/exit_code.h>
#include <tendon/recording/mcap/verify.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/recorded_samples.h"

namespace faults {
namespace {

namespace fs = std::filesystem;
namespace mcap = tendon::mcap;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::StartsWith;

/// A file that `gcm save-last` has written, and the report about it.
struct Saved {
  Outcome outcome;
  json report;
  std::unique_ptr<mcap::Reader> file;
};

/// Saves what the processes have kept, without a recording that was started before. The process
/// `witness` has a table, events and log records, and is never disturbed.
class SaveLastFaults : public FaultTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(StartGcm());
    ASSERT_NO_FATAL_FAILURE(StartViewer());
    desk_ = MakeLcm("witness");
    ASSERT_NO_FATAL_FAILURE(Follow("witness", "herald", herald_));
  }
  void StartRobot() {
    robot_ = MakeLcm("robot");
    ASSERT_NO_FATAL_FAILURE(Follow("robot", "ledger", ledger_));
  }
  void Follow(const std::string& process, const std::string& component,
              const std::shared_ptr<NewestNumber>& newest) {
    ASSERT_TRUE(EventuallyActive(process, component)) << Gcm({"ls"}).out;
    viewer_->telemetry().Subscribe({process, component, "state", {"Sample"}}, newest);
    ASSERT_TRUE(Eventually([&] { return newest->number() > 0; }));
  }

  /// Starts `gcm save-last`. A process that does not answer delays it by a part of the time limit.
  [[nodiscard]] std::unique_ptr<Program> StartSaving(const fs::path& file, const std::string& last,
                                                     const Words& paths) const {
    Words words{Built("bin/gcm"),
                "--gcm",
                gcm_address_,
                "--timeout",
                std::to_string(Timeout().count() / 4),
                "--middleware",
                GetParam(),
                "--json",
                "save-last",
                last,
                "-o",
                file,
                "--compression",
                "none"};
    words.insert(words.end(), paths.begin(), paths.end());
    return std::make_unique<Program>(words, environment());
  }
  /// Waits for the end of `gcm save-last`. Expects that it has written an intact file.
  static void Finish(Program& saving, const fs::path& path, Saved& saved) {
    const auto exit_code = saving.Wait(std::chrono::ceil<std::chrono::seconds>(3 * Timeout()));
    saved.outcome = {exit_code.value_or(-1), saving.out(), saving.err()};
    saved.report = json::parse(saved.outcome.out, nullptr, false);
    ASSERT_FALSE(saved.report.is_discarded()) << saved.outcome.out << saved.outcome.err;
    auto reader = mcap::Reader::Open(path);
    ASSERT_TRUE(reader) << reader.error().message;
    saved.file = *std::move(reader);
    const auto verified = mcap::Verify(*saved.file);
    EXPECT_EQ(verified.problems.count(), 0U) << verified.problems.first().front().sentence;
  }
  /// Saves the last seconds of healthy processes. If MayExpireLeases(), a healthy process may seem
  /// to hang, so it is tried again.
  void SaveWhole(const std::string& last, const Words& paths, Saved& saved) {
    ASSERT_TRUE(Eventually([&] {
      const fs::path path = NextFile();
      Finish(*StartSaving(path, last, paths), path, saved);
      return HasFatalFailure() || saved.outcome.exit_code == program::kOk || !MayExpireLeases();
    }));
    ASSERT_EQ(saved.outcome.exit_code, program::kOk) << saved.outcome.out << saved.outcome.err;
  }
  [[nodiscard]] fs::path NextFile() {
    return home_.path() / ("last" + std::to_string(files_++) + ".mcap");
  }
  static json PartOf(const Saved& saved, const std::string& name) {
    return saved.report.value(name, json::array());
  }
  /// Returns the part of the report about a table.
  static json TableOf(const Saved& saved, const std::string& path) {
    for (const json& table : PartOf(saved, "tables")) {
      if (table["path"] == path) return table;
    }
    ADD_FAILURE() << path << " is not in " << saved.report.dump(2);
    return json::object();
  }
  static json ProcessOf(const Saved& saved, const std::string& name) {
    for (const json& process : PartOf(saved, "processes")) {
      if (process["process"] == name) return process;
    }
    ADD_FAILURE() << name << " is not in " << saved.report.dump(2);
    return json::object();
  }

  /// Expects that the rows, events and log records of the witness are in the file, without gaps
  /// that the file does not tell, up to the sample `newest`.
  void ExpectWholeWitness(const Saved& saved, std::uint64_t newest) const {
    const json table = TableOf(saved, "witness/herald/state");
    // The processor time may not suffice for the thread that keeps the rows.
    const auto numbers = NumbersIn(*saved.file, "witness/herald/state", Gaps::kReported);
    EXPECT_EQ(numbers.size(), table.value("rows", std::size_t{0}));
    EXPECT_EQ(PartOf(saved, "events").size(), 1U);
    if (MayExpireLeases() && table.contains("error")) return;
    EXPECT_FALSE(table.contains("error")) << table.dump();
    ASSERT_FALSE(numbers.empty());
    EXPECT_GE(numbers.back(), newest);
    const auto events = EventsIn(*saved.file, "witness/herald/Control/Passed");
    ASSERT_GE(events.size(), 2U) << saved.report.dump(2);
    EXPECT_GE(events.back(), newest / kEach * kEach);
    for (std::size_t i = 1; i < events.size(); ++i) EXPECT_EQ(events[i], events[i - 1] + kEach);
    std::vector<std::uint64_t> logged;
    for (const std::string& text : LogIn(*saved.file, "witness/herald")) {
      if (text.starts_with(kPassed)) logged.push_back(std::stoull(text.substr(kPassed.size())));
    }
    ASSERT_GE(logged.size(), 2U) << saved.report.dump(2);
    for (std::size_t i = 1; i < logged.size(); ++i) {
      EXPECT_EQ(logged[i], logged[i - 1] + kEach) << "the GCM has sent it as well";
    }
  }
  void ExpectWitnessGoesOn() const {
    EXPECT_TRUE(
        Eventually([this, before = herald_->number()] { return herald_->number() > before; }));
  }

  /// Expects that the file has some of the rows of `well`, and that the report has their number. If
  /// not all of them had arrived before the interruption, the report must name this reason.
  void ExpectPartOfWell(const Saved& saved, const std::string& reason) const {
    const json table = TableOf(saved, "well/fountain/state");
    const auto numbers = NumbersIn(*saved.file, "well/fountain/state", Gaps::kReported);
    ASSERT_GE(numbers.size(), 64U) << "the first chunk has more";
    EXPECT_EQ(numbers.size(), table.value("rows", std::size_t{0}));
    if (table.contains("error")) {
      EXPECT_THAT(table.value("error", ""), HasSubstr(reason));
    } else {
      EXPECT_GE(numbers.back(), fountain_->number());
    }
  }

  /// Starts the process `well`. Then it has kept about 15 MiB of rows, and adds no more.
  void StartWell();
  /// Starts `gcm save-last` of `well` and the witness. Stops this program when it has written a
  /// part of the rows of `well`.
  std::unique_ptr<Program> StopInTheMiddle(fs::path& path);
  /// Sends the signal to the process `well` while it answers, and expects that the file has the
  /// rows from before the signal, and the whole witness.
  void InterruptWhileItAnswers(int signal);

  static constexpr std::uint64_t kEach = 100;  // an event and a log record for each of so many rows
  inline static const std::string kPassed = "passed ";
  const std::shared_ptr<NewestNumber> ledger_ = std::make_shared<NewestNumber>();
  const std::shared_ptr<NewestNumber> herald_ = std::make_shared<NewestNumber>();
  const std::shared_ptr<NewestNumber> fountain_ = std::make_shared<NewestNumber>();

 private:
  std::size_t files_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Over, SaveLastFaults, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(SaveLastFaults, TheLastSecondsAreInTheFileAlthoughNothingWasRecording) {
  ASSERT_NO_FATAL_FAILURE(StartRobot());
  constexpr std::uint64_t kSixSeconds = 6000;  // a sample is at least a millisecond
  ASSERT_TRUE(Eventually(
      [&] { return ledger_->number() > kSixSeconds && herald_->number() > kSixSeconds; }));
  const std::uint64_t newest_of_ledger = ledger_->number();
  const std::uint64_t newest_of_herald = herald_->number();
  Saved saved;

  ASSERT_NO_FATAL_FAILURE(SaveWhole("5s", {"robot", "witness"}, saved));

  // The table of the ledger itself holds a minute.
  const auto numbers = NumbersIn(*saved.file, "robot/ledger/state", Gaps::kNone);
  const json ledger = TableOf(saved, "robot/ledger/state");
  EXPECT_EQ(numbers.size(), ledger.value("rows", std::size_t{0}));
  ASSERT_FALSE(numbers.empty());
  EXPECT_GE(numbers.back(), newest_of_ledger);
  EXPECT_EQ(PartOf(saved, "losses"), json::array());
  ExpectWholeWitness(saved, newest_of_herald);
  const json herald = TableOf(saved, "witness/herald/state");
  if (!MayExpireLeases()) {
    EXPECT_GT(ledger.value("seconds", 0.0), 4.0);
    EXPECT_GT(herald.value("seconds", 0.0), 4.0) << "its table holds one second";
  }
  Tell(ledger.dump() + ", " + herald.dump());
}

TEST_P(SaveLastFaults, AStoppedProcessIsNamedAndTheOthersAreInTheFile) {
  ASSERT_NO_FATAL_FAILURE(StartRobot());
  ASSERT_TRUE(Eventually([&] { return ledger_->number() > 500 && herald_->number() > 500; }));
  robot_->Signal(SIGSTOP);
  ASSERT_TRUE(Eventually([&] { return HasStopped(robot_->pid()); }));
  const std::uint64_t newest = herald_->number();
  const fs::path path = NextFile();
  Saved saved;

  const Stopwatch watch;
  ASSERT_NO_FATAL_FAILURE(Finish(*StartSaving(path, "5s", {"robot", "witness"}), path, saved));
  const long took = watch.milliseconds();

  EXPECT_EQ(saved.outcome.exit_code, program::kPartial) << saved.outcome.err;
  EXPECT_THAT(ProcessOf(saved, "robot").value("reached_back", ""), StartsWith("not known: "));
  const json ledger = TableOf(saved, "robot/ledger/state");
  EXPECT_EQ(ledger.value("rows", std::size_t{1}), 0U);
  EXPECT_THAT(ledger.value("error", ""), HasSubstr("process 'robot'"));
  ASSERT_NO_FATAL_FAILURE(ExpectWholeWitness(saved, newest));
  ExpectWitnessGoesOn();
  Tell("after " + std::to_string(took) + " ms: " + ledger.value("error", ""));

  robot_->Signal(SIGCONT);
  ASSERT_TRUE(EventuallyIs("robot", tendon::ProcessState::kAlive)) << robot_->err();
  ASSERT_TRUE(
      Eventually([this, before = ledger_->number()] { return ledger_->number() > before; }));
  Saved again;
  ASSERT_NO_FATAL_FAILURE(SaveWhole("5s", {"robot", "witness"}, again));
  EXPECT_FALSE(NumbersIn(*again.file, "robot/ledger/state", Gaps::kNone).empty());
}

void SaveLastFaults::StartWell() {
  robot_ = std::make_unique<Program>(
      Command("lcm", {"--name", "well", "--system", home_.path() / "system.json",
                      "--history-memory", "16MiB", "--history-time", "10min"}),
      environment());
  ASSERT_NO_FATAL_FAILURE(Follow("well", "fountain", fountain_));
  constexpr std::uint64_t kEnough = 2000;  // samples of 8 KiB
  ASSERT_TRUE(Eventually([&] { return fountain_->number() > kEnough && herald_->number() > 500; }));
  // From now on, no kept row is replaced by a newer one.
  const Outcome suspended = Gcm({"suspend", "well/fountain"});
  ASSERT_EQ(suspended.exit_code, program::kOk) << suspended.err;
}

std::unique_ptr<Program> SaveLastFaults::StopInTheMiddle(fs::path& path) {
  constexpr std::uintmax_t kFirstChunk = std::uintmax_t{1} << 19U;  // a chunk has 1 MiB
  constexpr std::uintmax_t kHalf = std::uintmax_t{8} << 20U;
  const auto size = [&path] {
    std::error_code failed;
    const auto bytes = fs::file_size(path, failed);
    return failed ? 0 : bytes;
  };
  std::unique_ptr<Program> saving;
  EXPECT_TRUE(Eventually([&] {
    path = NextFile();
    saving = StartSaving(path, "10min", {"well", "witness"});
    if (!Eventually([&] { return size() > kFirstChunk; })) return false;
    saving->Signal(SIGSTOP);
    const auto has_stopped = [&] {
      return HasStopped(saving->pid()) || saving->Wait(std::chrono::seconds(0));
    };
    return Eventually(has_stopped) && size() < kHalf;
  })) << saving->err();
  return saving;
}

void SaveLastFaults::InterruptWhileItAnswers(int signal) {
  ASSERT_NO_FATAL_FAILURE(StartWell());
  fs::path path;
  const auto saving = StopInTheMiddle(path);
  const std::uint64_t newest = herald_->number();
  Saved saved;

  robot_->Signal(signal);
  ASSERT_TRUE(Eventually([&] { return signal == SIGKILL || HasStopped(robot_->pid()); }));
  saving->Signal(SIGCONT);
  ASSERT_NO_FATAL_FAILURE(Finish(*saving, path, saved));

  EXPECT_EQ(saved.outcome.exit_code, program::kPartial) << saved.outcome.err;
  ASSERT_NO_FATAL_FAILURE(ExpectPartOfWell(saved, "well"));
  EXPECT_THAT(PartOf(saved, "losses"),
              Contains(StartsWith("well: its log could not be read completely: ")));
  ASSERT_NO_FATAL_FAILURE(ExpectWholeWitness(saved, newest));
  ExpectWitnessGoesOn();
  Tell(TableOf(saved, "well/fountain/state").dump() + ", " + PartOf(saved, "losses").dump());
}

TEST_P(SaveLastFaults, AProcessThatIsStoppedWhileItAnswersIsNamedAndTheRestIsInTheFile) {
  ASSERT_NO_FATAL_FAILURE(InterruptWhileItAnswers(SIGSTOP));
  ASSERT_TRUE(HasStopped(robot_->pid()));
}

TEST_P(SaveLastFaults, AProcessThatIsKilledWhileItAnswersIsNamedAndTheRestIsInTheFile) {
  ASSERT_NO_FATAL_FAILURE(InterruptWhileItAnswers(SIGKILL));
  EXPECT_TRUE(EventuallyIs("well", tendon::ProcessState::kLost));
}

TEST_P(SaveLastFaults, AnInterruptedSaveLastLeavesAnIntactFileAndSaysThatItIsAPart) {
  ASSERT_NO_FATAL_FAILURE(StartWell());
  fs::path path;
  const auto saving = StopInTheMiddle(path);
  Saved saved;

  saving->Signal(SIGINT);
  saving->Signal(SIGCONT);
  ASSERT_NO_FATAL_FAILURE(Finish(*saving, path, saved));

  EXPECT_EQ(saved.outcome.exit_code, program::kInterrupted) << saved.outcome.err;
  EXPECT_EQ(saved.outcome.err,
            "gcm: interrupted; " + path.string() + " has only what was saved until then\n");
  ASSERT_NO_FATAL_FAILURE(ExpectPartOfWell(saved, "the saving was interrupted"));
  const json herald = TableOf(saved, "witness/herald/state");
  EXPECT_EQ(herald.value("rows", std::size_t{1}), 0U);
  EXPECT_EQ(herald.value("error", ""), "the saving was interrupted");
}

}  // namespace
}  // namespace faults
