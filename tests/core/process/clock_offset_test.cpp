#include <gtest/gtest.h>
#include <tendon/process/clock_offset.h>

#include <random>

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;
using tendon::ClockOffset;
using tendon::SteadyTime;

/// Our clock, and another clock that is `offset` ahead and gains `drift` (relative); and the delays
/// of messages between them.
class TwoHosts {
 public:
  explicit TwoHosts(nanoseconds offset, double drift = 0.0) : offset_(offset), drift_(drift) {}

  /// Sends a request. `there` and `back` are the delays of the request and of its reply.
  void Ask(nanoseconds there, nanoseconds back) {
    const SteadyTime sent = now_;
    const SteadyTime answered = Theirs(now_ + there);
    now_ += there + back;
    clock.Add(sent, answered, now_);
  }
  void Pass(nanoseconds time) { now_ += time; }
  void Jump(nanoseconds by) { offset_ += by; }

  [[nodiscard]] SteadyTime now() const { return now_; }
  [[nodiscard]] SteadyTime theirs() const { return Theirs(now_); }
  [[nodiscard]] nanoseconds offset() const { return Theirs(now_) - now_; }
  [[nodiscard]] ClockOffset::Estimate estimate() const { return clock.At(now_); }
  [[nodiscard]] nanoseconds slewed() const { return clock.SlewedAt(theirs()); }

  ClockOffset clock;

 private:
  [[nodiscard]] SteadyTime Theirs(SteadyTime mine) const {
    const auto gained = static_cast<double>(mine.time_since_epoch().count()) * drift_;
    return mine + offset_ + nanoseconds(static_cast<std::int64_t>(gained));
  }

  SteadyTime now_{1000s};
  nanoseconds offset_;
  double drift_;
};

TEST(ClockOffset, IsUnknownBeforeTheFirstAnswer) {
  const ClockOffset clock;

  EXPECT_EQ(clock.At(SteadyTime(5s)).uncertainty, ClockOffset::kUnknown);
  EXPECT_EQ(clock.SlewedAt(SteadyTime(5s)), 0ns);
}

TEST(ClockOffset, IsExactForSymmetricDelays) {
  TwoHosts hosts(1h);

  hosts.Ask(100us, 100us);

  EXPECT_EQ(hosts.estimate().offset, 1h);
  EXPECT_EQ(hosts.estimate().uncertainty, 100us);
  EXPECT_EQ(hosts.slewed(), 1h);
}

TEST(ClockOffset, ErrorIsBoundedForAsymmetricDelays) {
  for (const nanoseconds there : {0us, 50us, 3000us}) {
    TwoHosts hosts(-10min);

    hosts.Ask(there, 3000us - there);

    EXPECT_LE(std::chrono::abs(hosts.estimate().offset + 10min), hosts.estimate().uncertainty);
    EXPECT_EQ(hosts.estimate().uncertainty, 1500us);
  }
}

TEST(ClockOffset, UsesTheAnswerWithTheShortestRoundTrip) {
  TwoHosts hosts(1h);
  hosts.Ask(9ms, 1ms);
  hosts.Ask(30us, 30us);
  hosts.Ask(2ms, 40ms);

  EXPECT_EQ(hosts.estimate().offset, 1h);
  EXPECT_LT(hosts.estimate().uncertainty, 40us);
}

TEST(ClockOffset, UncertaintyGrowsWithTheAgeOfTheLastAnswer) {
  TwoHosts hosts(1h);
  hosts.Ask(50us, 50us);
  EXPECT_EQ(hosts.estimate().uncertainty, 50us);

  hosts.Pass(10s);

  EXPECT_EQ(hosts.estimate().uncertainty, 50us + 1ms);
}

TEST(ClockOffset, TracksADriftingClockForHours) {
  for (const double drift : {-9e-5, -1e-6, 0.0, 3e-5, 9e-5}) {
    std::mt19937 random(7);
    std::exponential_distribution<double> delay(1.0 / 300.0);  // us; mean delay of 300
    TwoHosts hosts(77min, drift);
    const auto way = [&] { return 20us + nanoseconds(static_cast<int>(1000 * delay(random))); };

    for (int question = 0; question < 20'000; ++question) {
      hosts.Ask(way(), way());
      hosts.Pass(500ms);
      const auto [offset, uncertainty] = hosts.estimate();
      ASSERT_LE(std::chrono::abs(offset - hosts.offset()), uncertainty) << question;
      if (question > 8) {
        ASSERT_LT(uncertainty, 2ms);
        ASSERT_LT(std::chrono::abs(hosts.slewed() - hosts.offset()), 2ms);
      }
    }
  }
}

TEST(ClockOffset, IsZeroOnOneHostDespiteAsymmetricDelays) {
  std::mt19937 random(1);
  TwoHosts hosts(0s);

  for (int question = 0; question < 1000; ++question) {
    hosts.Ask(nanoseconds(random() % 100'000'000), nanoseconds(random() % 1'000'000));
    ASSERT_EQ(hosts.estimate().offset, 0ns);
    ASSERT_EQ(hosts.slewed(), 0ns);
  }
}

TEST(ClockOffset, RestartsWhenAClockJumps) {
  TwoHosts hosts(1h);
  for (int i = 0; i < 8; ++i) hosts.Ask(20us, 20us);

  hosts.Jump(-30min);
  hosts.Ask(2ms, 2ms);

  EXPECT_EQ(hosts.estimate().offset, 30min);
  EXPECT_EQ(hosts.slewed(), 30min);
  hosts.Jump(1ms);
  hosts.Ask(100us, 100us);
  EXPECT_EQ(hosts.estimate().offset, 30min + 1ms);
}

TEST(ClockOffset, CorrectsByAtMostFiveHundredPartsPerMillion) {
  TwoHosts hosts(1h);
  hosts.Ask(0us, 0us);
  hosts.Jump(10ms);
  hosts.Ask(0us, 0us);

  nanoseconds before = hosts.slewed();
  EXPECT_EQ(before, 1h);
  for (int step = 0; step < 300; ++step) {
    hosts.Pass(100ms);
    const nanoseconds now = hosts.slewed();
    ASSERT_GE(now, before);
    ASSERT_LE(now - before, 50us);
    before = now;
  }

  EXPECT_EQ(before, 1h + 10ms);  // after 20 s
}

TEST(ClockOffset, CorrectsNewAndOldTimesConsistently) {
  TwoHosts hosts(1h);
  hosts.Ask(0us, 0us);
  hosts.Jump(10ms);
  hosts.Ask(0us, 0us);
  const SteadyTime later = hosts.theirs() + 2s;

  EXPECT_EQ(hosts.clock.SlewedAt(later), 1h + 1ms);
  EXPECT_EQ(hosts.clock.SlewedAt(hosts.theirs() - 1min), 1h);
  EXPECT_EQ(hosts.clock.SlewedAt(later), 1h + 1ms);
}

TEST(ClockOffset, IgnoresImpossibleAnswers) {
  TwoHosts hosts(1h);
  hosts.Ask(20us, 20us);
  const SteadyTime now = hosts.now();

  hosts.clock.Add(now, hosts.theirs(), now - 1ns);
  hosts.clock.Add(now, SteadyTime::min(), now);
  hosts.clock.Add(now, SteadyTime::max(), now);

  EXPECT_EQ(hosts.estimate().offset, 1h);
  EXPECT_EQ(hosts.clock.SlewedAt(SteadyTime::max()), 1h);
  EXPECT_EQ(hosts.clock.SlewedAt(SteadyTime::min()), 1h);
}

}  // namespace
