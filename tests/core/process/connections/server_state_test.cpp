#include <tendon/interface/event_waiter.h>
#include <tendon/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <stdexcept>

#include "support/network_test.h"

namespace {

using namespace std::chrono_literals;
using tendon::ComponentState;
using tendon::ConnectionState;
using tendon::Process;
using tendon::Status;

const tendon::InterfaceName kWanted("desk", "user", "Light");
const tendon::InterfaceName kLamp("robot", "lamp", "Light");
const tendon::InterfaceName kFuse("robot", "fuse", "Light");

/// A component without a thread: its commands run in the thread of the caller.
class Lamp final : public tendon::Component {
 public:
  explicit Lamp(std::string name) : Component(std::move(name)) {
    auto& light = AddProvidedInterface("Light");
    light.AddCommandVoid(&Lamp::Switch, this, "Switch");
    light.AddCommandRead(&Lamp::Count, this, "Count", tendon::kThreadSafe);
    light.AddEvent(dark_, "Dark");
  }
  std::atomic<int> switched{0};

 private:
  void Switch() { ++switched; }
  void Count(int& count) const { count = switched; }

  tendon::VoidEvent dark_;
};

/// Faults when it is switched. It can be restarted until no spare fuses are left.
class Fuse final : public tendon::PeriodicTask {
 public:
  explicit Fuse(std::string name) : PeriodicTask(std::move(name), 1ms) {
    auto& light = AddProvidedInterface("Light");
    light.AddCommandVoid(&Fuse::Blow, this, "Switch");
    light.AddCommandRead(&Fuse::Count, this, "Count", tendon::kThreadSafe);
    light.AddEvent(dark_, "Dark");
  }
  ~Fuse() override { Join(); }

  void Configure() override {
    if (is_last) throw std::runtime_error("there is no spare one");
  }
  void Run() override { ProcessQueuedCommands(); }

  std::atomic<bool> is_last = false;

 private:
  void Blow() { throw std::runtime_error("too much current"); }
  void Count(int& count) const { count = 1; }

  tendon::VoidEvent dark_;
};

/// A client of a light that faults on request. It has no thread: the test calls its functions.
class User final : public tendon::Component {
 public:
  explicit User(std::string name) : Component(std::move(name)) {
    auto& light = AddRequiredInterface("Light");
    light.AddFunction(change, "Switch");
    light.AddFunction(count, "Count");
    light.AddEventWaiter(dark, "Dark");
    AddProvidedInterface("Own").AddCommandVoid(&User::GiveUp, this, "GiveUp");
  }

  tendon::VoidFunction change;
  tendon::ReadFunction<int> count;
  tendon::EventWaiter<tendon::None> dark;

 private:
  void GiveUp() { throw std::runtime_error("cannot see a thing"); }
};

class Tormentor final : public tendon::Component {
 public:
  explicit Tormentor(std::string name) : Component(std::move(name)) {
    AddRequiredInterface("User").AddFunction(torment, "GiveUp");
  }
  tendon::VoidFunction torment;
};

/// Process robot with both servers, process desk with a user.
class ServerState : public NetworkTest {
 protected:
  ServerState() {
    lamp = &robot->Add<Lamp>("lamp");
    fuse = &robot->Add<Fuse>("fuse");
    user = &desk->Add<User>("user");
    EXPECT_TRUE(desk->StartAll().ok());
  }
  void Connect(const tendon::InterfaceName& server) {
    const auto id = desk->Connect(kWanted, server);
    ASSERT_TRUE(id.ok()) << id.error().message;
  }
  bool EventuallySays(const std::string& reason) {
    return EventuallyTrue([&] {
      const auto all = desk->connections();  // connections to other processes come last
      return !all.empty() && all.back().state == ConnectionState::kPending &&
             all.back().reason == reason;
    });
  }
  /// Waits until the component is faulted. Its clients learn this a moment before it can be
  /// restarted.
  static bool EventuallyFaults(const tendon::Component& component) {
    return EventuallyTrue([&] { return component.state() == ComponentState::kFaulted; });
  }
  static std::string IsFaulted(const std::string& name, const tendon::Component& component) {
    return "component '" + name + "' is faulted: " + component.fault() +
           "; the connection is made again when that component is started";
  }
  bool IsNotActive() { return user->change() == Status(Status::kNotActive); }

