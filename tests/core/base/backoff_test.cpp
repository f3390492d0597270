#include <gtest/gtest.h>
#include <tendon/base/backoff.h>

#include <set>
#include <vector>

namespace tendon {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kShortest(100);
constexpr milliseconds kLongest(700);

TEST(Backoff, DoublesThePauseUpToTheLongest) {
  Backoff backoff(kShortest, kLongest);

  std::vector<int> pauses;
  for (int i = 0; i < 5; ++i) pauses.push_back(static_cast<int>(backoff.Next().count()));

  EXPECT_EQ(pauses, (std::vector{100, 200, 400, 700, 700}));
}

TEST(Backoff, RestartsWithTheShortestPauseAfterAReset) {
  Backoff backoff(kShortest, kLongest);
  EXPECT_FALSE(backoff.has_begun());
  (void)backoff.Next();
  (void)backoff.Next();
  EXPECT_TRUE(backoff.has_begun());

  backoff.Reset();

  EXPECT_FALSE(backoff.has_begun());
  EXPECT_EQ(backoff.Next(), kShortest);
}

TEST(Backoff, ShortensThePauseByARandomJitter) {
  std::set<milliseconds> pauses;
  for (int i = 0; i < 100; ++i) {
    Backoff backoff(kShortest, kLongest, 0.25);
    (void)backoff.Next();
    pauses.insert(backoff.Next());
  }

  EXPECT_GE(*pauses.begin(), milliseconds(150));
  EXPECT_LE(*pauses.rbegin(), milliseconds(200));
  EXPECT_GT(pauses.size(), 1U);
}

TEST(Backoff, DoublesThePauseWithoutItsJitter) {
  Backoff backoff(kShortest, kLongest, 0.5);
  for (int i = 0; i < 3; ++i) (void)backoff.Next();

  EXPECT_GE(backoff.Next(), kLongest / 2);
}

}  // namespace
}  // namespace tendon
