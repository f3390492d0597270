#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/base/dependency_order.h>

namespace tendon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(DependencyOrder, IsEmptyWithoutNodes) { EXPECT_THAT(DependencyOrder({}), IsEmpty()); }

TEST(DependencyOrder, KeepsTheNumberOrderWithoutDependencies) {
  EXPECT_THAT(DependencyOrder({{}, {}, {}}), ElementsAre(0, 1, 2));
}

TEST(DependencyOrder, PutsEachNodeAfterItsDependencies) {
  EXPECT_THAT(DependencyOrder({{1}, {2}, {}}), ElementsAre(2, 1, 0));
  EXPECT_THAT(DependencyOrder({{2, 1}, {}, {1}}), ElementsAre(1, 2, 0));
}

TEST(DependencyOrder, IgnoresEdgesThatCloseACycle) {
  EXPECT_THAT(DependencyOrder({{1}, {2}, {0}}), ElementsAre(2, 1, 0));
  EXPECT_THAT(DependencyOrder({{0}}), ElementsAre(0));
}

TEST(DependencyOrder, SortsALongChain) {
  constexpr std::size_t kLength = 100'000;
  Dependencies chain(kLength);
  for (std::size_t i = 0; i + 1 < kLength; ++i) chain[i] = {i + 1};

  EXPECT_EQ(DependencyOrder(chain).front(), kLength - 1);
}

}  // namespace
}  // namespace tendon
