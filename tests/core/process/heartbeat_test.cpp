#include <tendon/process/heartbeat.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>

#include "core/process/telemetry/recording_handler.h"
#include "core/process/telemetry/viewing.h"
#include "support/plant.h"
#include "support/wait.h"

namespace {

using tendon::Channel;
using tendon::ViewerMonitor;
namespace message = tendon::message;

/// The channel of a viewer to a process. The process monitors the channel.
struct Watched {
  explicit Watched(const std::shared_ptr<tendon::Worker>& worker)
      : watch(std::make_shared<ViewerMonitor>(worker)) {
    watch->Begin(ends.channel);
  }
  [[nodiscard]] bool is_closed() const { return ends.viewing->is_closed(); }

  ProcessAndViewer ends;
  std::shared_ptr<ViewerMonitor> watch;
};

TEST(ViewerMonitor, ClosesOnlyPeersThatPingedAndFellSilent) {
  const auto worker = std::make_shared<tendon::Worker>("watch");
  const Watched other(worker);  // a channel of another kind, which never sends pings
  Watched silent(worker);

  silent.watch->OnPing();
  EXPECT_TRUE(EventuallyTrue([&] { return silent.is_closed(); }));

  EXPECT_FALSE(other.is_closed());
  worker->Stop();
}

/// A process with a plant, and a viewer that may become silent.
class SilentViewer : public ViewingTest {};

TEST_P(SilentViewer, IsDisconnectedDespiteASubscription) {
  const auto robot = Start("robot");
  robot->Add<plant::Plant>("plant");
  const auto middleware = NewMiddleware();
  const auto cookie = tendon::LoopbackCookie();
  ASSERT_TRUE(cookie.ok());
  constexpr std::chrono::seconds kLong(120);
  const auto channel =
      Channel::Open(*middleware, robot->address(),
                    {.instance = tendon::os::RandomNumber(), .name = "desk", .cookie = *cookie},
                    std::make_shared<tendon::ChannelHandler>(), kLong);
  ASSERT_TRUE(channel.ok()) << channel.error().message;
  ASSERT_TRUE((*channel)->Call(message::kPing, 0, tendon::Bytes(), kLong).ok());

  const message::Subscribe wanted{
      .component = "plant", .table = "state", .columns = {"Move"}, .rows = {}};
  const auto subscribed =
      (*channel)->Call<message::SubscribeReply>(message::kSubscribe, 0, wanted, kLong);

  ASSERT_TRUE(subscribed.ok()) << subscribed.error().message;
  EXPECT_TRUE(EventuallyTrue([&] { return !(*channel)->is_open(); }));
}

INSTANTIATE_TEST_SUITE_P(Over, SilentViewer, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
