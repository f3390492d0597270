#include <gcm_gui/plot/series/envelope.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "../samples.h"

namespace tendon::gui {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Scene {
  SampleRing ring{2048};
  TimeSlices slices;
};

// Returns a random scene with uneven times, gaps, restarts, values that are not finite, and a
// wrapped ring.
Scene RandomScene(std::mt19937& random) {
  const auto within = [&](int low, int high) {
    return std::uniform_int_distribution(low, high)(random);
  };
  Scene scene;
  Sample sample;
  const int count = within(0, 4000);
  for (int i = 0; i < count; ++i) {
    sample.time_ns += within(0, 2'000'000);
    sample.tick += within(0, 99) == 0 ? 5U : 1U;
    sample.value = std::normal_distribution(0.0, 10.0)(random);
    if (within(0, 99) == 0) sample.value = within(0, 1) == 0 ? kInfinity : -std::nan("");
    if (within(0, 499) == 0) scene.ring.beginEpoch();
    scene.ring.append({&sample, 1});
  }
  scene.slices.from_ns = within(-100'000'000, static_cast<int>(sample.time_ns / 2));
  scene.slices.to_ns = scene.slices.from_ns + within(1000, 2'000'000'000);
  scene.slices.count = static_cast<std::size_t>(within(1, 3000));
  return scene;
}

// Computes the envelope by its definition: the line through the samples, cut at each border between
// two slices.
class Reference {
 public:
  explicit Reference(const Scene& scene)
      : scene_(scene), low(scene.slices.count, kInfinity), high(scene.slices.count, -kInfinity) {
    const SampleRing& ring = scene.ring;
    for (auto i = ring.firstIndex(); i < ring.endIndex(); ++i) {
      if (!std::isfinite(ring.value(i))) continue;
      include(SliceOf(ring.time(i)), ring.value(i));
      if (i + 1 < ring.endIndex() && joined(i)) line(i);
    }
  }

 private:
  [[nodiscard]] std::int64_t BorderOf(std::int64_t slice) const {
    const double width = static_cast<double>(scene_.slices.to_ns - scene_.slices.from_ns) /
                         static_cast<double>(scene_.slices.count);
    return scene_.slices.from_ns + std::llround(static_cast<double>(slice) * width);
  }
  [[nodiscard]] std::int64_t SliceOf(std::int64_t time_ns) const {
    std::int64_t slice = -1;
    const auto count = static_cast<std::int64_t>(scene_.slices.count);
    while (slice < count && BorderOf(slice + 1) <= time_ns) ++slice;
    return slice;
  }
  [[nodiscard]] bool joined(std::uint64_t index) const {
    const auto& gaps = scene_.ring.gaps();
    return std::isfinite(scene_.ring.value(index + 1)) &&
           std::none_of(gaps.begin(), gaps.end(),
                        [&](const Gap& gap) { return gap.index == index + 1; });
  }
  void line(std::uint64_t index) {
    const SampleRing& ring = scene_.ring;
    const std::int64_t t0 = ring.time(index);
    const std::int64_t t1 = ring.time(index + 1);
    for (std::size_t slice = 0; slice < scene_.slices.count; ++slice) {
      const std::int64_t enter = std::max(BorderOf(static_cast<std::int64_t>(slice)), t0);
      const std::int64_t leave = std::min(BorderOf(static_cast<std::int64_t>(slice) + 1), t1);
      const bool crosses = enter <= leave && t1 > t0 && SliceOf(t0) != SliceOf(t1) &&
                           SliceOf(t0) <= static_cast<std::int64_t>(slice) &&
                           SliceOf(t1) >= static_cast<std::int64_t>(slice);
      if (!crosses) continue;
      for (const std::int64_t time : {enter, leave}) {
        const double part = static_cast<double>(time - t0) / static_cast<double>(t1 - t0);
        include(static_cast<std::int64_t>(slice),
                ring.value(index) + part * (ring.value(index + 1) - ring.value(index)));
      }
    }
  }
  void include(std::int64_t slice, double value) {
    if (slice < 0 || slice >= static_cast<std::int64_t>(low.size())) return;
    const auto i = static_cast<std::size_t>(slice);
    low[i] = std::min(low[i], value);
    high[i] = std::max(high[i], value);
  }

  const Scene& scene_;

 public:
  std::vector<double> low;
  std::vector<double> high;
};

TEST(Envelope, IntegersAreDrawnAsSteps) {
  std::vector<Sample> rows = Rows(0, 2);
  rows[0].value = ExactNumber::Signed(2);
  rows[1].value = ExactNumber::Signed(7);
  rows[1].time_ns = 600 * kMillisecond;
  SampleRing ring;
  ring.append(rows);
  Envelope envelope;

  envelope.build(ring, {.from_ns = 0, .to_ns = kSecond, .count = 10});

  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(envelope.low()[i], 2);
    EXPECT_EQ(envelope.high()[i], 2) << "a value that never was, in slice " << i;
  }
  EXPECT_EQ(envelope.low()[6], 2);
  EXPECT_EQ(envelope.high()[6], 7);
}

TEST(Envelope, IntegersAreDistancesFromTheBase) {
  constexpr std::int64_t kStamp = 1'764'300'000'123'456'789;
  std::vector<Sample> rows = Rows(0, 1000);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].value = ExactNumber::Signed(kStamp + static_cast<std::int64_t>(i));
  }
  SampleRing ring;
  ring.append(rows);
  const TimeSlices slices{.from_ns = 0, .to_ns = kSecond, .count = 1000};
  Envelope envelope;
  envelope.build(ring, slices);
  EXPECT_EQ(envelope.lowest(), static_cast<double>(kStamp));

  envelope.build(ring, slices, 1'764'300'000'000'000'000);

  EXPECT_EQ(envelope.lowest(), 123'456'789);
  EXPECT_EQ(envelope.highest(), 123'457'788);
}

