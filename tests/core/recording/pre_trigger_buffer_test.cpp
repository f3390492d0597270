#include <gtest/gtest.h>
#include <tendon/recording/pre_trigger_buffer.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr std::size_t kMuch = std::size_t{1} << 30U;

SteadyTime At(std::chrono::milliseconds time) { return SteadyTime(time); }

/// Returns rows of one column with a distance of one millisecond. The value of a row is its tick.
RowsEntry RowsFrom(std::uint64_t first, std::size_t count, std::uint64_t lost = 0) {
  static const auto kSource = std::make_shared<const EntrySource>(
      EntrySource{{"robot", "arm", "state"}, {{"Tick", Schema(Schema::Kind::kUint8)}}});
  RowsEntry rows{.source = kSource, .lost_before = {.table = lost}};
  for (std::uint64_t tick = first; tick < first + count; ++tick) {
    rows.ticks.push_back(tick);
    rows.times.push_back(static_cast<std::int64_t>(tick) * 1'000'000);
    rows.cell_sizes.push_back(1);
    rows.cells.push_back(static_cast<std::byte>(tick));
  }
  return rows;
}

/// Returns the ticks of all rows, and checks the cells.
std::vector<std::uint64_t> TicksOf(const std::deque<RecordingEntry>& entries) {
  std::vector<std::uint64_t> ticks;
  for (const RecordingEntry& entry : entries) {
    const auto* rows = std::get_if<RowsEntry>(&entry);
    if (rows == nullptr) continue;
    EXPECT_EQ(rows->cells.size(), rows->ticks.size());
    for (std::size_t i = 0; i < rows->ticks.size(); ++i) {
      EXPECT_EQ(rows->cells.at(i), static_cast<std::byte>(rows->ticks[i]));
      ticks.push_back(rows->ticks[i]);
    }
  }
  return ticks;
}

TEST(PreTriggerBuffer, ReturnsTheRowsSinceATime) {
  PreTriggerBuffer past(5s, kMuch, 0);
  past.Add(RowsFrom(0, 10), At(10ms));
  past.Add(RowsFrom(10, 10), At(20ms));

  EXPECT_EQ(TicksOf(past.TakeSince(At(7ms))),
            (std::vector<std::uint64_t>{7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19}));
  EXPECT_TRUE(past.TakeSince(At(0ms)).empty());
  EXPECT_EQ(past.bytes(), 0U);
}

TEST(PreTriggerBuffer, DropsOldEntriesWithoutCountingThem) {
  PreTriggerBuffer past(1s, kMuch, 0);
  past.Add(RowsFrom(0, 10), At(10ms));
  past.Add(RowsFrom(5000, 10), At(5010ms));

  EXPECT_EQ(past.MissingSince(At(0ms)).all(), 0U);
  EXPECT_EQ(TicksOf(past.TakeSince(At(0ms))).front(), 5000U);
}

TEST(PreTriggerBuffer, CountsEntriesThatExceedItsMemory) {
  PreTriggerBuffer past(5s, SizeOf(RecordingEntry(RowsFrom(0, 10))), 0);
  past.Add(RowsFrom(0, 10), At(10ms));
  past.Add(EventEntry{RowsFrom(0, 1).source, 0, At(15ms), {}}, At(15ms));
  past.Add(RowsFrom(20, 10), At(30ms));

  EXPECT_EQ(past.MissingSince(At(0ms)).all_rows().viewer, 10U);
  EXPECT_EQ(past.MissingSince(At(0ms)).all_events(), 1U);
  EXPECT_EQ(past.MissingSince(At(12ms)).all_rows().all(), 0U);
  EXPECT_EQ(TicksOf(past.TakeSince(At(0ms))).size(), 10U);
}

TEST(PreTriggerBuffer, CountsMissingEntriesOfEachPath) {
  PreTriggerBuffer past(5s, 1, 0);
  past.Add(RowsFrom(0, 10, 3), At(10ms));
  past.Add(RowsFrom(20, 10, 4), At(30ms));
  past.Add(EventEntry{RowsFrom(0, 1).source, 0, At(45ms), {}}, At(45ms));
  past.Add(RowsFrom(50, 10), At(60ms));

  const Losses missing = past.MissingSince(At(15ms));
  const auto lost_before = past.LostBeforeMissingSince(At(15ms));
  (void)past.TakeSince(At(15ms));

  EXPECT_EQ(missing.rows.at("robot/arm/state").viewer, 10U);
  EXPECT_EQ(missing.events.at("robot/arm/state.Tick"), 1U);
  EXPECT_EQ(lost_before.at("robot/arm/state").table, 4U);
  EXPECT_EQ(past.losses().at("robot/arm/state").table, 3U) << "only those before 15 ms";
}

TEST(PreTriggerBuffer, ReturnsTheCatalogueOfThatTimeFirst) {
  CatalogueEntry added{.received = At(1ms)};
  CatalogueChange process;
  process.revision = 1;
  process.process = "robot";
  process.processes = {{.name = "robot", .instance = 1}};
  added.changes = {process};
  PreTriggerBuffer past(1s, kMuch, 0);
  past.Add(added, At(1ms));
  past.Add(RowsFrom(5000, 10), At(5010ms));

  const auto taken = past.TakeSince(At(5000ms));

  ASSERT_EQ(taken.size(), 2U);
  const auto& snapshot = std::get<CatalogueEntry>(taken.front());
  EXPECT_TRUE(snapshot.is_snapshot);
  ASSERT_EQ(snapshot.changes.size(), 1U);
  EXPECT_EQ(snapshot.changes.front().process, "robot");
}

TEST(PreTriggerBuffer, SeparatesLossesBeforeTheRecording) {
  PreTriggerBuffer past(5s, kMuch, 0);
  past.Add(RowsFrom(10, 10, 3), At(20ms));
  past.Add(RowsFrom(25, 10, 5), At(40ms));

  const auto taken = past.TakeSince(At(15ms));

  EXPECT_EQ(past.losses().at("robot/arm/state").table, 3U) << "they were lost before 15 ms";
  EXPECT_EQ(std::get<RowsEntry>(taken.at(0)).lost_before.table, 0U);
  EXPECT_EQ(std::get<RowsEntry>(taken.at(1)).lost_before.table, 5U);
}

TEST(Trim, KeepsTheRowsWithinTheTime) {
  RecordingEntry entry = RowsFrom(0, 10);

  ASSERT_TRUE(Trim(entry, At(3ms), At(5ms), 0));
  EXPECT_EQ(std::get<RowsEntry>(entry).ticks, (std::vector<std::uint64_t>{3, 4, 5}));
  EXPECT_FALSE(Trim(entry, At(6ms), At(9ms), 0));
}

TEST(Trim, RemovesAnEntryWhoseRowsAreAllOutsideTheTime) {
  RecordingEntry entry = RowsFrom(0, 2);

  EXPECT_FALSE(Trim(entry, SteadyTime(100us), SteadyTime(200us), 0));
}

}  // namespace
}  // namespace tendon::recording
