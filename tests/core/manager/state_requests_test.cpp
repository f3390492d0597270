#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/state_requests.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/task/scripted.h"
#include "support/wait.h"

namespace {

using tendon::ComponentState;
using tendon::ErrorCode;
using tendon::kNoWait;
using tendon_test::Periodic;
using tendon_test::Script;
using testing::HasSubstr;
using namespace std::chrono_literals;

/// A component that is being started, and that blocks in its Configure().
struct BusyComponent : testing::Test {
  void SetUp() override {
    slow.blocks = Script::kConfigure;
    starting = std::thread([this] { started = manager.Start("slow", 20s); });
    ASSERT_TRUE(EventuallyTrue([this] { return slow.is_blocked.load(); }));
  }
  void TearDown() override { Release(); }
  void Release() {
    // The start has ended, and the component may not exist any more.
    if (!starting.joinable()) return;
    slow.blocks = Script::kNone;
    starting.join();
  }

  tendon::LocalManager manager;
  Periodic& arm = manager.Add<Periodic>("arm", 1ms);
  Periodic& slow = manager.Add<Periodic>("slow", 1ms);
  tendon::Result<void> started;  // set after the release
  std::thread starting;
};

TEST_F(BusyComponent, DoesNotBlockOthers) {
  EXPECT_TRUE(manager.Start("arm").ok());
  EXPECT_TRUE(manager.Stop("arm").ok());
  EXPECT_EQ(manager.components().size(), 2U);
  manager.Add<Periodic>("other", 1ms);
  EXPECT_TRUE(manager.Remove("other").ok());
  EXPECT_EQ(slow.state(), ComponentState::kConstructed);
}

TEST_F(BusyComponent, RefusesFurtherRequestsMeanwhile) {
  for (const auto& reply : {manager.Start("slow", kNoWait), manager.Stop("slow", 1ms),
                            manager.Remove("slow", 1ms), manager.RunAfter("slow", "arm", 1ms)}) {
    ASSERT_FALSE(reply.ok());
    EXPECT_EQ(reply.error().code, ErrorCode::kTimeout);
    EXPECT_THAT(reply.error().message, HasSubstr("component 'slow' is still busy with an earlier "
                                                 "request"));
  }
  EXPECT_EQ(slow.configures, 1);

  Release();

  EXPECT_TRUE(started.ok());
  EXPECT_TRUE(manager.Stop("slow").ok());
  EXPECT_TRUE(manager.Remove("slow").ok());
}

TEST_F(BusyComponent, IsStoppedAsSoonAsItBecomesIdle) {
  std::thread stopping([this] { EXPECT_TRUE(manager.Stop("slow", 20s).ok()); });

  Release();
  stopping.join();

  EXPECT_EQ(slow.state(), ComponentState::kFinished);
}

TEST_F(BusyComponent, IsStoppedWithTheOthers) {
  ASSERT_TRUE(manager.Start("arm").ok());
  std::thread stopping([this] { EXPECT_TRUE(manager.StopAll(20s).ok()); });
  Release();
  stopping.join();

  EXPECT_FALSE(IsRunning(arm.state()));
  EXPECT_FALSE(IsRunning(slow.state()));
}

TEST_F(BusyComponent, IsNotStartedIfAStopComesFirst) {
  std::atomic<bool> proceeds = true;
  Release();
  ASSERT_TRUE(manager.Stop("slow").ok());
  Periodic& other = manager.Add<Periodic>("other", 1ms);
  other.blocks = Script::kConfigure;
  starting = std::thread(
      [&] { started = manager.Start("other", 20s, [&proceeds] { return proceeds.load(); }); });
  ASSERT_TRUE(EventuallyTrue([&] { return other.is_blocked.load(); }));

  proceeds = false;
  other.blocks = Script::kNone;
  starting.join();

  EXPECT_EQ(started.error().message,
            "component 'other' is not started, because a stop was requested");
  EXPECT_EQ(other.startups, 0);
  EXPECT_EQ(other.state(), ComponentState::kReady);
}

TEST_F(BusyComponent, KeepsItsLeader) {
  Release();
  ASSERT_TRUE(manager.Stop("slow").ok());
  ASSERT_TRUE(manager.RunAfter("slow", "arm").ok());
  slow.throws = Script::kStartup;  // the component must then be configured again
  ASSERT_TRUE(manager.Start("arm").ok());
  EXPECT_FALSE(manager.Start("slow").ok());
  slow.throws = Script::kNone;
  ASSERT_TRUE(manager.Stop("arm").ok());
  slow.blocks = Script::kConfigure;
  starting = std::thread([this] { (void)manager.Start("slow", 20s); });
  ASSERT_TRUE(EventuallyTrue([this] { return slow.is_blocked.load(); }));

  const auto removed = manager.Remove("arm", 1ms);

  ASSERT_FALSE(removed.ok());
  EXPECT_EQ(removed.error().code, ErrorCode::kTimeout);
  Release();
  EXPECT_TRUE(manager.Remove("arm").ok());
}

TEST(StateRequestsTest, AStopOfARemovedComponentIsRefused) {
  std::recursive_mutex mutex;
  tendon::StateRequests requests(
      {.lock = [&mutex] { return std::unique_lock(mutex); },
       .find = [](const std::string& name) -> tendon::Result<std::shared_ptr<tendon::Component>> {
         return tendon::Error{ErrorCode::kNotFound, "no component '" + name + "'"};
       },
       .order = [] { return tendon::ComponentOrder({}); },
       .has_calls_under_way = [](const tendon::Component&) { return false; }});
  const auto removed = std::make_shared<Periodic>("arm", 1ms);

  const auto stopped = requests.RequestStop(removed, tendon::SteadyClock().Now());

  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::kNotFound);
  EXPECT_EQ(stopped.error().message, "component 'arm' was removed by another request");
}

}  // namespace
