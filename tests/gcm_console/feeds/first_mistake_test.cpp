#include <gcm_console/feeds/curve_feed.h>
#include <gcm_console/feeds/first_mistake.h>
#include <gtest/gtest.h>
#include <tendon/payload/schema.h>

#include <memory>
#include <string>
#include <vector>

namespace console {
namespace {

struct FedTable {
  std::shared_ptr<CurveFeed> feed;
};

/// Makes the feed of a column with a text. A text cannot be plotted: the path is a mistake if it
/// was typed, and left out if a glob has found it.
FedTable TextTable(bool is_found) {
  const RowInbox::WantedPath note{*tendon::ParsePath("robot/arm/state.Note"), 0, is_found};
  auto feed = std::make_shared<CurveFeed>(std::vector{note}, 10.0);
  feed->OnSubscribed({tendon::SchemaOf<std::string>()});
  return {feed};
}

FedTable NumberTable() {
  const RowInbox::WantedPath mode{*tendon::ParsePath("robot/arm/state.Mode"), 0};
  auto feed = std::make_shared<CurveFeed>(std::vector{mode}, 10.0);
  feed->OnSubscribed({tendon::SchemaOf<double>()});
  return {feed};
}

std::string MistakeOf(const std::vector<FedTable>& tables) {
  const auto mistake = FirstMistake(tables, &FedTable::feed, "nothing is left");
  return mistake ? mistake->message : "";
}

TEST(FirstMistake, IsThatOfATypedPath) {
  const FedTable wrong = TextTable(false);
  ASSERT_TRUE(wrong.feed->mistake());

  EXPECT_EQ(MistakeOf({NumberTable(), wrong}), wrong.feed->mistake()->message);
}

TEST(FirstMistake, IsMissingIfOneTableHasAPath) {
  EXPECT_EQ(MistakeOf({TextTable(true), NumberTable()}), "");
}

TEST(FirstMistake, SaysThatNothingIsLeftIfAllPathsAreLeftOut) {
  EXPECT_EQ(MistakeOf({TextTable(true), TextTable(true)}), "nothing is left");
}

}  // namespace
}  // namespace console