TEST(Envelope, MatchesTheReferenceForRandomScenes) {
  std::mt19937 random(20240607);
  for (int round = 0; round < 60; ++round) {
    Scene scene = RandomScene(random);
    scene.slices.count = std::min<std::size_t>(scene.slices.count, 200);  // the reference is slow
    Envelope envelope;
    envelope.build(scene.ring, scene.slices);
    const Reference reference(scene);
    for (std::size_t i = 0; i < scene.slices.count; ++i) {
      if (reference.low[i] > reference.high[i]) {
        ASSERT_GT(envelope.low()[i], envelope.high()[i]) << "round " << round << " slice " << i;
        continue;
      }
      ASSERT_NEAR(envelope.low()[i], reference.low[i], 1e-6) << "round " << round << " slice " << i;
      ASSERT_NEAR(envelope.high()[i], reference.high[i], 1e-6)
          << "round " << round << " slice " << i;
    }
  }
}

TEST(Envelope, ContainsEveryExtreme) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const Scene scene = RandomScene(random);
    Envelope envelope;
    envelope.build(scene.ring, scene.slices);

    double lowest = kInfinity;
    double highest = -kInfinity;
    for (auto i = scene.ring.firstIndex(); i < scene.ring.endIndex(); ++i) {
      const bool shown = scene.ring.time(i) >= scene.slices.from_ns &&
                         scene.ring.time(i) < scene.slices.to_ns &&
                         std::isfinite(scene.ring.value(i));
      if (!shown) continue;
      lowest = std::min(lowest, scene.ring.value(i));
      highest = std::max(highest, scene.ring.value(i));
    }
    ASSERT_LE(envelope.lowest(), lowest);
    ASSERT_GE(envelope.highest(), highest);
  }
}