  std::unique_ptr<Process> robot = Start("robot");
  std::unique_ptr<Process> desk = Start("desk");
  Lamp* lamp = nullptr;
  Fuse* fuse = nullptr;
  User* user = nullptr;
};

TEST_P(ServerState, AThreadlessServerRefusesCallsWhileStopped) {
  Connect(kLamp);
  ASSERT_TRUE(EventuallyActive(*desk, 1));

  EXPECT_TRUE(IsNotActive());

  ASSERT_TRUE(robot->Start("lamp").ok());
  EXPECT_TRUE(EventuallyTrue([this] { return user->change() == Status(Status::kQueued); }));
  EXPECT_TRUE(EventuallyTrue([this] { return lamp->switched == 1; }));
  ASSERT_TRUE(robot->Stop("lamp").ok());
  EXPECT_TRUE(EventuallyTrue([this] { return IsNotActive(); }));
}

TEST_P(ServerState, AFaultMakesConnectionsPendingUntilARestart) {
  ASSERT_TRUE(robot->StartAll().ok());
  Connect(kFuse);
  ASSERT_TRUE(EventuallyActive(*desk, 1));
  int count = 0;
  ASSERT_TRUE(EventuallyTrue([&] { return bool(user->count(count)); }));

  ASSERT_EQ(user->change(), Status(Status::kQueued));

  ASSERT_TRUE(EventuallyFaults(*fuse));
  EXPECT_TRUE(EventuallySays(IsFaulted("fuse", *fuse)));
  EXPECT_TRUE(EventuallyTrue([this] {
    const auto catalogue = gcm().catalogue();
    const auto* connection = catalogue.FindConnection(kWanted);
    return connection != nullptr && connection->state == ConnectionState::kPending;
  }));
  EXPECT_TRUE(IsNotActive());
  EXPECT_TRUE(EventuallyTrue([&] { return user->count(count) == Status(Status::kNotActive); }));
  EXPECT_EQ(user->dark.Wait(20s), Status(Status::kNotActive));

  ASSERT_TRUE(robot->Start("fuse").ok());
  EXPECT_TRUE(EventuallyActive(*desk, 1));
  EXPECT_TRUE(EventuallyTrue([&] { return bool(user->count(count)); }));
  EXPECT_EQ(user->dark.Wait(1ms), Status(Status::kTimeout));
}

TEST_P(ServerState, ConnectingToAFaultedServerReportsTheFault) {
  ASSERT_TRUE(robot->StartAll().ok());
  Connect(kFuse);
  ASSERT_TRUE(EventuallyActive(*desk, 1));
  ASSERT_EQ(user->change(), Status(Status::kQueued));
  ASSERT_TRUE(EventuallyFaults(*fuse));
  ASSERT_TRUE(desk->Disconnect(kWanted).ok());

  Connect(kFuse);

  EXPECT_TRUE(EventuallySays(IsFaulted("fuse", *fuse)));
  EXPECT_EQ(user->dark.Wait(20s), Status(Status::kNotActive));
}

TEST_P(ServerState, AFailedRestartReportsItsNewReasonToTheGcm) {
  ASSERT_TRUE(robot->StartAll().ok());
  Connect(kFuse);
  ASSERT_TRUE(EventuallyActive(*desk, 1));
  ASSERT_EQ(user->change(), Status(Status::kQueued));
  ASSERT_TRUE(EventuallyFaults(*fuse));
  ASSERT_TRUE(EventuallySays(IsFaulted("fuse", *fuse)));
  fuse->is_last = true;

  ASSERT_FALSE(robot->Start("fuse").ok());

  EXPECT_TRUE(EventuallyTrue([this] {
    const auto catalogue = gcm().catalogue();
    const auto* connection = catalogue.FindConnection(kWanted);
    return connection != nullptr && connection->reason == IsFaulted("fuse", *fuse) &&
           connection->reason.find("there is no spare one") != std::string::npos;
  }));
}

TEST_P(ServerState, AFaultedClientMakesItsConnectionPending) {
  ASSERT_TRUE(robot->StartAll().ok());
  auto& tormentor = desk->Add<Tormentor>("tormentor");
  ASSERT_TRUE(desk->Start("tormentor").ok());
  ASSERT_TRUE(desk->Connect({"tormentor", "User"}, {"user", "Own"}).ok());
  Connect(kLamp);
  ASSERT_TRUE(EventuallyActive(*desk, 2));

  ASSERT_EQ(tormentor.torment(), Status(Status::kFailed));

  EXPECT_TRUE(EventuallySays(IsFaulted("user", *user)));
  ASSERT_TRUE(EventuallyFaults(*user));
  ASSERT_TRUE(desk->Start("user").ok());
  EXPECT_TRUE(EventuallyActive(*desk, 2));
}

INSTANTIATE_TEST_SUITE_P(Over, ServerState, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
