#include <gtest/gtest.h>
#include <tendon/recording/recording_entry.h>

#include <cstddef>
#include <memory>

namespace tendon::recording {
namespace {

std::shared_ptr<const EntrySource> SourceOf(const InterfaceName& name) {
  return std::make_shared<const EntrySource>(
      EntrySource{name, {{"Limit", Schema(Schema::Kind::kUint8)}}});
}

TEST(RecordingEntry, HasThePathOfItsTableOrEvent) {
  EXPECT_EQ(PathOf(RowsEntry{.source = SourceOf({"robot", "arm", "state"})}), "robot/arm/state");
  EXPECT_EQ(PathOf(EventEntry{SourceOf({"robot", "arm", "Control"}), 0, SteadyTime{}, {}}),
            "robot/arm/Control.Limit");
  EXPECT_EQ(PathOf(LogEntry{}), "");
}

TEST(RecordingEntry, AnEntryTakesAsMuchMemoryAsItsContent) {
  RowsEntry rows{.source = SourceOf({"robot", "arm", "state"})};
  const std::size_t before = SizeOf(rows);

  rows.cells.resize(100);

  EXPECT_EQ(SizeOf(rows), before + 100);
  EXPECT_EQ(SizeOf(RecordingEntry(rows)), SizeOf(rows));
}

TEST(Losses, CountTheRowsOfAnEntryThatWereNotWritten) {
  RowsEntry rows{.source = SourceOf({"robot", "arm", "state"})};
  rows.ticks = {1, 2, 3};
  Losses losses;

  losses.AddUnwritten(rows, 1);
  losses.AddUnwritten(LogEntry{});

  EXPECT_EQ(losses.rows.at("robot/arm/state").viewer, 2U);
  EXPECT_EQ(losses.log, 1U);
  EXPECT_EQ(losses.all(), 3U);
}

TEST(Losses, AreEmptyIfAllRowsOfAnEntryWereWritten) {
  RowsEntry rows{.source = SourceOf({"robot", "arm", "state"})};
  rows.ticks = {1, 2, 3};
  Losses losses;

  losses.AddUnwritten(rows, 3);

  EXPECT_TRUE(losses.rows.empty());
}

}  // namespace
}  // namespace tendon::recording
