#include "core/proxy/interface_proxies.h"
#include "support/wait.h"

namespace tendon {
namespace {

using LatestOnly = InterfaceProxies;

TEST_F(LatestOnly, ACallIsNeverRefusedForLackOfRoom) {
  ASSERT_TRUE(EventuallyTrue([&] {
    while (push(0)) continue;
    return server_inbox.size() == 4 && push(0) == Status(Status::kQueueFull);
  }));

  for (int i = 0; i < 100; ++i) ASSERT_EQ(follow(i), Status(Status::kQueued)) << i;

  EXPECT_EQ(client_connection->replaced(), 99U);
  EXPECT_TRUE(EventuallyTrue([&] {
    server_inbox.ExecuteQueued();
    return !followed.empty();
  }));
  EXPECT_EQ(followed, std::vector{99});
  EXPECT_EQ(numbers.size(), 8U) << "no other is dropped for it";
}

TEST_F(LatestOnly, ACallReplacesTheOneQueuedAtTheServer) {
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(follow(i), Status(Status::kQueued));
    ASSERT_TRUE(EventuallyTrue([&] { return client_connection->waiting() == 0; }));
  }

  EXPECT_TRUE(EventuallyTrue([&] {
    server_inbox.ExecuteQueued();
    return !followed.empty() && followed.back() == 19;
  }));
  EXPECT_LE(server_connection->waiting(), 1U);
  EXPECT_EQ(server_connection->refused(), 0U);
}

TEST_F(LatestOnly, ACallMayBeWaitedFor) {
  auto status =
      std::async(std::launch::async, [this] { return follow.Wait(7, std::chrono::seconds(20)); });
  ASSERT_TRUE(EventuallyTrue([this] { return server_inbox.size() == 1; }));

  server_inbox.ExecuteQueued();

  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(followed, std::vector{7});
}

TEST_F(LatestOnly, ACallIsRefusedOnceTheProxyIsSevered) {
  client_end->proxy->Sever();

  EXPECT_EQ(follow(0), Status(Status::kNotConnected));
}

TEST_F(LatestOnly, AnEventIsNotLostForLackOfRoom) {
  thread->Remove(*server_end->proxy);  // the proxy sends nothing for now
  for (int i = 0; i < 100; ++i) moved(i);
  EXPECT_EQ(moved.lost(), 0U);

  thread->Add(*server_end->proxy);

  EXPECT_TRUE(EventuallyTrue([&] {
    client_inbox.ExecuteQueued();
    return !seen.empty();
  }));
  EXPECT_EQ(seen, std::vector{99});
}

TEST_F(LatestOnly, AppliesOnlyToQueuedCommandsAndEvents) {
  EXPECT_EQ(provided.latest_only(), std::vector<std::string>{"Follow"});
  EXPECT_EQ(required.latest_only(), std::vector<std::string>{"Moved"});
}

}  // namespace
}  // namespace tendon
