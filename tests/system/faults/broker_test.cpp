#include "system/faults/harness/broker.h"

#include <sys/resource.h>
#include <tendon/base/os/socket.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "core/ice/attacks.h"
#include "support/machine/sanitized.h"
#include "system/faults/harness/footprint.h"

namespace faults {
namespace {

using tendon::test::IsSanitized;

const std::uint64_t kRows = IsSanitized() ? 200 : 1000;

bool HasMemoryLimit(pid_t process) {
  rlimit limit{};
  return prlimit(process, RLIMIT_AS, nullptr, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

INSTANTIATE_TEST_SUITE_P(Over, BrokerTest, testing::Values("ice"), NameOfMiddleware);

/// Sixteen viewers watch one stream, which the process sends only once. One viewer stops. The
/// others continue, no memory grows, and the stopped viewer later knows what it has missed.
TEST_P(BrokerTest, AStoppedSubscriberHarmsNoOther) {
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
    return (IsSanitized() || verdict.counted > 0) && verdict.received > before_it_stopped + 100;
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
    if (MayExpireLeases()) continue;
    EXPECT_LE(verdict.missing * 20, verdict.received) << ToString(verdict);
  }
  std::ostringstream told;
  told << "others: " << ToString(streams.front()->verdict()) << ", at most " << most_missing
       << " missing; process: " << robot << "; broker: " << broker;
  Tell(told.str());
}

/// The broker is a program of Ice. Some messages make Ice allocate too much memory; the memory
/// limit of the broker makes Ice refuse these messages.
TEST_P(BrokerTest, TheBrokerSurvivesMalformedIceMessages) {
  ASSERT_NO_FATAL_FAILURE(Watch(stream_));
  ASSERT_TRUE(AllGetMore({stream_}, 100)) << robot_->err();
  ASSERT_TRUE(HasMemoryLimit(broker_->pid())) << "this machine would have no memory left";
  const auto place = tendon::ParseAddress(broker_address_, 1);

  for (const auto& [name, attack] : tendon::ice::Attacks()) {
    const auto socket = tendon::os::ConnectTo(place->host, place->port, Timeout());
    ASSERT_TRUE(socket) << name << ": " << socket.error().message;
    (void)tendon::os::SendSome(*socket, attack);
  }

  EXPECT_TRUE(AllGetMore({stream_}, kRows));
  const auto later = std::make_shared<StreamChecker>();
  ASSERT_NO_FATAL_FAILURE(Watch(later));
  EXPECT_TRUE(AllGetMore({stream_, later}, 100));
  EXPECT_THAT(stream_->verdict().stale, testing::IsEmpty()) << "it came by the broker all the time";
  const std::uint64_t stale = later->verdict().stale.size();
  broker_->Signal(SIGKILL);
  EXPECT_TRUE(Eventually([&] { return later->verdict().stale.size() > stale; }))
      << "it was of no use";
}

/// Without the broker, viewers are told that rows have stopped. Then they get the rows directly.
TEST_P(BrokerTest, RowsArriveDirectlyIfTheBrokerDies) {
  ASSERT_NO_FATAL_FAILURE(Watch(stream_));
  ASSERT_TRUE(AllGetMore({stream_}, 100)) << robot_->err();
  const std::uint64_t stale = stream_->verdict().stale.size();

  broker_->Signal(SIGKILL);
  broker_->Wait();

  ASSERT_TRUE(Eventually([&] { return stream_->verdict().stale.size() > stale; }))
      << "it was of no use";
  ASSERT_TRUE(AllGetMore({stream_}, 100));
  const StreamChecker::Verdict verdict = stream_->verdict();
  Tell(ToString(verdict));
  EXPECT_GT(verdict.counted, 0U);
  EXPECT_EQ(verdict.missing, verdict.counted);
  EXPECT_EQ(verdict.repeated, 0U);
  ExpectNeverLost("well");
}

/// A new subscriber uses the broker again after its restart.
TEST_P(BrokerTest, ARestartedBrokerIsUsedAgain) {
  const auto first = std::make_shared<StreamChecker>();
  ASSERT_NO_FATAL_FAILURE(Watch(first));
  ASSERT_TRUE(AllGetMore({first}, 100)) << robot_->err();
  const std::uint64_t first_stale = first->verdict().stale.size();
  broker_->Signal(SIGKILL);
  broker_->Wait();
  ASSERT_TRUE(Eventually([&] { return first->verdict().stale.size() > first_stale; }));
  ASSERT_NO_FATAL_FAILURE(StartBroker());

  ASSERT_NO_FATAL_FAILURE(Watch(stream_));
  ASSERT_TRUE(AllGetMore({first, stream_}, 100));
  const std::uint64_t stale = stream_->verdict().stale.size();
  broker_->Signal(SIGKILL);

  EXPECT_TRUE(Eventually([&] { return stream_->verdict().stale.size() > stale; }))
      << "it was of no use";
  EXPECT_TRUE(AllGetMore({first, stream_}, 100));
}

}  // namespace
}  // namespace faults
