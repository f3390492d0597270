#include <gmock/gmock.h>
#include <tendon/base/os/process.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/task/periodic_task.h>

#include <atomic>
#include <future>
#include <optional>
#include <stdexcept>
#include <thread>

#include "support/network_test.h"

namespace {

using namespace std::chrono_literals;
using tendon::ComponentState;
using tendon::LocalManager;
using tendon::Status;
using tendon::message::CallMemberReply;
using testing::AnyOf;

constexpr auto kLong = 120s;
const tendon::InterfaceName kPress("robot", "press", "Control");
const tendon::InterfaceName kPanel("desk", "panel", "Press");

/// A server with every kind of command for which a caller can wait. It executes commands only while
/// it is not held.
class Press final : public tendon::PeriodicTask {
 public:
  explicit Press(std::string name) : PeriodicTask(std::move(name), 1ms) {
    auto& control = AddProvidedInterface("Control");
    control.AddCommandVoid(&Press::Stamp, this, "Stamp");
    control.AddCommandVoid(&Press::Stick, this, "Stick");
    control.AddCommandVoid(&Press::Break, this, "Break");
    control.AddCommandWrite(&Press::Add, this, "Add");
    control.AddCommandWrite(&Press::Set, this, "Set").SetOverflow(tendon::Overflow::kLatestOnly);
    control.AddCommandFilteredWrite<double, int>(&Rounded, &Press::Add, this, "AddRounded");
    control.AddCommandVoidReturn(&Press::Total, this, "Total");
    control.AddCommandWriteReturn(&Press::Name, this, "Name");
  }
  ~Press() override { Join(); }

  void Run() override {
    if (!held) ProcessQueuedCommands();
    ++cycles;
  }

  /// Makes all later calls wait.
  void Hold() {
    held = true;
    const int before = cycles;  // the running cycle may not have seen `held`
    EXPECT_TRUE(EventuallyTrue([&] { return cycles != before; }));
  }

  [[nodiscard]] std::size_t waiting() const { return inbox()->size(); }

  std::atomic<bool> held{false};
  std::atomic<bool> stuck{false};
  std::atomic<int> cycles{0};
  std::atomic<int> stamps{0};
  std::atomic<int> sticks{0};
  std::atomic<int> total{0};

 private:
  static void Rounded(const double& in, int& out) {
    if (in < 0) throw std::invalid_argument("negative");
    out = static_cast<int>(in + 0.5);
  }
  void Stamp() { ++stamps; }
  void Stick() {
    ++sticks;
    while (stuck) std::this_thread::yield();
  }
  void Break() { throw std::runtime_error("the press is broken"); }
  void Add(int count) { total += count; }
  void Set(int count) { total = count; }
  void Total(int& out) { out = total; }
  void Name(const int& number, std::string& name) { name = "part " + std::to_string(number); }
};

/// A component without a thread: the tests call its functions in any thread.
class Panel final : public tendon::Component {
 public:
  explicit Panel(std::string name) : Component(std::move(name)) {
    auto& press = AddRequiredInterface("Press");
    press.AddFunction(stamp, "Stamp");
    press.AddFunction(stick, "Stick");
    press.AddFunction(fail, "Break");
    press.AddFunction(add, "Add");
    press.AddFunction(set, "Set");
    press.AddFunction(add_rounded, "AddRounded");
    press.AddFunction(total, "Total");
    press.AddFunction(part, "Name");
    press.SetMailboxCapacity(8);
  }

  tendon::VoidFunction stamp;
  tendon::VoidFunction stick;
  tendon::VoidFunction fail;
  tendon::WriteFunction<int> add;
  tendon::WriteFunction<int> set;
  tendon::WriteFunction<double> add_rounded;
  tendon::VoidReturnFunction<int> total;
  tendon::WriteReturnFunction<int, std::string> part;
};

/// A press and a panel that are connected over a network.
class RemoteWait : public NetworkTest {
 protected:
  RemoteWait() {
    press = &robot->Add<Press>("press");
    panel = &desk->Add<Panel>("panel");
    EXPECT_TRUE(robot->StartAll().ok());
    EXPECT_TRUE(desk->StartAll().ok());
    const auto id = desk->Connect(kPanel, kPress);
    EXPECT_TRUE(id.ok()) << id.error().message;
    EXPECT_TRUE(EventuallyActive(*desk, 1)) << desk->connections().front().reason;
  }
  ~RemoteWait() override {
    if (robot) Release();
  }

  void Release() {
    press->held = false;
    press->stuck = false;
  }
  /// Starts a call that waits while the press is held.
  std::future<Status> WaitForStamp() {
    press->Hold();
    auto status = std::async(std::launch::async, [this] { return panel->stamp.Wait(kLong); });
    EXPECT_TRUE(EventuallyTrue([this] { return press->waiting() == 1; }));
    return status;
  }

