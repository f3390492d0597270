#include <gtest/gtest.h>
#include <tendon/proxy/event_proxy.h>

#include <vector>

namespace tendon {
namespace {

/// A handler that refuses every event, because it has no room.
class Refusing final : public CommandBase {
 public:
  Refusing() : CommandBase(layout::kNone, layout::kNone) {}
  Status ExecuteEncoded(std::span<const std::byte> /*in*/, ReplySink& /*out*/) override {
    return Status::kQueueFull;
  }
};

TEST(EventProxy, CountsLossesOfEachEndSeparately) {
  Refusing handler;
  EventProxy event;
  event.Subscribe(handler);

  event.Raise({});
  event.SetLostThere(5);
  event.Raise({});

  EXPECT_EQ(event.lost(), 7U);
  EXPECT_EQ(event.lost_here(), 2U);
}

TEST(EventProxy, CountsEarlierRemoteLossesForANewHandler) {
  Refusing handler;
  SharedCounter<> lost;
  EventProxy event;

  event.SetLostThere(5);
  event.Subscribe(handler, &lost);
  event.Raise({});

  EXPECT_EQ(lost.value(), 6U);
  EXPECT_EQ(event.lost_here(), 1U);
}

}  // namespace
}  // namespace tendon
