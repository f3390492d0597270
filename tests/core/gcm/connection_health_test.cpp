#include <gtest/gtest.h>
#include <tendon/gcm/connection_health.h>

namespace tendon {
namespace {

using Flaw = ConnectionFlaw::Kind;

TEST(ConnectionHealth, LossesBeforeTheFirstSampleAreNoFlaw) {
  const ConnectionCounts before{.refused = 2, .lost_events = 3};
  const ConnectionCounts now{.refused = 4, .lost_events = 5};

  EXPECT_TRUE(FlawsOf(now, std::nullopt).empty());
  EXPECT_TRUE(FlawsOf(now, now).empty());
  EXPECT_EQ(FlawsOf(now, before),
            (std::vector<ConnectionFlaw>{{.kind = Flaw::kCallsRefused, .count = 4},
                                         {.kind = Flaw::kEventsLost, .count = 5}}));
}

TEST(ConnectionHealth, AResetCounterCountsFromZero) {
  const ConnectionCounts before{.lost_events = 3};

  EXPECT_TRUE(FlawsOf({.lost_events = 0}, before).empty());
  EXPECT_EQ(FlawsOf({.lost_events = 1}, before).size(), 1U);
}

TEST(ConnectionHealth, ReportsAMailboxThatIsAlmostFull) {
  EXPECT_TRUE(FlawsOf({.capacity = 10, .waiting = 7}, std::nullopt).empty());
  EXPECT_TRUE(FlawsOf({.capacity = 0, .waiting = 0}, std::nullopt).empty());
  EXPECT_EQ(
      FlawsOf({.capacity = 10, .waiting = 8}, std::nullopt),
      (std::vector<ConnectionFlaw>{{.kind = Flaw::kMailboxFull, .count = 8, .capacity = 10}}));
}

TEST(ConnectionHealth, DescribesEachFlaw) {
  EXPECT_EQ(ToString(ConnectionFlaw{.kind = Flaw::kCallsRefused, .count = 3}),
            "3 calls were refused, because the mailbox was full");
  EXPECT_EQ(ToString(ConnectionFlaw{.kind = Flaw::kEventsLost, .count = 5}), "5 events were lost");
  EXPECT_EQ(ToString(ConnectionFlaw{.kind = Flaw::kMailboxFull, .count = 8, .capacity = 10}),
            "8 of 10 calls wait");
  EXPECT_EQ(
      ToString(ConnectionFlaw{.kind = Flaw::kLate, .round_trip = std::chrono::milliseconds(250)}),
      "answers after 250 ms");
}

}  // namespace
}  // namespace tendon
