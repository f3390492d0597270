#include "core/proxy/interface_proxies.h"
#include "support/wait.h"

namespace tendon {
namespace {

/// Raises events that cannot be sent. Four events wait, because the network thread does not serve
/// the proxy.
class LostEvents : public InterfaceProxies {
 protected:
  void LoseThere(int events) {
    thread->Remove(*server_end->proxy);
    for (int i = 0; i < 4 + events; ++i) pushed(i);
    thread->Add(*server_end->proxy);
    EXPECT_TRUE(EventuallyTrue([&] { return client_inbox.size() == 4; }));
  }
};

TEST_F(LostEvents, AtTheSourceAreCountedAtBothEnds) {
  LoseThere(3);

  EXPECT_EQ(pushed.lost(), 3U);
  EXPECT_EQ(server_end->proxy->lost_events(), 3U);
  EXPECT_TRUE(EventuallyTrue([&] { return required.lost_events() == 3; }));
  EXPECT_EQ(client_connection->lost_events(), 3U);
  client_inbox.ExecuteQueued();
  EXPECT_EQ(heard, (std::vector{0, 1, 2, 3}));
}

TEST_F(LostEvents, AreCountedInAnyNumber) {
  LoseThere(100'000);

  EXPECT_TRUE(EventuallyTrue([&] { return required.lost_events() == 100'000; }));
  EXPECT_EQ(server_end->proxy->lost_events(), 100'000U);
}

TEST_F(LostEvents, OnArrivalAreCountedAtBothEnds) {
  LoseThere(0);
  for (int i = 0; i < 3; ++i) {  // separately, so that each event is sent
    pushed(i);
    EXPECT_TRUE(EventuallyTrue([&] { return required.lost_events() == 1U + i; }));
  }

  EXPECT_TRUE(EventuallyTrue([&] { return server_end->proxy->lost_events() == 3; }));
  EXPECT_EQ(pushed.lost(), 0U) << "they were sent";
}

TEST_F(LostEvents, OfBothKindsAddUp) {
  LoseThere(5);
  ASSERT_TRUE(EventuallyTrue([&] { return required.lost_events() == 5; }));
  pushed(0);
  ASSERT_TRUE(EventuallyTrue([&] { return required.lost_events() == 6; }));
  client_inbox.ExecuteQueued();
  LoseThere(2);

  EXPECT_TRUE(EventuallyTrue([&] { return required.lost_events() == 8; }));
  EXPECT_TRUE(EventuallyTrue([&] { return server_end->proxy->lost_events() == 8; }));
}

TEST_F(LostEvents, AreZeroIfAllArrive) {
  for (int i = 0; i < 20; ++i) {
    pushed(i);
    ASSERT_TRUE(EventuallyTrue([&] { return client_inbox.ExecuteQueued() == 1; }));
  }

  EXPECT_EQ(required.lost_events(), 0U);
  EXPECT_EQ(server_end->proxy->lost_events(), 0U);
}

TEST_F(LostEvents, IgnoreImplausibleCounts) {
  client_end->proxy->OnEventsLost({.lost = {~std::uint64_t{0}, 5, 7}});
  const std::uint64_t lost = required.lost_events();
  client_end->proxy->OnEventsLost({.lost = {}});
  client_end->proxy->OnEventsLost({.lost = {1}});

  EXPECT_GT(lost, 0U);
  EXPECT_EQ(required.lost_events(), lost);
}

}  // namespace
}  // namespace tendon
