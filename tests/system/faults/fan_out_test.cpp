#include <algorithm>
#include <chrono>
#include <mutex>
#include <sstream>
#include <utility>

#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/footprint.h"

namespace faults {
namespace {

using namespace std::chrono_literals;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
constexpr std::uint64_t kRows = 200;
#else
constexpr bool kIsSanitized = false;
constexpr std::uint64_t kRows = 1000;
#endif

/// Takes no batch while its gate is held.
class GatedReader final : public tendon::RowSink {
 public:
  [[nodiscard]] std::unique_lock<std::mutex> HoldGate() { return std::unique_lock(gate_); }
  [[nodiscard]] StreamChecker::Verdict verdict() const { return checker_->verdict(); }

 private:
  void OnSubscribed(const std::vector<tendon::Schema>& columns) override {
    sink().OnSubscribed(columns);
  }
  std::size_t OnRows(const tendon::RowBatch& batch) override {
    const std::scoped_lock lock(gate_);
    return sink().OnRows(batch);
  }
  void OnStale(const tendon::Error& reason) override { sink().OnStale(reason); }
  [[nodiscard]] tendon::RowSink& sink() const { return *checker_; }

  std::mutex gate_;
  const std::shared_ptr<StreamChecker> checker_ = std::make_shared<StreamChecker>();
};

/// A GCM that knows a broker, a process with a stream of large rows, and viewers that are programs
/// of their own but for the process they are in.
class FanOutTest : public FaultTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(StartBroker());
    if (HasNoBroker()) GTEST_SKIP() << broker_->err();
    gcm_ = std::make_unique<Program>(Command("gcm", {"serve", "--fan-out", broker_address_}),
                                     environment());
    ASSERT_TRUE(Eventually([this] { return gcm_->out().starts_with("GCM at "); })) << gcm_->err();
    ASSERT_NO_FATAL_FAILURE(StartViewer());
    robot_ = MakeLcm("well");
    ASSERT_TRUE(Eventually([this] {
      const auto catalog = viewer_->catalog();
      return catalog.FindProvided({"well", "fountain", "state"}) != nullptr;
    })) << robot_->err();
  }

  void StartBroker() {
    broker_ = std::make_unique<Program>(Command("gcm", {"fan-out", "--listen", broker_address_}),
                                        environment());
    ASSERT_TRUE(Eventually([this] {
      return broker_->out().find("ready") != std::string::npos || HasNoBroker();
    })) << broker_->err();
  }

  [[nodiscard]] bool HasNoBroker() const {
    return broker_->err().find("is not installed: ") != std::string::npos;
  }

  void Watch(const std::shared_ptr<tendon::RowSink>& sink) {
    auto& viewer = viewers_.emplace_back(std::make_unique<tendon::GcmClient>(
        NewMiddleware(), tendon::GcmClient::Options{
                             .name = "other", .address = gcm_address_, .timeout = Patience()}));
    ASSERT_TRUE(viewer->WaitUntilWatching().ok());
    viewer->telemetry().Subscribe(rows_, sink);
  }

  const tendon::TableSubscription rows_{"well", "fountain", "state", {"Sample", "Ballast"}};
  const std::string broker_address_ = "127.0.0.1:" + std::to_string(FreePort());
  std::unique_ptr<Program> broker_;
  std::vector<std::unique_ptr<tendon::GcmClient>> viewers_;
};

INSTANTIATE_TEST_SUITE_P(Over, FanOutTest, testing::Values("ice"), NameOfMiddleware);

bool AllGetMore(const std::vector<std::shared_ptr<StreamChecker>>& streams, std::uint64_t more) {
  std::vector<std::uint64_t> before;
  for (const auto& stream : streams) before.push_back(stream->received());
  return Eventually([&] {
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (streams[i]->received() < before[i] + more) return false;
    }
    return true;
  });
}

