#include <tendon/payload/codec.h>
#include <tests/core/gcm/gcm_fixture.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using test::FakeProcess;

class Ear final : public EventSink {
 public:
  void OnListening(const std::vector<MemberDescription>& /*events*/) override {
    const std::scoped_lock lock(mutex_);
    ++stands_;
  }
  void OnEvent(std::size_t /*event*/, std::span<const std::byte> value,
               const EventTime& time) override {
    const std::scoped_lock lock(mutex_);
    EXPECT_TRUE(Decode(value, value_));
    times_.push_back(time);
  }
  void OnEventsLost(std::size_t /*event*/, std::uint64_t /*lost*/) override {}
  void OnStale(const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    complaint_ = reason.message;
  }

  [[nodiscard]] bool stands() const {
    const std::scoped_lock lock(mutex_);
    return stands_ > 0;
  }
  [[nodiscard]] std::vector<EventTime> times() const {
    const std::scoped_lock lock(mutex_);
    return times_;
  }
  [[nodiscard]] double value() const {
    const std::scoped_lock lock(mutex_);
    return value_;
  }
  [[nodiscard]] std::string complaint() const {
    const std::scoped_lock lock(mutex_);
    return complaint_;
  }

 private:
  mutable std::mutex mutex_;
  int stands_ = 0;
  double value_ = 0.0;
  std::vector<EventTime> times_;
  std::string complaint_;
};

/// A robot whose arm raises events, and a client that listens to them.
class EventTimes : public test::GcmFixture {
 protected:
  void SetUp() override {
    ComponentDescription arm = test::Arm();
    arm.provided[0].events = {{.name = "Moved",
                               .signature = SignatureOf<double, None>(CommandKind::kWrite),
                               .in_type = "float64"}};
    robot_ = Join("robot", {arm});
    client_ = Watch();
  }
  void Listen() {
    client_->Listen({.provided = test::kControl, .events = {"Moved"}}, ear_);
    ASSERT_TRUE(EventuallyTrue([this] { return ear_->stands(); })) << ear_->complaint();
  }
  EventTime Hear(double value, SteadyTime when) {
    const std::size_t before = ear_->times().size();
    robot_->Raise(value, when);
    EXPECT_TRUE(EventuallyTrue([&] { return ear_->times().size() > before; }));
    EXPECT_EQ(ear_->value(), value);
    return ear_->times().back();
  }

  std::unique_ptr<FakeProcess> robot_;
  std::unique_ptr<GcmClient> client_;
  const std::shared_ptr<Ear> ear_ = std::make_shared<Ear>();
};

INSTANTIATE_TEST_SUITE_P(Over, EventTimes, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(EventTimes, ConvertTheSourcesTimesToTheLocalClock) {
  constexpr std::chrono::nanoseconds kAhead = 1h;
  robot_->SetClockAhead(kAhead);
  Listen();

  // The event has waited long before it is sent.
  const SteadyTime raised = SteadyClock().Now() - 1min;
  const EventTime heard = Hear(0.25, raised + kAhead);

  EXPECT_LE(std::chrono::abs(heard.raised - raised), heard.uncertainty);
  EXPECT_LT(heard.uncertainty, kAhead);
  EXPECT_GT(heard.uncertainty, 0ns);
}

TEST_P(EventTimes, AreExactOnOneHost) {
  Listen();
  const SteadyTime raised = SteadyClock().Now() - 1min;

  EXPECT_EQ(Hear(0.5, raised).raised, raised);
}

TEST_P(EventTimes, AreNeverInTheFuture) {
  Listen();

  const EventTime heard = Hear(0.75, SteadyClock().Now() + 1h);

  EXPECT_LE(heard.raised, SteadyClock().Now());
}

TEST_P(EventTimes, UseTheArrivalTimeIfTheClockIsImplausible) {
  robot_->SetClockAhead(24h * 365 * 200);
  Listen();
  const SteadyTime before = SteadyClock().Now();

  const EventTime heard = Hear(1.0, SteadyTime());

  EXPECT_GE(heard.raised, before);
  EXPECT_EQ(heard.uncertainty, EventTime().uncertainty);
}

TEST_P(EventTimes, QueryTheClockRepeatedlyWhileListening) {
  Listen();
  const int asked = robot_->clock_requests();

  EXPECT_TRUE(EventuallyTrue([&] { return robot_->clock_requests() > asked; }));
}

}  // namespace
}  // namespace tendon
