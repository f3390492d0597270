#include <gtest/gtest.h>
#include <tendon/middleware/handover.h>

#include <thread>

namespace tendon {
namespace {

using std::chrono::hours;

TEST(Handover, WhatIsGivenIsReceived) {
  Handover<int> handover;
  std::thread giver([&] { EXPECT_TRUE(handover.Give(7)); });

  EXPECT_EQ(handover.WaitUntil(SteadyClock().Now() + hours(1)), 7);
  giver.join();
}

TEST(Handover, NothingIsReceivedAfterTheDeadlineAndTheGiverIsTold) {
  Handover<int> handover;

  EXPECT_EQ(handover.WaitUntil(SteadyClock().Now()), std::nullopt);
  EXPECT_FALSE(handover.Give(7));
}

TEST(Handover, OnlyTheFirstIsTaken) {
  Handover<int> handover;

  EXPECT_TRUE(handover.Give(7));
  EXPECT_FALSE(handover.Give(8));
  EXPECT_EQ(handover.WaitUntil(SteadyClock().Now()), 7);
}

}  // namespace
}  // namespace tendon
