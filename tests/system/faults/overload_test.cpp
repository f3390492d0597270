#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "support/machine/sanitized.h"
#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/footprint.h"

namespace faults {
namespace {

using namespace std::chrono_literals;

/// A reader that needs a chosen time for each batch.
class SlowReader final : public tendon::RowSink {
 public:
  void set_nap(std::chrono::milliseconds nap) { nap_ = nap; }
  [[nodiscard]] StreamChecker::Verdict verdict() const { return checker_->verdict(); }

 private:
  void OnSubscribed(const std::vector<tendon::Schema>& columns) override {
    sink().OnSubscribed(columns);
  }
  void OnRows(const tendon::RowBatch& batch) override {
    std::this_thread::sleep_for(nap_.load());
    sink().OnRows(batch);
  }
  void OnStale(const tendon::Error& reason) override { sink().OnStale(reason); }
  [[nodiscard]] tendon::RowSink& sink() const { return *checker_; }

  const std::shared_ptr<StreamChecker> checker_ = std::make_shared<StreamChecker>();
  std::atomic<std::chrono::milliseconds> nap_{0ms};
};

/// Records the log lines by source, and their delay until they arrive here, by the clock of this
/// machine.
class LogWatch final : public tendon::GcmListener {
 public:
  struct Heard {
    std::vector<std::string> texts;
    std::vector<std::int64_t> delays;  // ms
  };
  [[nodiscard]] Heard Of(const std::string& source) const {
    const std::scoped_lock lock(mutex_);
    const auto found = heard_.find(source);
    return found == heard_.end() ? Heard() : found->second;
  }

 private:
  void OnSnapshot(const tendon::Catalogue& /*catalogue*/) override {}
  void OnChanges(const std::vector<tendon::CatalogueChange>& /*changes*/) override {}
  void OnGcmLost(const tendon::Error& /*reason*/) override {}
  void OnLog(const tendon::LogBatch& batch) override {
    constexpr std::int64_t kNanosecondsInOne = 1'000'000;
    const std::int64_t now = std::chrono::system_clock::now().time_since_epoch() / 1ns;
    const std::scoped_lock lock(mutex_);
    for (const auto& record : batch.records) {
      if (record.text.starts_with(kMissed)) continue;
      Heard& heard = heard_[record.source];
      heard.texts.push_back(record.text);
      heard.delays.push_back((now - record.time) / kNanosecondsInOne);
    }
  }

  static constexpr const char* kMissed = "missed ";  // the task logs this itself on a busy machine

  mutable std::mutex mutex_;
  std::map<std::string, Heard> heard_;
};

/// Returns the number in the record that reports the most suppressed lines.
unsigned long long MostSuppressed(const LogWatch::Heard& raver) {
  const std::string told = "suppressed ";
  unsigned long long most = 0;
  for (const std::string& text : raver.texts) {
    if (text.starts_with(told)) most = std::max(most, std::stoull(text.substr(told.size())));
  }
  return most;
}

class Overload : public FaultTest {
 protected:
  [[nodiscard]] std::unique_ptr<tendon::GcmClient> MakeViewer(
      const std::shared_ptr<tendon::GcmListener>& listener) const {
    auto viewer = std::make_unique<tendon::GcmClient>(
        NewMiddleware(),
        tendon::GcmClient::Options{.name = "other", .address = gcm_address_, .timeout = Timeout()},
        listener);
    EXPECT_TRUE(viewer->WaitUntilWatching().ok());
    return viewer;
  }

  /// Returns the footprint of the rows' process after `slow` has missed `rows` more rows.
  [[nodiscard]] Footprint AfterMore(std::uint64_t rows, const SlowReader& slow) const {
    const std::uint64_t lost = slow.verdict().counted;
    EXPECT_TRUE(Eventually([&] { return slow.verdict().counted >= lost + rows; }))
        << "it misses no more";
    return FootprintOf(robot_->pid());
  }

