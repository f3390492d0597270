#include <gcm_gui/plot/canvas/late_samples.h>
#include <gmock/gmock.h>

#include "../samples.h"

namespace tendon::gui {
namespace {

/// Returns 50 rows of 1 kHz. The rows from index `from` on are `by_ns` late.
std::vector<Sample> Delayed(std::uint64_t from, std::int64_t by_ns) {
  std::vector<Sample> rows = Rows(0, 50);
  for (Sample& row : rows) row.time_ns += row.tick >= from ? by_ns : 0;
  return rows;
}

SampleRing RingOf(const std::vector<Sample>& rows) {
  SampleRing ring;
  ring.append(rows);
  return ring;
}

TEST(LateSamples, ASampleDelayedByOverHalfAPeriodIsLate) {
  const SampleRing ring = RingOf(Delayed(30, 600'000));

  EXPECT_TRUE(IsLate(ring, 30));
  EXPECT_FALSE(IsLate(ring, 29));
  EXPECT_FALSE(IsLate(ring, 31)) << "as far behind the one before as ever";
  EXPECT_FALSE(IsLate(RingOf(Delayed(30, 400'000)), 30));
}

TEST(LateSamples, AreDetectedOnArrival) {
  const std::vector<Sample> rows = Delayed(30, 600'000);
  SampleRing ring;
  for (const Sample& row : rows) {
    ring.append(std::vector{row});
    EXPECT_EQ(IsLate(ring, row.tick), row.tick == 30) << row.tick;
  }
}

TEST(LateSamples, ASampleAfterALossIsNotLate) {
  std::vector<Sample> rows = Rows(0, 50);
  rows.erase(rows.begin() + 20, rows.begin() + 35);

  EXPECT_FALSE(IsLate(RingOf(rows), 20));
}

TEST(LateSamples, FewSamplesAreNeverLate) {
  const SampleRing ring = RingOf(Delayed(3, 50'000'000));

  for (std::uint64_t i = 0; i < 4; ++i) EXPECT_FALSE(IsLate(ring, i));
}

TEST(LateSamples, ARestartedSourceIsNotLate) {
  SampleRing ring = RingOf(Rows(0, 50));
  ring.beginEpoch();
  std::vector<Sample> rows = Rows(0, 3);
  for (Sample& row : rows) row.time_ns += kSecond;
  ring.append(rows);

  EXPECT_FALSE(IsLate(ring, 50));
}

}  // namespace
}  // namespace tendon::gui