// The update reuses and shifts the previous envelope. This must not change the result.
TEST(Envelope, AnIncrementalUpdateMatchesARebuild) {
  constexpr std::int64_t kWidth = 7 * kMillisecond;
  constexpr std::size_t kCount = 150;
  std::mt19937 random(5);
  const auto within = [&](int low, int high) {
    return std::uniform_int_distribution(low, high)(random);
  };
  SampleRing ring(4096);
  Envelope moved;
  TimeSlices slices{.from_ns = -kWidth * 100, .to_ns = kWidth * 50, .count = kCount};
  Sample sample;
  for (int frame = 0; frame < 400; ++frame) {
    const int rows = within(0, 40);
    for (int i = 0; i < rows; ++i) {
      sample.time_ns += within(1, 3) * kMillisecond;
      sample.tick += within(0, 99) == 0 ? 9U : 1U;
      sample.value = within(0, 50) == 0 ? kInfinity : within(-1000, 1000);
      ring.append({&sample, 1});
    }
    const std::int64_t by = within(0, 9) * kWidth;
    slices.from_ns += by;
    slices.to_ns += by;
    moved.build(ring, slices);
    Envelope anew;
    anew.build(ring, slices);

    // At a border, the value may be interpolated between other samples, so the results may differ
    // by rounding.
    for (std::size_t i = 0; i < kCount; ++i) {
      ASSERT_EQ(moved.low()[i] > moved.high()[i], anew.low()[i] > anew.high()[i]) << frame;
      if (anew.low()[i] > anew.high()[i]) continue;
      ASSERT_NEAR(moved.low()[i], anew.low()[i], 1e-9) << "frame " << frame << " slice " << i;
      ASSERT_NEAR(moved.high()[i], anew.high()[i], 1e-9) << "frame " << frame << " slice " << i;
    }
    ASSERT_EQ(moved.lowest(), anew.lowest());
    ASSERT_EQ(moved.highest(), anew.highest());
  }
}

TEST(Envelope, DroppedSamplesAreNotShown) {
  SampleRing ring(1024);
  Envelope envelope;
  const TimeSlices slices{.from_ns = 0, .to_ns = 4 * kSecond, .count = 400};
  ring.append(Rows(0, 1000));
  envelope.build(ring, slices);

  ring.append(Rows(1000, 3000));
  envelope.build(ring, slices);

  EXPECT_GT(envelope.low()[10], envelope.high()[10]);
  EXPECT_LT(envelope.low()[250], envelope.high()[250]);
}

TEST(Envelope, ASingleSampleFillsOneSlice) {
  SampleRing ring;
  ring.append(std::vector<Sample>{{.time_ns = 55, .tick = 1, .value = 3}});
  Envelope envelope;

  envelope.build(ring, {.from_ns = 0, .to_ns = 100, .count = 10});

  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(envelope.low()[i] <= envelope.high()[i], i == 5) << i;
  }
}

TEST(Envelope, ALineBetweenTwoSamplesOutsideCrossesAllSlices) {
  SampleRing ring;
  ring.append(std::vector<Sample>{{.time_ns = -100, .tick = 1, .value = 0},
                                  {.time_ns = 300, .tick = 2, .value = 4}});
  Envelope envelope;

  envelope.build(ring, {.from_ns = 0, .to_ns = 100, .count = 2});

  EXPECT_THAT(envelope.low(), testing::ElementsAre(1.0, 1.5));
  EXPECT_THAT(envelope.high(), testing::ElementsAre(1.5, 2.0));
}

TEST(Envelope, TheLineEndsAtAGap) {
  SampleRing ring;
  ring.append(std::vector<Sample>{{.time_ns = 5, .tick = 1, .value = 0},
                                  {.time_ns = 95, .tick = 9, .value = 1}});
  Envelope envelope;

  envelope.build(ring, {.from_ns = 0, .to_ns = 100, .count = 10});

  EXPECT_GT(envelope.low()[5], envelope.high()[5]);
  EXPECT_EQ(envelope.high()[9], 1);
}

TEST(Envelope, AnEmptyRingShowsNothing) {
  Envelope envelope;

  envelope.build(SampleRing(), {.from_ns = 0, .to_ns = 100, .count = 10});

  EXPECT_GT(envelope.lowest(), envelope.highest());
}

}  // namespace
}  // namespace tendon::gui
