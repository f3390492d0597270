#include <gcm_gui/graph/edge_health.h>
#include <gtest/gtest.h>

#include <QSignalSpy>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

class EdgeHealthTest : public ::testing::Test {
 protected:
  EdgeHealthTest() { store_.apply(system_.TakeChanges()); }

  SystemBuilder system_ = LookSystem(0);
  CatalogueStore store_;
  ScriptedChecks checks_;
  EdgeHealth health_{store_, checks_};
  QSignalSpy found_{&health_, &EdgeHealth::found};
};

TEST_F(EdgeHealthTest, OneIsAskedAboutAfterTheOther) {
  health_.look();
  health_.look();
  ASSERT_EQ(checks_.counted.size(), 1) << "the first has not answered";

  for (int i = 0; i < 3; ++i) {
    checks_.counts(ConnectionCounts{});
    health_.look();
  }

  ASSERT_EQ(checks_.counted.size(), 4);
  EXPECT_EQ(QStringList(checks_.counted.mid(0, 3)).removeDuplicates(), 0);
  EXPECT_EQ(checks_.counted[3], checks_.counted[0]) << "there are three";
}

TEST_F(EdgeHealthTest, WhatIsLostMeanwhileIsAWarningOnce) {
  ConnectionCounts before;
  before.lost_events = 3;
  ConnectionCounts now = before;
  now.lost_events = 5;

  EXPECT_EQ(HealthWarning(before, std::nullopt), "") << "long ago, perhaps";
  EXPECT_EQ(HealthWarning(now, before), "5 events were lost");
  EXPECT_EQ(HealthWarning(now, now), "");
}

TEST_F(EdgeHealthTest, AFullQueueAndALateAnswerAreWarnings) {
  ConnectionCounts counts;
  counts.capacity = 10;
  counts.waiting = 7;
  counts.round_trip = std::chrono::milliseconds(90);
  EXPECT_EQ(HealthWarning(counts, std::nullopt), "");

  counts.waiting = 8;
  counts.round_trip = std::chrono::milliseconds(250);

  EXPECT_EQ(HealthWarning(counts, std::nullopt), "8 of 10 calls wait; answers after 250.0 ms");
}

}  // namespace
}  // namespace tendon::gui
