#include <gtest/gtest.h>
#include <tendon/base/os/process.h>
#include <tendon/interface/observed_call.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/channel_handler.h>
#include <tendon/middleware/hello.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>

#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

#include "support/network_test.h"

namespace tendon {
namespace {

constexpr std::chrono::seconds kTestTimeout(120);

MemberDescription Seen() {
  return DescribeMember<std::vector<double>, None>("Seen", CommandKind::kWrite);
}
/// The calls of the command.
MemberDescription Focus() {
  return DescribeCalls(DescribeMember<None, None>("Focus", CommandKind::kVoid));
}

/// Raises an event with a point cloud when the test requests it. Its command does nothing.
class Camera final : public Component {
 public:
  explicit Camera(std::string name) : Component(std::move(name)) {
    auto& camera = AddProvidedInterface("Camera");
    camera.AddEvent(seen, "Seen");
    camera.AddCommandVoid(&Camera::Focus, this, "Focus");
  }
  void Focus() {}
  WriteEvent<std::vector<double>> seen;
};

/// Calls the command of the camera when the test requests it.
class Photographer final : public Component {
 public:
  explicit Photographer(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("Camera").AddFunction(focus, "Focus");
  }
  VoidFunction focus;
};

/// Processes nothing while the gate is locked.
struct StuckHandler final : ChannelHandler {
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                std::span<const std::byte> /*body*/) override {
    const std::scoped_lock lock(gate);
  }
  std::mutex gate;
};

/// Process robot with a camera. It receives requests from programs that are not of Tendon.
class HostileListener : public NetworkTest {
 protected:
  void SetUp() override {
    robot = Start("robot");
    camera = &robot->Add<Camera>("camera");
    ASSERT_TRUE(robot->StartAll().ok());
  }

  std::shared_ptr<Channel> Open(std::shared_ptr<ChannelHandler> handler) {
    auto opened = Channel::Open(
        *middleware, robot->address(),
        {.instance = os::RandomNumber(), .name = "viewer", .cookie = *LoopbackCookie()},
        std::move(handler), kTestTimeout);
    EXPECT_TRUE(opened.ok()) << opened.error().message;
    return opened ? *opened : nullptr;
  }
  static Result<message::OpenInterfaceReply> Listen(Channel& channel, std::uint32_t handle,
                                                    std::uint32_t capacity,
                                                    const MemberDescription& member = Seen()) {
    const message::OpenInterface open{.required = {"viewer", "events", "Camera"},
                                      .provided = {"robot", "camera", "Camera"},
                                      .description = {.name = "Camera", .event_handlers = {member}},
                                      .handle = handle,
                                      .capacity = capacity};
    return channel.Call<message::OpenInterfaceReply>(message::kListen, 0, open, kTestTimeout);
  }

  std::shared_ptr<Middleware> middleware = NewMiddleware();
  std::unique_ptr<Process> robot;
  Camera* camera = nullptr;
};

TEST_P(HostileListener, AStoppedReaderHoldsABoundedShareOfLargeEvents) {
  constexpr std::uint32_t kMaxCapacity = 65536;
  constexpr std::size_t kMebibyte = std::size_t{1} << 20U;
  // MiB that may wait for a slow receiver, plus the content of a link.
  constexpr int kShare = 8 + 32;
  const auto stuck = std::make_shared<StuckHandler>();
  const auto channel = Open(stuck);
  ASSERT_TRUE(Listen(*channel, 1, kMaxCapacity).ok());
  std::unique_lock closed(stuck->gate);

  const std::vector<double> cloud(kMebibyte / sizeof(double));
  int raised = 0;
  for (; raised < 4 * kShare && camera->seen.lost() == 0; ++raised) camera->seen(cloud);

  EXPECT_LE(raised, kShare) << "none was lost of so many MiB";
  closed.unlock();
  EXPECT_TRUE(EventuallyTrue([&] {
    const auto lost = camera->seen.lost();
    camera->seen(cloud);
    return camera->seen.lost() == lost;
  })) << "who reads again is sent events again";
  channel->Close();
}

TEST_P(HostileListener, ListeningUpToTheLimitLeavesRoomForOthers) {
  const auto greedy = Open(std::make_shared<ChannelHandler>());
  std::uint32_t listeners = 0;
  Result<message::OpenInterfaceReply> listened = Listen(*greedy, ++listeners, 1);
  while (listened && listeners < 1000) listened = Listen(*greedy, ++listeners, 1);

  ASSERT_FALSE(listened.ok());
  EXPECT_EQ(listened.error().message,
            "process 'robot' has 128 listeners to its events and commands from this client "
            "already, which "
            "is the limit: end some of these listeners");
  const auto modest = Open(std::make_shared<ChannelHandler>());
  EXPECT_TRUE(Listen(*modest, 1, 1).ok());
  greedy->Close();
  modest->Close();
}

TEST_P(HostileListener, AMailboxForCallsIsBounded) {
  const auto channel = Open(std::make_shared<ChannelHandler>());

  EXPECT_TRUE(Listen(*channel, 1, 16384, Focus()).ok());
  const auto refused = Listen(*channel, 3, 65536, Focus());

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().message,
            "viewer/events/Camera requests a mailbox for 65536 calls at robot/camera/Camera, but a "
            "client in another process is allowed at most 65536 calls and 8 MiB: set a smaller "
            "mailbox capacity");
  channel->Close();
}

TEST_P(HostileListener, ListeningAndLeavingAgainAndAgainDisturbsNoCall) {
  auto& photographer = robot->Add<Photographer>("photographer");
  ASSERT_TRUE(robot->Connect({"photographer", "Camera"}, {"camera", "Camera"}).ok());
  const auto channel = Open(std::make_shared<ChannelHandler>());
  const std::jthread caller([&photographer](const std::stop_token& stop) {
    while (!stop.stop_requested()) EXPECT_TRUE(photographer.focus());
  });

  for (std::uint32_t i = 1; i <= 100; ++i) {
    const auto listened = Listen(*channel, 2 * i, 64, Focus());
    ASSERT_TRUE(listened.ok()) << listened.error().message;
    ASSERT_TRUE(channel->Notify(message::kCloseInterface, listened->handle, Bytes()));
  }

  channel->Close();
}

INSTANTIATE_TEST_SUITE_P(Over, HostileListener, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
}  // namespace tendon
