#include <gtest/gtest.h>
#include <tendon/gcm/layers.h>

namespace tendon::graph {
namespace {

TEST(Layers, AClientIsRightOfAllItsProviders) {
  // 0 -> 1 -> 3, 0 -> 3, 2 alone
  EXPECT_EQ(LayersOf(4, {{0, 1}, {1, 3}, {0, 3}}), (std::vector{0, 1, 0, 2}));
}

TEST(Layers, ARingIsCutOnce) {
  const std::vector<int> layers = LayersOf(3, {{0, 1}, {1, 2}, {2, 0}});

  int rising = 0;
  for (const auto& [from, to] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}}) {
    if (layers[static_cast<std::size_t>(from)] < layers[static_cast<std::size_t>(to)]) ++rising;
  }
  EXPECT_EQ(rising, 2);
}

TEST(Layers, OneThatProvidesToItselfStaysWhereItIs) {
  EXPECT_EQ(LayersOf(1, {{0, 0}}), std::vector{0});
}

TEST(Layers, ALongChainNeedsNoRecursion) {
  std::vector<LayerEdge> edges;
  for (std::size_t i = 0; i + 1 < 20000; ++i) edges.push_back({i, i + 1});

  EXPECT_EQ(LayersOf(20000, edges).back(), 19999);
}

}  // namespace
}  // namespace tendon::graph
