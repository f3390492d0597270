#include <gtest/gtest.h>
#include <tendon/proxy/handle_table.h>

namespace {

using Table = tendon::HandleTable<int>;

TEST(HandleTable, FindsAnObjectAndItsMembersByHandle) {
  Table table;
  const auto first = table.Reserve(2);
  const auto second = table.Reserve(0);
  table.Put(first, std::make_shared<int>(1));
  table.Put(second, std::make_shared<int>(2));

  EXPECT_EQ(*table.Find(first).object, 1);
  EXPECT_EQ(table.Find(first).offset, 0U);
  EXPECT_EQ(*table.Find(first + 2).object, 1);
  EXPECT_EQ(table.Find(first + 2).offset, 2U);
  EXPECT_EQ(*table.Find(second).object, 2);
}

TEST(HandleTable, RefusesHandlesThatItHasNotIssued) {
  Table table;
  EXPECT_EQ(table.Find(0).object, nullptr);
  EXPECT_EQ(table.Find(1).object, nullptr);
  const auto handle = table.Reserve(3);
  table.Put(handle, std::make_shared<int>(1));

  EXPECT_EQ(table.Find(0).object, nullptr);
  EXPECT_EQ(table.Find(handle + 4).object, nullptr);
  EXPECT_EQ(table.Find(0xffffffffU).object, nullptr);
}

TEST(HandleTable, NeverIssuesAHandleTwice) {
  Table table;
  const auto first = table.Reserve(3);
  table.Put(first, std::make_shared<int>(1));
  table.Remove(first);

  const auto second = table.Reserve(3);

  EXPECT_GT(second, first + 3);
  EXPECT_EQ(table.Find(first).object, nullptr);
  EXPECT_EQ(table.Find(first + 1).object, nullptr);
}

TEST(HandleTable, DropsAnObjectWithARemovedHandle) {
  Table table;
  const auto handle = table.Reserve(0);
  table.Remove(handle);

  table.Put(handle, std::make_shared<int>(1));

  EXPECT_EQ(table.Find(handle).object, nullptr);
  EXPECT_TRUE(table.objects().empty());
}

}  // namespace
