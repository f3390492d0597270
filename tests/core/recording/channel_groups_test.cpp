#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/memory_file.h>
#include <tendon/recording/channel_groups.h>
#include <tendon/recording/recording_format.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "recordings.h"

namespace tendon::recording {
namespace {

using testing::ElementsAre;

std::unique_ptr<mcap::Reader> WithColumns(
    const std::vector<std::pair<std::string, std::string>>& topics_and_epochs) {
  mcap::MemoryRecording recording;
  for (const auto& [topic, epoch] : topics_and_epochs) {
    EXPECT_TRUE(recording.writer->AddChannel(
        0, topic, "cdr", {{kKindKey, "column"}, {kEpochKey, epoch}, {kSchemaKey, "float64"}}));
  }
  EXPECT_TRUE(recording.writer->Close());
  return mcap::Open(recording.disk->bytes);
}

std::vector<std::size_t> SizesOf(const std::vector<ChannelGroup>& groups) {
  std::vector<std::size_t> sizes;
  for (const ChannelGroup& group : groups) sizes.push_back(group.channels.size());
  return sizes;
}

TEST(ChannelGroups, ATableIsAGroupForEachStartOfItsSource) {
  const auto reader = WithColumns({{"robot/arm/state/A", "1"},
                                   {"robot/arm/state/B", "1"},
                                   {"robot/arm/state/A", "2"},
                                   {"robot/cart/state/A", "1"}});

  const auto groups = GroupsOf(*reader, {});

  EXPECT_THAT(SizesOf(groups), ElementsAre(2U, 1U, 1U));
  EXPECT_EQ(groups[0].path, "robot/arm/state");
  EXPECT_EQ(groups[2].path, "robot/cart/state");
}

TEST(ChannelGroups, AnotherChoiceOfColumnsIsAGroupOfItsOwn) {
  const auto reader = WithColumns({{"robot/arm/state/A", "1"},
                                   {"robot/arm/state/B", "1"},
                                   {"robot/arm/state/A", "1"},
                                   {"robot/arm/state/B", "1"},
                                   {"robot/arm/state/C", "1"}});

  EXPECT_THAT(SizesOf(GroupsOf(*reader, {})), ElementsAre(2U, 3U));
}

TEST(ChannelGroups, NumbersOfAHostileFileWrapAroundToSomeSourceTime) {
  constexpr auto kMin = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMax = std::numeric_limits<std::int64_t>::max();

  EXPECT_EQ(SourceTimeOf(900, 400), 500);
  EXPECT_EQ(SourceTimeOf(400, 900), -500);
  EXPECT_EQ(SourceTimeOf(static_cast<mcap::Timestamp>(kMax), -1), kMin);
  EXPECT_EQ(SourceTimeOf(0, kMin), kMin);
}

}  // namespace
}  // namespace tendon::recording
