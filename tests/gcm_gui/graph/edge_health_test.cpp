#include <gcm_gui/graph/edge_health.h>
#include <gtest/gtest.h>

#include <QSet>
#include <QSignalSpy>
#include <string>
#include <utility>
#include <vector>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

class EdgeHealthTest : public ::testing::Test {
 protected:
  EdgeHealthTest() { reports_.answers_counts = false; }

  static InterfaceName Client(int i) { return {"desk", "client" + std::to_string(i), "Robot"}; }
  void See(int count) {
    for (int i = 0; i < count; ++i) seen_.push_back(Client(i));
  }
  void AnswerAll(const Result<ConnectionCounts>& counts) {
    for (const auto& handler : std::exchange(reports_.count_handlers, {})) handler(counts);
  }

  ScriptedReports reports_;
  std::vector<InterfaceName> seen_;
  EdgeHealth health_{reports_, [this] { return seen_; }};
  QSignalSpy found_{&health_, &EdgeHealth::found};
  QSignalSpy counted_{&health_, &EdgeHealth::counted};
};

TEST_F(EdgeHealthTest, QueriesOnlyVisibleConnections) {
  health_.look();
  EXPECT_TRUE(reports_.counted.isEmpty());

  See(2);
  health_.look();

  EXPECT_EQ(reports_.counted, (QStringList{"desk/client0/Robot", "desk/client1/Robot"}));
}

TEST_F(EdgeHealthTest, LimitsConcurrentQueriesAndVisitsAll) {
  See(20);
  const auto most = static_cast<qsizetype>(EdgeHealth::kMaxAtOnce);

  health_.look();
  health_.look();
  EXPECT_EQ(reports_.counted.size(), most) << "the first have not answered";

  for (int i = 0; i < 2; ++i) {
    AnswerAll(ConnectionCounts{});
    health_.look();
  }
  EXPECT_EQ(reports_.counted.size(), 3 * most);
  EXPECT_EQ(QSet<QString>(reports_.counted.begin(), reports_.counted.end()).size(), 20);
}

TEST_F(EdgeHealthTest, QueriesAHoveredConnectionAtOnce) {
  health_.point("desk/client3/Robot");
  ASSERT_EQ(reports_.counted, QStringList{"desk/client3/Robot"});

  ConnectionCounts counts;
  counts.taken = 12;
  AnswerAll(counts);

  ASSERT_EQ(counted_.size(), 1);
  EXPECT_TRUE(counted_[0][1].toStringList().contains("12 calls and events"));

  health_.point({});
  health_.look();
  EXPECT_EQ(reports_.counted.size(), 1);
}

TEST_F(EdgeHealthTest, ReportsAFailedQuery) {
  health_.point("desk/client3/Robot");

  AnswerAll(Error{ErrorCode::kTimeout, "no reply from desk in 1 s"});

  ASSERT_EQ(counted_.size(), 1);
  EXPECT_EQ(counted_[0][1].toStringList(), QStringList{"no reply from desk in 1 s"});
}

TEST_F(EdgeHealthTest, WarnsOnceOfNewLosses) {
  ConnectionCounts before;
  before.lost_events = 3;
  ConnectionCounts now = before;
  now.lost_events = 5;

  EXPECT_EQ(HealthWarning(before, std::nullopt), "") << "long ago, perhaps";
  EXPECT_EQ(HealthWarning(now, before), "5 events were lost");
  EXPECT_EQ(HealthWarning(now, now), "");
}

TEST_F(EdgeHealthTest, WarnsOfAFullQueueAndALateAnswer) {
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