/// Sixteen watch one stream, which the process sends once; one of them stops. The others go on,
/// nothing grows, and the one knows what it has missed.
TEST_P(FanOutTest, OneOfSixteenThatStopsHarmsNobodyButItself) {
  std::vector<std::shared_ptr<StreamChecker>> streams;
  for (int i = 0; i < 15; ++i) {
    ASSERT_NO_FATAL_FAILURE(Watch(streams.emplace_back(std::make_shared<StreamChecker>())));
  }
  const auto stopped = std::make_shared<GatedReader>();
  ASSERT_NO_FATAL_FAILURE(Watch(stopped));
  ASSERT_TRUE(AllGetMore(streams, 100)) << robot_->err();
  ASSERT_TRUE(Eventually([&] { return stopped->verdict().received >= 100; }));

  auto gate = stopped->HoldGate();
  const std::uint64_t before_it_stopped = stopped->verdict().received;
  Footprint robot_before;
  Footprint robot = FootprintOf(robot_->pid());
  Footprint broker_before;
  Footprint broker = FootprintOf(broker_->pid());
  EXPECT_TRUE(Eventually([&] {
    EXPECT_TRUE(AllGetMore(streams, kRows));
    robot_before = std::exchange(robot, FootprintOf(robot_->pid()));
    broker_before = std::exchange(broker, FootprintOf(broker_->pid()));
    return IsFlat(robot_before, robot) && IsFlat(broker_before, broker);
  })) << robot_before
      << "; " << kRows << " rows later " << robot << "; the broker: " << broker_before << "; "
      << broker;
  ASSERT_TRUE(AllGetMore(streams, 3 * kRows)) << "what the links hold for the one is full";
  gate.unlock();

  EXPECT_TRUE(Eventually([&] {
    const auto verdict = stopped->verdict();
    return (kIsSanitized || verdict.counted > 0) && verdict.received > before_it_stopped + 100;
  })) << ToString(stopped->verdict());
  const StreamChecker::Verdict missed = stopped->verdict();
  Tell("stopped: " + ToString(missed));
  EXPECT_EQ(missed.missing, missed.counted);
  EXPECT_EQ(missed.repeated, 0U);
  EXPECT_EQ(missed.damaged, 0U);
  std::uint64_t most_missing = 0;
  for (const auto& stream : streams) {
    const StreamChecker::Verdict verdict = stream->verdict();
    EXPECT_EQ(verdict.missing, verdict.counted);
    EXPECT_EQ(verdict.repeated, 0U);
    most_missing = std::max(most_missing, verdict.missing);
    if (kIsSanitized || MachineStoodStill()) continue;
    EXPECT_LE(verdict.missing * 20, verdict.received) << ToString(verdict);
  }
  std::ostringstream told;
  told << "others: " << ToString(streams.front()->verdict()) << ", at most " << most_missing
       << " missing; process: " << robot << "; broker: " << broker;
  Tell(told.str());
}

/// Without the broker, viewers are told that there are no rows, and get them directly.
TEST_P(FanOutTest, WhereTheBrokerDiesRowsComeDirectly) {
  ASSERT_NO_FATAL_FAILURE(Watch(stream_));
  ASSERT_TRUE(AllGetMore({stream_}, 100)) << robot_->err();
  const std::uint64_t stale = stream_->verdict().stale;

  broker_->Signal(SIGKILL);
  broker_->Wait();

  ASSERT_TRUE(Eventually([&] { return stream_->verdict().stale > stale; })) << "it was of no use";
  ASSERT_TRUE(AllGetMore({stream_}, 100));
  const StreamChecker::Verdict verdict = stream_->verdict();
  Tell(ToString(verdict));
  EXPECT_GT(verdict.counted, 0U);
  EXPECT_EQ(verdict.missing, verdict.counted);
  EXPECT_EQ(verdict.repeated, 0U);
  ExpectNeverLost("well");
}

/// Who subscribes after it has returned hears by it again.
TEST_P(FanOutTest, ABrokerThatReturnsIsUsedAgain) {
  const auto first = std::make_shared<StreamChecker>();
  ASSERT_NO_FATAL_FAILURE(Watch(first));
  ASSERT_TRUE(AllGetMore({first}, 100)) << robot_->err();
  const std::uint64_t first_stale = first->verdict().stale;
  broker_->Signal(SIGKILL);
  broker_->Wait();
  ASSERT_TRUE(Eventually([&] { return first->verdict().stale > first_stale; }));
  ASSERT_NO_FATAL_FAILURE(StartBroker());

  ASSERT_NO_FATAL_FAILURE(Watch(stream_));
  ASSERT_TRUE(AllGetMore({first, stream_}, 100));
  const std::uint64_t stale = stream_->verdict().stale;
  broker_->Signal(SIGKILL);

  EXPECT_TRUE(Eventually([&] { return stream_->verdict().stale > stale; })) << "it was of no use";
  EXPECT_TRUE(AllGetMore({first, stream_}, 100));
}

}  // namespace
}  // namespace faults
