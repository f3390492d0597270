#include <tendon/recording/mcap/copy.h>
#include <tendon/recording/mcap/verify.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "support/machine/sanitized.h"
#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/recorded_samples.h"

namespace faults {
namespace {

namespace mcap = tendon::mcap;

/// A `gcm record` of the ledger's samples that is killed.
struct KilledRecording {
  std::filesystem::path file;
  std::unique_ptr<Program> program;
  std::uint64_t begin = 0;   ///< the number of the newest sample at the start
  std::uint64_t moment = 0;  ///< the number of the sample after which the recording is killed
  /// The number of the newest sample that had arrived here before the kill.
  std::uint64_t newest = 0;
};

class RecordingFaults : public FaultTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(StartGcm());
    ASSERT_NO_FATAL_FAILURE(StartViewer());
    robot_ = MakeLcm("robot");
    ASSERT_TRUE(EventuallyActive("robot", "ledger")) << robot_->err();
    viewer_->telemetry().Subscribe({"robot", "ledger", "state", {"Sample"}}, newest_);
    ASSERT_TRUE(Eventually([this] { return newest_->number() > 0; }));
  }

  /// Starts this many recordings, and kills each of them after some samples.
  std::vector<KilledRecording> KillSome(int count) {
    constexpr std::array kCompressions{"none", "lz4", "zstd"};
    constexpr std::uint64_t kMaxSamples = 2500;  // one sample is a millisecond
    std::vector<KilledRecording> all(static_cast<std::size_t>(count));
    for (KilledRecording& one : all) {
      one.file = home_.path() / ("run" + std::to_string(files_++) + ".mcap");
      one.program = std::make_unique<Program>(
          Command("gcm", {"record", "robot/ledger/state", "-o", one.file, "--compression",
                          kCompressions[files_ % kCompressions.size()]}),
          environment());
    }
    for (const KilledRecording& one : all) {
      EXPECT_TRUE(Eventually([&] {
        return one.program->err().find("gcm: recording 1 table") != std::string::npos;
      })) << one.program->err();
    }
    const std::uint64_t now = newest_->number();
    for (KilledRecording& one : all) {
      one.begin = now;
      one.moment = now + random_() % kMaxSamples;
    }
    std::ranges::sort(all, {}, &KilledRecording::moment);
    for (KilledRecording& one : all) {
      EXPECT_TRUE(Eventually([&] { return newest_->number() >= one.moment; }));
      one.newest = newest_->number();
      one.program->Signal(SIGKILL);
      one.program->Wait();
    }
    return all;
  }

  [[nodiscard]] std::vector<std::uint64_t> LedgerIn(mcap::Reader& reader) const {
    return NumbersIn(reader, "robot/ledger/state",
                     MayExpireLeases() ? Gaps::kReported : Gaps::kNone);
  }

  /// Waits until the component has run some more cycles.
  [[nodiscard]] bool LedgerGoesOn() const {
    constexpr std::uint64_t kCycles = 100;
    return Eventually(
        [this, before = newest_->number()] { return newest_->number() > before + kCycles; });
  }

  const std::shared_ptr<NewestNumber> newest_ = std::make_shared<NewestNumber>();
  std::mt19937 random_{27};
  std::size_t files_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Over, RecordingFaults, testing::Values(Middlewares().front()),
                         NameOfMiddleware);

TEST_P(RecordingFaults, AKilledRecorderLosesASecondAtMostAndLeavesWholeChunks) {
  // Under a sanitizer, more recorders would take the processors from the component that they
  // record.
  const int at_once = tendon::test::IsSanitized() ? 3 : 10;
  const int rounds = Starts(5, 50);
  std::uint64_t most_lost = 0;  // number of samples; one sample is a millisecond

  for (int round = 0; round < rounds; ++round) {
    for (const KilledRecording& one : KillSome(at_once)) {
      SCOPED_TRACE(one.file.filename().string() + " of seed 27, killed after sample " +
                   std::to_string(one.newest));
      const auto reader = mcap::Reader::Open(one.file);
      ASSERT_TRUE(reader) << reader.error().message;
      const auto numbers = LedgerIn(**reader);
      const std::uint64_t last = numbers.empty() ? one.begin : numbers.back();
      if (one.newest > last) most_lost = std::max(most_lost, one.newest - last);
      ASSERT_GE((*reader)->problems().count(), 1U);
      for (const mcap::Problem& problem : (*reader)->problems().first()) {
        EXPECT_TRUE(problem.sentence.find("cut off") != std::string::npos ||
                    problem.sentence.find("the file ends within") != std::string::npos)
            << problem.sentence;
      }

      const std::filesystem::path recovered = one.file.string() + ".recovered";
      const auto report = mcap::Recover(one.file, recovered);
      ASSERT_TRUE(report) << report.error().message;
      const auto whole = mcap::Reader::Open(recovered);
      ASSERT_TRUE(whole) << whole.error().message;
      EXPECT_FALSE((*whole)->was_scanned());
      EXPECT_EQ(tendon::mcap::Verify(**whole).problems.count(), 0U);
      EXPECT_EQ(LedgerIn(**whole), numbers);
    }
  }

  Tell(std::to_string(rounds * at_once) + " recorders killed; at most " +
       std::to_string(most_lost) + " ms lost");
  constexpr double kGoal = 1000;  // samples
  // A recorder writes at least once a second, but ten of them share the processors.
  EXPECT_LE(static_cast<double>(most_lost), 4 * kGoal * Slowness());
  EXPECT_TRUE(LedgerGoesOn());
}

