#include <gtest/gtest.h>
#include <tendon/gcm/client/log_feed.h>

#include <string>
#include <vector>

namespace tendon {
namespace {

using client::LogFeed;
using message::LogRecords;

constexpr std::uint64_t kGcm = 17;

LogRecords Records(std::uint64_t before, std::size_t count) {
  return {before, std::vector<message::LogRecord>(count)};
}

TEST(LogFeed, StartsWithTheWholeLog) {
  const LogFeed feed;

  EXPECT_EQ(feed.Wanted().gcm_instance, 0U);
  EXPECT_EQ(feed.Wanted().after, 0U);
}

TEST(LogFeed, IsCurrentAfterReadingTheKeptRecords) {
  LogFeed feed;

  EXPECT_FALSE(feed.Begin({kGcm, 100, 110}).is_current);
  EXPECT_FALSE(feed.Take(Records(100, 6)).is_current);
  EXPECT_TRUE(feed.Take(Records(106, 4)).is_current);
  EXPECT_TRUE(feed.Take(Records(110, 1)).is_current);
}

TEST(LogFeed, IsCurrentAtOnceForAnEmptyLog) {
  LogFeed feed;

  EXPECT_TRUE(feed.Begin({kGcm, 0, 0}).is_current);
}

TEST(LogFeed, ResumesAtTheLastPosition) {
  LogFeed feed;
  feed.Begin({kGcm, 100, 110});
  feed.Take(Records(100, 10));

  EXPECT_EQ(feed.Wanted().gcm_instance, kGcm);
  EXPECT_EQ(feed.Wanted().after, 110U);
}

TEST(LogFeed, CountsMissingRecords) {
  LogFeed feed;
  feed.Begin({kGcm, 100, 110});

  EXPECT_EQ(feed.Take(Records(100, 10)).lost, 0U);
  EXPECT_EQ(feed.Take(Records(113, 1)).lost, 3U);
  EXPECT_EQ(feed.Take(Records(114, 1)).lost, 0U);
}

}  // namespace
}  // namespace tendon
