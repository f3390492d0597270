#include <gtest/gtest.h>
#include <tendon/base/os/thread.h>
#include <tendon/gcm/column_layout.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace tendon::graph {
namespace {

using Block = ColumnLayout::Block;

constexpr ColumnLayout::Spacing kSpacing{50, 10};
constexpr double kHeight = 20;

std::string Name(std::size_t i) { return "block_" + std::to_string(1000 + i); }

std::vector<Block> Blocks(std::size_t count) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < count; ++i) blocks.push_back({Name(i), {100, kHeight}, true});
  return blocks;
}

std::vector<Rect> RectsOf(const ColumnLayout& layout, std::size_t count) {
  std::vector<Rect> rects;
  for (std::size_t i = 0; i < count; ++i) rects.push_back(layout.rect(Name(i)));
  return rects;
}

/// Expects that the blocks of each column do not overlap.
void ExpectApart(std::vector<Rect> rects) {
  std::sort(rects.begin(), rects.end(),
            [](const Rect& a, const Rect& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  for (std::size_t i = 1; i < rects.size(); ++i) {
    if (rects[i].x != rects[i - 1].x) continue;
    EXPECT_GE(rects[i].y, rects[i - 1].y + rects[i - 1].height + kSpacing.rows) << i;
  }
}

TEST(ColumnLayout, ANewBlockTakesTheFreePlaceNearestItsPeers) {
  ColumnLayout layout(kSpacing);
  // The edges are 0 -> 1, 2 -> 3 and 4 -> 5.
  std::vector<Block> blocks = Blocks(6);
  std::vector<LayerEdge> edges{{0, 1}, {2, 3}, {4, 5}};
  ASSERT_TRUE(layout.Arrange(blocks, edges));
  const std::vector<Rect> before = RectsOf(layout, 6);

  blocks.push_back({Name(6), {100, kHeight}, true});
  edges.push_back({2, 6});
  ASSERT_TRUE(layout.Arrange(blocks, edges));

  EXPECT_EQ(RectsOf(layout, 6), before);
  EXPECT_EQ(layout.rect(Name(6)).x, before[3].x);
  ExpectApart(RectsOf(layout, 7));
  EXPECT_FALSE(layout.Arrange(blocks, edges)) << "nothing is new";
}

TEST(ColumnLayout, AGrownBlockPushesDownTheBlocksBelow) {
  ColumnLayout layout(kSpacing);
  std::vector<Block> blocks = Blocks(6);
  const std::vector<LayerEdge> edges{{0, 1}, {2, 3}, {4, 5}};
  layout.Arrange(blocks, edges);

  blocks[0].size.height = 3 * kHeight;
  layout.Arrange(blocks, edges);

  ExpectApart(RectsOf(layout, 6));
}

/// The time is only reported. A window must place a thousand blocks within one turn of its event
/// loop.
TEST(ColumnLayout, AThousandBlocksInAColumnDoNotOverlap) {
  constexpr std::size_t kCount = 1000;
  std::vector<LayerEdge> edges;
  for (std::size_t i = 1; i < kCount; ++i) edges.push_back({0, i});
  const auto time = [](const char* what, ColumnLayout& layout, std::size_t count,
                       const std::vector<LayerEdge>& given) {
    const auto before = os::ThreadCpuTime();
    layout.Arrange(Blocks(count), given);
    const std::chrono::duration<double, std::milli> used = os::ThreadCpuTime() - before;
    testing::Test::RecordProperty(what, std::to_string(used.count()));
    std::printf("  %-32s %7.2f ms\n", what, used.count());
    ExpectApart(RectsOf(layout, count));
  };
  ColumnLayout clients(kSpacing);
  time("clients of one", clients, kCount, edges);
  edges.push_back({0, kCount});
  time("one more", clients, kCount + 1, edges);
  ColumnLayout loose(kSpacing);
  time("loose ones", loose, kCount, {});
  time("one more of them", loose, kCount + 1, {});
}

TEST(Layers, AClientIsRightOfAllItsProviders) {
  // The edges are 0 -> 1 -> 3 and 0 -> 3. Block 2 has none.
  EXPECT_EQ(LayersOf(4, {{0, 1}, {1, 3}, {0, 3}}), (std::vector{0, 1, 0, 2}));
}

TEST(Layers, ACycleIsBrokenOnce) {
  const std::vector<int> layers = LayersOf(3, {{0, 1}, {1, 2}, {2, 0}});

  int rising = 0;
  for (const auto& [from, to] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}}) {
    if (layers[static_cast<std::size_t>(from)] < layers[static_cast<std::size_t>(to)]) ++rising;
  }
  EXPECT_EQ(rising, 2);
}

TEST(Layers, ASelfConnectionDoesNotChangeTheLayer) {
  EXPECT_EQ(LayersOf(1, {{0, 0}}), std::vector{0});
}

TEST(Layers, ALongChainNeedsNoRecursion) {
  std::vector<LayerEdge> edges;
  for (std::size_t i = 0; i + 1 < 20000; ++i) edges.push_back({i, i + 1});

  EXPECT_EQ(LayersOf(20000, edges).back(), 19999);
}

}  // namespace
}  // namespace tendon::graph