/// Row 26, on a RAM disk in a mount namespace of its own.
TEST_P(RecordingFaults, AFullDiskEndsTheRecordingAloneAndTellsWhatIsSafe) {
  constexpr int kNoMount = 77;
  const std::string size = std::to_string(Size(1, 8)) + "m";
  const std::string disk = home_.path() / "disk";
  const std::string copy = home_.path() / "copy.mcap";
  std::filesystem::create_directory(disk);
  std::string script = "mount -t tmpfs -o size=" + size + " tmpfs " + disk + " || exit " +
                       std::to_string(kNoMount) + ";";
  for (const std::string& word : Command("gcm", {"record", "robot/ledger/state", "-o",
                                                 disk + "/run.mcap", "--compression", "none"})) {
    script += " '" + word + "'";
  }
  script += "; code=$?; cp " + disk + "/run.mcap " + copy + "; exit $code";
  Program record({"/usr/bin/unshare", "-Urm", "/bin/sh", "-c", script}, environment());

  const auto code = record.Wait(std::chrono::seconds(600));

  if (code == kNoMount || record.err().starts_with("unshare:")) {
    GTEST_SKIP() << "this user may not mount a RAM disk: " << record.err();
  }
  EXPECT_EQ(code, 1) << record.err();
  EXPECT_NE(record.err().find("No space left on device"), std::string::npos) << record.err();
  EXPECT_NE(record.err().find(" are in the file"), std::string::npos) << record.err();
  const auto reader = mcap::Reader::Open(std::filesystem::path(copy));
  ASSERT_TRUE(reader) << reader.error().message;
  const auto numbers = LedgerIn(**reader);
  ASSERT_GT(numbers.size(), 1000U);
  EXPECT_EQ(mcap::Verify(**reader).problems.count(), 0U)
      << "the file is completed in the space that was reserved";
  EXPECT_TRUE(LedgerGoesOn());
  Tell(size + " were full after " + std::to_string(numbers.size()) + " samples");
}

/// Row 26, on a disk that is simulated by a library in the recorder.
class FaultyDisk : public RecordingFaults {
 protected:
  void SetUp() override {
    if (tendon::test::IsSanitized()) {
      GTEST_SKIP() << "a sanitizer must be the first library, so the disk cannot be simulated";
    }
    RecordingFaults::SetUp();
  }
  /// Runs `gcm record` of the ledger to its end.
  [[nodiscard]] Outcome Record(const Words& more, const Environment& disk = {}) const {
    Words words{"record", "robot/ledger/state", "-o", file_, "--compression", "none"};
    words.insert(words.end(), more.begin(), more.end());
    Environment all = environment();
    all["LD_PRELOAD"] = Built("tests/system/faults/fault_disk.so");
    all.insert(disk.begin(), disk.end());
    return RunProgram(Command("gcm", words), all);
  }

  const std::filesystem::path file_ = home_.path() / "run.mcap";
};

INSTANTIATE_TEST_SUITE_P(Over, FaultyDisk, testing::Values(Middlewares().front()),
                         NameOfMiddleware);

TEST_P(FaultyDisk, AWriteErrorEndsTheRecordingAloneAndTellsWhatIsSafe) {
  // Behind the largest chunk, so that at least one chunk is in the file before the disk fails.
  const Outcome recorded = Record({}, {{"TENDON_TEST_BAD_PLACE", "1200000"}});

  EXPECT_EQ(recorded.exit_code, 1) << recorded.err;
  EXPECT_TRUE(LedgerGoesOn());
  const auto reader = mcap::Reader::Open(file_);
  ASSERT_TRUE(reader) << reader.error().message;
  const auto numbers = LedgerIn(**reader);
  EXPECT_GT(numbers.size(), 500U);
  EXPECT_THAT(recorded.err,
              testing::HasSubstr("run.mcap: Input/output error; " +
                                 std::to_string((*reader)->statistics()->message_count) +
                                 " messages up to "));
  // The index may still fit before the place where the disk is bad.
  const bool has_index = !(*reader)->was_scanned();
  EXPECT_NE(recorded.err.find("to make an index: gcm recover") != std::string::npos, has_index);
  const Outcome recovered = Gcm({"recover", file_});
  EXPECT_EQ(recovered.exit_code, 0) << recovered.err;
  const auto whole = mcap::Reader::Open(home_.path() / "run-recovered.mcap");
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(mcap::Verify(**whole).problems.count(), 0U);
  EXPECT_EQ(LedgerIn(**whole), numbers);
  Tell("the disk failed after " + std::to_string(numbers.size()) + " samples");
}

TEST_P(FaultyDisk, AWriteThatIsCutShortIsContinued) {
  const Outcome recorded = Record({"--for", "5s"});

  EXPECT_EQ(recorded.exit_code, 0) << recorded.err;
  const auto reader = mcap::Reader::Open(file_);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(mcap::Verify(**reader).problems.count(), 0U);
  EXPECT_GT(LedgerIn(**reader).size(), 500U);
}

}  // namespace
}  // namespace faults
