#include <gcm_gui/plot/series/mark_track.h>
#include <gtest/gtest.h>

namespace tendon::gui {
namespace {

TEST(MarkTrack, KeepsTheNewestMarksInOrder) {
  MarkTrack track;
  track.add({.time_ns = 5, .label = "b"});
  track.add({.time_ns = 3, .label = "a"});
  for (std::size_t i = 1; i < MarkTrack::kMax; ++i) track.add({.time_ns = 10, .label = "c"});

  ASSERT_EQ(track.all().size(), MarkTrack::kMax);
  EXPECT_EQ(track.all().front().label, "b");
}

TEST(MarkTrack, FindsMarksInAClosedInterval) {
  MarkTrack track;
  for (const std::int64_t time : {1, 2, 3, 4}) {
    track.add({.time_ns = time, .label = QString::number(time)});
  }

  const auto [first, end] = track.between(2, 3);

  EXPECT_EQ(first->label, "2");
  EXPECT_EQ(end - first, 2);
}

}  // namespace
}  // namespace tendon::gui
