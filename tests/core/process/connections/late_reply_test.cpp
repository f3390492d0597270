#include <gmock/gmock.h>
#include <tendon/base/os/process.h>
#include <tendon/process/viewer_messages.h>

#include <atomic>
#include <chrono>
#include <future>
#include <utility>

#include "core/process/connections/remote_connection.h"

namespace {

using tendon::ConnectionState;
using tendon::Status;
using tendon::message::CallMember;
using tendon::message::CallMemberReply;
using testing::HasSubstr;

/// A component whose end waits at a gate, while its manager's lock is held.
class Lingering final : public tendon::Component {
 public:
  Lingering(std::string name, std::shared_future<void> gate, std::atomic<bool>& ends)
      : Component(std::move(name)), gate_(std::move(gate)), ends_(ends) {}
  ~Lingering() override {
    ends_ = true;
    gate_.wait();
  }
  Lingering(const Lingering&) = delete;
  Lingering& operator=(const Lingering&) = delete;

 private:
  const std::shared_future<void> gate_;
  std::atomic<bool>& ends_;
};

/// Process robot answers pings at once. It answers requests to connect late, because its worker
/// waits for the end of a component.
class LateReply : public RemoteConnection {
 protected:
  void SetUp() override {
    StartRobot();
    StartDesk();
    auto opened =
        tendon::Channel::Open(*middleware, robot->address(),
                              {.instance = tendon::os::RandomNumber(),
                               .name = "console",
                               .cookie = *tendon::LoopbackCookie()},
                              std::make_shared<tendon::ChannelHandler>(), std::chrono::seconds(20));
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    console = *opened;
    robot->Add<Lingering>("lingering", gate.get_future().share(), ends);
    removed = std::async(std::launch::async, [this] { return robot->Remove("lingering").ok(); });
    ASSERT_TRUE(EventuallyTrue([&] { return ends.load(); }));
  }
  void TearDown() override {
    if (removed.valid()) Release();
    if (console) console->Close();
  }

  /// Calls a member. The first call of a member goes through the worker, after all waiting jobs.
  bool Call(const std::string& member) const {
    return console
        ->Call<CallMemberReply>(tendon::message::kCallMember, 0,
                                CallMember{"plant", "Control", member, {}},
                                std::chrono::seconds(20))
        .ok();
  }
  void Release() {
    gate.set_value();
    EXPECT_TRUE(removed.get());
  }

  std::shared_ptr<tendon::Middleware> middleware = NewMiddleware();
  std::shared_ptr<tendon::Channel> console;
  std::promise<void> gate;
  std::atomic<bool> ends{false};
  std::future<bool> removed;
};

TEST_P(LateReply, ToATimedOutAttemptLeavesNoSecondConnection) {
  ASSERT_TRUE(desk->Connect(kRobot, kControl).ok());
  ASSERT_EQ(desk->connections().front().state, ConnectionState::kPending);
  EXPECT_THAT(Reason(), HasSubstr("no reply from robot"));

  Release();

  ASSERT_TRUE(EventuallyActive(*desk, 1)) << Reason();
  EXPECT_TRUE(EventuallyTrue([&] { return Served() == 1; })) << Served();
  EXPECT_EQ(user->stop(), Status(Status::kQueued));
  EXPECT_TRUE(EventuallyTrue([&] { return plant->stops.size() == 1; }));
}

TEST_P(LateReply, AfterADisconnectLeavesNoConnection) {
  ASSERT_TRUE(desk->Connect(kRobot, kControl).ok());
  ASSERT_TRUE(desk->Disconnect(kRobot).ok());

  Release();
  ASSERT_TRUE(Call("GetMove"));

  EXPECT_TRUE(EventuallyTrue([&] { return Served() == 0; })) << Served();
  EXPECT_TRUE(desk->connections().empty());
}

INSTANTIATE_TEST_SUITE_P(Over, LateReply, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
