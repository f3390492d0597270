#include <gcm_console/feeds/curve_feed.h>
#include <gmock/gmock.h>
#include <tendon/middleware/body.h>
#include <tendon/payload/schema.h>

#include <array>
#include <string>
#include <vector>

namespace console {
namespace {

using std::chrono_literals::operator""s;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kWindow = 10.0;  // s

/// Makes a feed of the columns "Joints", two numbers, and "Note", a text.
CurveFeed FeedOf(const std::vector<RowInbox::WantedPath>& wanted) {
  return CurveFeed(wanted, kWindow);
}
RowInbox::WantedPath Joints(const std::string& field, bool is_found = false) {
  return {*tendon::ParsePath("robot/arm/state.Joints" + field), 0, is_found};
}
RowInbox::WantedPath Note(bool is_found) {
  return {*tendon::ParsePath("robot/arm/state.Note"), 1, is_found};
}
void Subscribe(CurveFeed& feed) {
  feed.OnSubscribed({tendon::SchemaOf<std::array<double, 2>>(), tendon::SchemaOf<std::string>()});
}
void Send(CurveFeed& feed, std::chrono::nanoseconds when, std::array<double, 2> joints) {
  const std::array<tendon::Bytes, 2> cells{tendon::EncodeBody(joints),
                                           tendon::EncodeBody(std::string("well"))};
  const std::array<std::uint64_t, 1> ticks{1};
  const std::array<std::int64_t, 1> times{when.count()};
  tendon::RowBatch batch;
  batch.count = 1;
  batch.ticks = ticks;
  batch.times = times;
  batch.cell = [&](std::size_t /*row*/, std::size_t column) {
    return std::span<const std::byte>(cells.at(column));
  };
  feed.OnRows(batch);
}
std::vector<std::string> Titles(const CurveFeed& feed) {
  std::vector<std::string> titles;
  for (const NumberCurve& curve : feed.curves()) titles.push_back(curve.title);
  return titles;
}

TEST(CurveFeed, DrawsTheNumberOfAPath) {
  CurveFeed feed = FeedOf({Joints("[1]")});
  Subscribe(feed);
  Send(feed, 1s, {0.5, 0.75});

  ASSERT_THAT(Titles(feed), ElementsAre("robot/arm/state.Joints[1]"));
  ASSERT_EQ(feed.curves()[0].samples.size(), 1U);
  EXPECT_EQ(feed.curves()[0].samples[0].time, 1.0);
  EXPECT_EQ(feed.curves()[0].samples[0].value, tendon::NumericValue(0.75));
}

TEST(CurveFeed, DrawsAllNumbersOfAnArray) {
  CurveFeed feed = FeedOf({Joints("")});
  Subscribe(feed);
  Send(feed, 1s, {0.5, 0.75});

  EXPECT_THAT(Titles(feed), ElementsAre("robot/arm/state.Joints[0]", "robot/arm/state.Joints[1]"));
  EXPECT_EQ(feed.curves()[1].samples.at(0).value, tendon::NumericValue(0.75));
}

TEST(CurveFeed, KeepsTheLastSeconds) {
  CurveFeed feed = FeedOf({Joints("[0]")});
  Subscribe(feed);
  for (int second = 0; second <= 25; ++second) Send(feed, second * 1s, {1.0 * second, 0.0});

  EXPECT_NEAR(feed.curves()[0].samples.front().time, 15.0, 1e-6);
  EXPECT_NEAR(feed.curves()[0].samples.back().time, 25.0, 1e-6);
}

TEST(CurveFeed, RestartsWhenTheSourceRestarts) {
  CurveFeed feed = FeedOf({Joints("[0]")});
  Subscribe(feed);
  Send(feed, 100000s, {0.5, 0.0});
  Send(feed, 1s, {0.75, 0.0});

  ASSERT_EQ(feed.curves()[0].samples.size(), 1U) << "its clock has gone back";
  EXPECT_EQ(feed.curves()[0].samples[0].time, 1.0);
}

TEST(CurveFeed, SkipsGlobMatchesThatAreNotNumbers) {
  CurveFeed feed = FeedOf({Joints("[0]", true), Note(true)});
  Subscribe(feed);

  EXPECT_THAT(Titles(feed), ElementsAre("robot/arm/state.Joints[0]"));
  EXPECT_THAT(feed.notes(), ElementsAre(HasSubstr("robot/arm/state.Note: ")));
  EXPECT_FALSE(feed.mistake());
  EXPECT_FALSE(feed.is_empty());
}

TEST(CurveFeed, IsEmptyIfAllColumnsAreText) {
  CurveFeed feed = FeedOf({Note(true)});
  EXPECT_FALSE(feed.is_empty()) << "it is not known yet";

  Subscribe(feed);

  EXPECT_TRUE(feed.is_empty());
}

TEST(CurveFeed, RejectsATextColumnNamedByPath) {
  CurveFeed feed = FeedOf({Joints("[0]"), Note(false)});
  Subscribe(feed);

  ASSERT_TRUE(feed.mistake());
  EXPECT_THAT(feed.mistake()->message, HasSubstr("robot/arm/state.Note: '' is string, not one"));
}

TEST(CurveFeed, NotesTheReasonWhileTheSourceIsStale) {
  CurveFeed feed = FeedOf({Joints("")});
  Subscribe(feed);
  feed.OnStale({tendon::ErrorCode::kUnreachable, "robot is gone"});
  EXPECT_THAT(feed.notes(), ElementsAre("robot is gone"));

  Subscribe(feed);

  EXPECT_THAT(feed.notes(), IsEmpty());
}

TEST(CurveFeed, LimitsTheNumberOfCurves) {
  CurveFeed feed = FeedOf({Joints("")});
  feed.OnSubscribed({tendon::SchemaOf<std::array<double, 100>>(), tendon::SchemaOf<std::string>()});

  EXPECT_EQ(feed.curves().size(), CurveFeed::kMaxCurves);
  EXPECT_THAT(feed.notes(), ElementsAre(HasSubstr("robot/arm/state.Joints[16] and later numbers")));
}

}  // namespace
}  // namespace console
