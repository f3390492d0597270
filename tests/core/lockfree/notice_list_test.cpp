#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/lockfree/notice_list.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace tendon {
namespace {

TEST(NoticeList, ReturnsAllNoticesInOrder) {
  NoticeList<std::string> list;
  for (const char* const text : {"one", "two", "three"}) list.Send(text);
  std::vector<std::string> taken;

  list.Take([&](const std::string& text) { taken.push_back(text); });
  list.Take([&](const std::string& /*text*/) { FAIL() << "each comes once"; });

  EXPECT_EQ(taken, (std::vector<std::string>{"one", "two", "three"}));
}

TEST(NoticeList, TakingNeitherAllocatesNorFrees) {
  NoticeList<std::shared_ptr<int>> list;
  const auto notice = std::make_shared<int>(17);
  list.Send(notice);
  {
    const tendon::AllocationGuard guard;
    list.Take([](const auto& /*notice*/) {});
  }
  EXPECT_EQ(notice.use_count(), 2);  // the sender still has to free it

  list.Send(nullptr);

  EXPECT_EQ(notice.use_count(), 1);
}

TEST(NoticeList, FindsUnreadNotices) {
  NoticeList<int> list;
  list.Send(1);
  const auto is = [](int wanted) { return [wanted](int one) { return one == wanted; }; };

  EXPECT_TRUE(list.HasUnread(is(1)));
  EXPECT_FALSE(list.HasUnread(is(2)));
  list.Take([](int /*one*/) {});

  EXPECT_FALSE(list.HasUnread(is(1)));
}

TEST(NoticeList, LosesNothingBetweenTwoThreads) {
  constexpr int kCount = 20'000;
  NoticeList<int> list;
  std::thread sender([&] {
    for (int i = 0; i < kCount; ++i) list.Send(i);
  });

  int expected = 0;
  bool is_in_order = true;
  while (expected < kCount) {
    list.Take([&](int value) { is_in_order = is_in_order && value == expected++; });
  }
  sender.join();

  EXPECT_TRUE(is_in_order);
}

}  // namespace
}  // namespace tendon