  std::unique_ptr<tendon::Process> robot = Start("robot");
  std::unique_ptr<tendon::Process> desk = Start("desk");
  Press* press = nullptr;
  Panel* panel = nullptr;
};

INSTANTIATE_TEST_SUITE_P(Over, RemoteWait, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

/// Checks that must give the same results in one process and in two.
void UseEveryKind(Press& press, Panel& panel) {
  EXPECT_EQ(panel.stamp.Wait(kLong), Status(Status::kDone));
  EXPECT_EQ(press.stamps, 1);
  EXPECT_EQ(panel.add.Wait(5, kLong), Status(Status::kDone));
  EXPECT_EQ(press.total, 5);
  EXPECT_EQ(panel.add_rounded.Wait(1.7, kLong), Status(Status::kDone));
  EXPECT_EQ(press.total, 7);
  EXPECT_EQ(panel.add_rounded.Wait(-1, kLong), Status(Status::kFailed));
  EXPECT_EQ(panel.set.Wait(40, kLong), Status(Status::kDone));
  EXPECT_EQ(press.total, 40);
  EXPECT_EQ(panel.add_rounded(1.6), Status(Status::kQueued));
  int total = 0;
  EXPECT_EQ(panel.total.Wait(total, kLong), Status(Status::kDone));
  EXPECT_EQ(total, 42);
  std::string name;
  EXPECT_EQ(panel.part.Wait(3, name, kLong), Status(Status::kDone));
  EXPECT_EQ(name, "part 3");
}

TEST(Wait, OfEveryKindWorksInOneProcess) {
  LocalManager manager;
  auto& press = manager.Add<Press>("press");
  auto& panel = manager.Add<Panel>("panel");
  ASSERT_TRUE(manager.Connect({"panel", "Press"}, {"press", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());

  UseEveryKind(press, panel);
}

TEST_P(RemoteWait, OfEveryKindWorksAsInOneProcess) { UseEveryKind(*press, *panel); }

TEST_P(RemoteWait, CompletesAfterEarlierCalls) {
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(EventuallyTrue([&] { return panel->add(1) == Status(Status::kQueued); }));
    if (i % 5 != 4) continue;
    int total = 0;
    ASSERT_EQ(panel->total.Wait(total, kLong), Status(Status::kDone));
    EXPECT_EQ(total, i + 1);
  }
}

TEST_P(RemoteWait, GivesEachOfManyCallersItsOwnAnswer) {
  constexpr int kThreads = 4;
  constexpr int kCalls = 50;
  std::atomic<int> wrong{0};
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < kThreads; ++thread) {
    threads.emplace_back([&, thread] {
      for (int i = 0; i < kCalls; ++i) {
        std::string name;
        const int number = 1000 * thread + i;
        const Status status = panel->part.Wait(number, name, kLong);
        if (!status || name != "part " + std::to_string(number)) ++wrong;
        if (!panel->add.Wait(1, kLong)) ++wrong;
      }
    });
  }
  threads.clear();

  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(press->total, kThreads * kCalls);
}

TEST_P(RemoteWait, TimesOutWithoutExecutingAnUnstartedCall) {
  press->Hold();

  const Status status = panel->stamp.Wait(300ms);

  // On a machine that stalls, the message of the other end may arrive too late.
  EXPECT_THAT(status.code(), AnyOf(Status::kTimeout, Status::kOutcomeUnknown));
  if (status == Status(Status::kTimeout)) {
    press->held = false;
    ASSERT_EQ(panel->add.Wait(1, kLong), Status(Status::kDone));
    EXPECT_EQ(press->stamps, 0);
  }
}

TEST_P(RemoteWait, AStartedCallTimesOutWithUnknownOutcome) {
  press->stuck = true;

  const Status status = panel->stick.Wait(500ms);

  // On a machine that stalls, the command was not started, or the message of the other end arrived
  // too late.
  if (press->sticks == 1) {
    EXPECT_EQ(status, Status(Status::kOutcomeUnknown));
  } else {
    EXPECT_THAT(status.code(), AnyOf(Status::kTimeout, Status::kOutcomeUnknown));
  }
  press->stuck = false;
  for (int i = 0; i < 20; ++i) {
    std::string name;
    ASSERT_EQ(panel->part.Wait(i, name, kLong), Status(Status::kDone));
    EXPECT_EQ(name, "part " + std::to_string(i));
  }
  EXPECT_LE(press->sticks, 1);
}

TEST_P(RemoteWait, IsRefusedByAFullMailbox) {
  press->Hold();
  EXPECT_TRUE(EventuallyTrue([this] { return panel->add(1) == Status(Status::kQueueFull); }));

  EXPECT_EQ(panel->stamp.Wait(kLong), Status(Status::kQueueFull));
}

TEST_P(RemoteWait, EndsWhenTheServerStops) {
  auto status = WaitForStamp();

  ASSERT_TRUE(robot->Stop("press").ok());

  EXPECT_EQ(status.get(), Status(Status::kNotActive));
  EXPECT_EQ(press->stamps, 0);
}

TEST_P(RemoteWait, OfAThrowingCommandFailsAndFaultsTheServer) {
  EXPECT_EQ(panel->fail.Wait(kLong), Status(Status::kFailed));
  EXPECT_TRUE(EventuallyTrue([this] { return press->state() == ComponentState::kFaulted; }));
  EXPECT_EQ(panel->stamp.Wait(kLong), Status(Status::kNotActive));
}

/// Calls commands by their names, like a console.
class RemoteCallByName : public RemoteWait {
 protected:
  RemoteCallByName() {
    const tendon::Hello hello{.instance = tendon::os::RandomNumber(),
                              .name = "console",
                              .cookie = *tendon::LoopbackCookie()};
    auto opened = tendon::Channel::Open(*middleware, robot->address(), hello,
                                        std::make_shared<tendon::ChannelHandler>(), kLong);
    EXPECT_TRUE(opened.ok()) << opened.error().message;
    channel = *opened;
  }
  ~RemoteCallByName() override { channel->Close(); }

  CallMemberReply Call(const std::string& member, tendon::Bytes argument,
                       std::chrono::nanoseconds timeout = kLong) {
    const auto called = channel->Call<CallMemberReply>(
        tendon::message::kCallMember, 0,
        tendon::message::CallMember{"press", "Control", member, std::move(argument), timeout},
        kLong);
    EXPECT_TRUE(called.ok()) << called.error().message;
    return called ? *called : CallMemberReply{};
  }

  std::shared_ptr<tendon::Middleware> middleware = NewMiddleware();
  std::shared_ptr<tendon::Channel> channel;
};

INSTANTIATE_TEST_SUITE_P(Over, RemoteCallByName, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

TEST_P(RemoteCallByName, WaitsForCommandsWithAResult) {
  ASSERT_EQ(panel->add.Wait(4, kLong), Status(Status::kDone));

  const CallMemberReply total = Call("Total", {});
  const CallMemberReply name = Call("Name", tendon::EncodeBody(9));

  EXPECT_EQ(total.status, Status::kDone);
  EXPECT_EQ(total.result, tendon::EncodeBody(4));
  EXPECT_EQ(name.status, Status::kDone);
  EXPECT_EQ(name.result, tendon::EncodeBody(std::string("part 9")));
}

TEST_P(RemoteCallByName, EndsAtItsDeadline) {
  press->Hold();

  const CallMemberReply total = Call("Total", {}, 50ms);

  EXPECT_EQ(total.status, Status::kTimeout);
  EXPECT_TRUE(total.result.empty());
}

TEST_P(RemoteWait, EndsWhenTheServersProcessEnds) {
  auto status = WaitForStamp();

  robot.reset();

  EXPECT_THAT(status.get().code(),
              AnyOf(Status::kNotActive, Status::kNotConnected, Status::kOutcomeUnknown));
  // Until the panel learns that the link is closed, its calls report a stopped server.
  EXPECT_TRUE(EventuallyTrue([this] {
    const Status next = panel->stamp.Wait(kLong);
    EXPECT_NE(next, Status(Status::kDone));
    return next == Status(Status::kNotConnected);
  }));
}

TEST_P(RemoteWait, EndsWithADisconnect) {
  auto status = WaitForStamp();

  ASSERT_TRUE(desk->Disconnect(kPanel).ok());

  EXPECT_EQ(status.get(), Status(Status::kOutcomeUnknown));
  ASSERT_TRUE(desk->Connect(kPanel, kPress).ok());
  ASSERT_TRUE(EventuallyActive(*desk, 1));
  press->held = false;
  EXPECT_EQ(panel->stamp.Wait(kLong), Status(Status::kDone));
  EXPECT_LE(press->stamps, 2);
}

TEST_P(RemoteWait, WorksAfterTheServerIsRemovedAndAddedAgain) {
  auto status = WaitForStamp();

  ASSERT_TRUE(robot->Remove("press").ok());
  EXPECT_THAT(status.get().code(),
              AnyOf(Status::kNotActive, Status::kNotConnected, Status::kOutcomeUnknown));
  press = &robot->Add<Press>("press");
  ASSERT_TRUE(robot->StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([this] { return panel->stamp.Wait(kLong) == Status(Status::kDone); }));
  EXPECT_EQ(press->stamps, 1);
}

}  // namespace