  /// Returns true if memory grew by less than a twentieth. A thousand stored rows of 8 KiB would be
  /// far more.
  static bool IsSteady(const Footprint& before, const Footprint& now) {
    constexpr std::size_t kTwentieth = 20;
    return IsFlat(before, now) && (tendon::test::IsSanitized() ||
                                   now.resident <= before.resident + before.resident / kTwentieth);
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Overload, testing::ValuesIn(Middlewares()), NameOfMiddleware);

/// A slow reader misses rows and is told how many. The other readers miss none, and the memory of
/// the source does not grow.
TEST_P(Overload, ASlowConsumerHarmsNoOther) {
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_NO_FATAL_FAILURE(StartViewer());
  robot_ = MakeLcm("well");
  ASSERT_TRUE(Eventually([this] {
    const auto catalogue = viewer_->catalogue();
    return catalogue.FindProvided({"well", "fountain", "state"}) != nullptr;
  })) << robot_->err();
  const tendon::TableSubscription rows{"well", "fountain", "state", {"Sample", "Ballast"}};
  viewer_->telemetry().Subscribe(rows, stream_);
  const auto slow = std::make_shared<SlowReader>();
  const auto other = MakeViewer(nullptr);
  other->telemetry().Subscribe(rows, slow);
  const auto both_get_more = [&](std::uint64_t more) {
    const std::uint64_t fast_before = stream_->received();
    const std::uint64_t slow_before = slow->verdict().received;
    return Eventually([&] {
      return stream_->received() >= fast_before + more &&
             slow->verdict().received >= slow_before + more;
    });
  };
  ASSERT_TRUE(both_get_more(100)) << robot_->err();

  slow->set_nap(250ms);
  ASSERT_TRUE(Eventually([&] { return slow->verdict().counted > 0; }));
  Footprint before;
  Footprint after = FootprintOf(robot_->pid());
  EXPECT_TRUE(Eventually([&] {
    before = std::exchange(after, AfterMore(1000, *slow));
    return IsSteady(before, after);
  })) << before
      << "; 1000 lost rows later " << after;

  slow->set_nap(0ms);
  ASSERT_TRUE(both_get_more(500)) << "it is fast again";
  const StreamChecker::Verdict missed = slow->verdict();
  Tell("slow: " + ToString(missed));
  EXPECT_EQ(missed.missing, missed.counted);
  EXPECT_EQ(missed.repeated, 0U);
  EXPECT_EQ(missed.damaged, 0U);
  ExpectNoRowLost();
  ExpectNeverLost("well");
}

/// The flood of one component is suppressed and reported. All log lines of another component in the
/// same process arrive in time.
TEST_P(Overload, ALogFloodHarmsNoOtherComponent) {
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_NO_FATAL_FAILURE(StartViewer());
  const auto log = std::make_shared<LogWatch>();
  const auto viewer = MakeViewer(log);
  viewer->WatchLog();
  const Stopwatch since_start;
  robot_ = MakeLcm("noisy");
  ASSERT_TRUE(Eventually([&] { return log->Of("calm").texts.size() >= 100; })) << Gcm({"ls"}).out;
  ASSERT_TRUE(Eventually([&] { return MostSuppressed(log->Of("raver")) > 1000; }));

  EXPECT_EQ(Gcm({"ls"}).exit_code, 0) << "the console is usable";
  EXPECT_EQ(Gcm({"log"}).exit_code, 0);

  const LogWatch::Heard calm = log->Of("calm");
  std::vector<std::int64_t> delays = calm.delays;
  std::sort(delays.begin(), delays.end());
  const auto raves = log->Of("raver").texts;
  const auto seconds = static_cast<std::size_t>(1 + since_start.milliseconds() / 1000);
  Tell(std::to_string(calm.texts.size()) + " calm records, the middle one heard after " +
       std::to_string(delays[delays.size() / 2]) + " ms, the last after " +
       std::to_string(delays.back()) + " ms; beside " + std::to_string(raves.size()) +
       " that raved");
  for (std::size_t i = 1; i < calm.texts.size(); ++i) {
    ASSERT_GT(std::stoi(calm.texts[i]), std::stoi(calm.texts[i - 1]))
        << "each comes once, in order";
  }
  if (!MayExpireLeases()) {
    EXPECT_EQ(calm.texts.back(), std::to_string(calm.texts.size())) << "none is missing";
    EXPECT_LE(static_cast<double>(delays[delays.size() / 2]), 100 * Slowness());
  }
  EXPECT_LE(raves.size(), 200 + 200 * seconds);
  ExpectNeverLost("noisy");
}

}  // namespace
}  // namespace faults
