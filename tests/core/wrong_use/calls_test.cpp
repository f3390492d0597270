#include <gtest/gtest.h>

#include <future>

#include "core/interface/waiting_fixture.h"
#include "core/task/scripted.h"

// Tests of calls at the wrong time, or in the wrong thread.

namespace tendon_test {
namespace {

using tendon::CallerThreads;
using tendon::ComponentState;
using tendon::Connection;
using tendon::LocalManager;
using tendon::Status;

/// One function of each kind.
struct Functions {
  tendon::VoidFunction stop;
  tendon::WriteFunction<JointGoal> move_to;
  tendon::WriteFunction<Message> say;
  tendon::ReadFunction<JointGoal> get_joints;
  tendon::QualifiedReadFunction<std::int32_t, double> get_joint;
  tendon::VoidReturnFunction<std::int32_t> count;
  tendon::WriteReturnFunction<std::string, Message> describe;

  /// Expects that each call returns `expected` and changes nothing.
  void Expect(Status expected) {
    JointGoal goal;
    goal.position[0] = 7.0;
    double position = 7.0;
    std::int32_t number = 7;
    Message message{"seven", {7.0}};
    EXPECT_EQ(stop(), expected);
    EXPECT_EQ(stop.Wait(60s), expected);
    EXPECT_EQ(move_to(goal), expected);
    EXPECT_EQ(move_to.Wait(goal, 60s), expected);
    EXPECT_EQ(say(message), expected);
    EXPECT_EQ(get_joints(goal), expected);
    EXPECT_EQ(get_joint(0, position), expected);
    EXPECT_EQ(count.Wait(number, 60s), expected);
    EXPECT_EQ(describe.Wait("", message, 60s), expected);
    EXPECT_EQ(goal.position[0], 7.0);
    EXPECT_EQ(position, 7.0);
    EXPECT_EQ(number, 7);
    EXPECT_EQ(message.text, "seven");
    EXPECT_FALSE(stop.is_connected());
  }
};

TEST(UnconnectedFunction, ReturnsNotConnected) {
  Functions belonging_nowhere;
  for (const CallerThreads callers : {CallerThreads::kOneThread, CallerThreads::kManyThreads}) {
    tendon::RequiredInterface robot("Robot", nullptr);
    robot.SetCallers(callers);
    Functions functions;
    robot.AddFunction(functions.stop, "Stop");
    robot.AddFunction(functions.move_to, "MoveTo");
    robot.AddFunction(functions.say, "Say");
    robot.AddFunction(functions.get_joints, "GetJoints");
    robot.AddFunction(functions.get_joint, "GetJoint");
    robot.AddFunction(functions.count, "Count");
    robot.AddFunction(functions.describe, "Describe");

    functions.Expect(Status::kNotConnected);
  }

  belonging_nowhere.Expect(Status::kNotConnected);
}

/// A task that calls its own commands in its cycle.
class Selfish final : public tendon::CallbackTask {
 public:
  explicit Selfish(std::string name) : CallbackTask(std::move(name)) {
    auto& control = AddProvidedInterface("Control");
    control.AddCommandVoid(&Selfish::Stop, this, "Stop");
    control.AddCommandWrite(&Selfish::Move, this, "Move");
    auto& self = AddRequiredInterface("Self");
    self.AddFunction(stop_, "Stop");
    self.AddFunction(move_, "Move");
  }
  int stops = 0;
  std::vector<Status> answers;

 private:
  void Run() override {
    answers = {stop_.Wait(60s), move_.Wait(1, 60s), stop_()};
    ProcessQueuedCommands();
  }
  void Stop() { ++stops; }
  void Move(std::int32_t /*goal*/) {}

  tendon::VoidFunction stop_;
  tendon::WriteFunction<std::int32_t> move_;
};

TEST(WaitForOwnThread, IsRefusedForTheTasksOwnCommand) {
  LocalManager manager;
  auto& task = manager.Add<Selfish>("arm");
  ASSERT_TRUE(manager.Connect({"arm", "Self"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());

  ASSERT_TRUE(task.Cycle());

  EXPECT_EQ(task.answers,
            (std::vector<Status>{Status::kWouldDeadlock, Status::kWouldDeadlock, Status::kQueued}));
  EXPECT_EQ(task.stops, 1);
  EXPECT_EQ(ToString(Status(Status::kWouldDeadlock)), "would deadlock");
}

TEST(WaitForOwnThread, IsRefusedInASelfConnectionThatWouldDeadlock) {
  class Oracle final : public tendon::CallbackTask {
   public:
    explicit Oracle(std::string name) : CallbackTask(std::move(name)) {
      AddProvidedInterface("Answers").AddCommandVoidReturn(&Oracle::Answer, this, "Answer");
      AddRequiredInterface("Oracle").AddFunction(ask_, "Answer");
    }

   private:
    void Run() override {}
    void Answer(std::int32_t& answer) { answer = 42; }
    tendon::VoidReturnFunction<std::int32_t> ask_;
  };
  LocalManager manager;
  manager.Add<Oracle>("arm");

  const auto connected = manager.Connect({"arm", "Oracle"}, {"arm", "Answers"});

  ASSERT_FALSE(connected.ok());
  EXPECT_EQ(connected.error().message,
            "arm/Oracle would wait for its own thread: void-return command 'Answer' of arm/Answers "
            "is executed by the task that calls it; call the method directly");
}

TEST(ReadBeforeFirstRow, ReturnsNoSample) {
  Arm arm;
  Teleoperation client;
  const auto connection = Connect(client, arm);
  JointGoal joints;
  joints.position.fill(7.0);
  const JointGoal before = joints;
  double position = 7.0;

  EXPECT_EQ(client.get_joints(joints), Status::kNoSample);
  EXPECT_EQ(client.get_joint(0, position), Status::kNoSample);

  EXPECT_EQ(joints, before);
  EXPECT_EQ(position, 7.0);
  arm.Advance();
  EXPECT_EQ(client.get_joints(joints), Status::kDone);
  EXPECT_EQ(joints, JointGoal{});
}

/// A waiting call of `poke` in another thread. The server does not return from the call yet.
template <typename Kind>
struct CallInFlight {
  std::unique_ptr<LocalManager> manager = std::make_unique<LocalManager>();
  Kind& server;
  Client& client;
  std::future<Status> call;

  template <typename... Arguments>
  explicit CallInFlight(Arguments... arguments)
      : server(manager->Add<Kind>("server", arguments...)), client(manager->Add<Client>("client")) {
    EXPECT_TRUE(manager->Connect({"client", "Server"}, {"server", "Control"}).ok());
    EXPECT_TRUE(manager->StartAll().ok());
    server.blocks = Script::kHandler;
    call = std::async(std::launch::async, [this] { return client.poke.Wait(60s); });
    EXPECT_TRUE(EventuallyTrue([this] { return server.is_blocked.load(); }));
  }
  /// Lets the server return from the call when the connection is being closed.
  std::jthread ReleaseLater() {
    return std::jthread([this] {
      while (client.poke() != Status::kNotConnected) std::this_thread::yield();
      server.blocks = Script::kNone;
    });
  }
};

template <typename Kind, typename... Arguments>
void ExpectRemovedInFlight(Arguments... arguments) {
  CallInFlight<Kind> both(arguments...);
  std::jthread release = both.ReleaseLater();

  const auto removed = both.manager->Remove("server");

  release.join();
  EXPECT_TRUE(removed.ok()) << removed.error().message;
  const Status ended = both.call.get();
  EXPECT_TRUE(ended == Status::kDone || ended == Status::kNotConnected ||
              ended == Status::kOutcomeUnknown)
      << ToString(ended);
  EXPECT_EQ(both.manager->Find("server"), nullptr);
  EXPECT_EQ(both.client.poke(), Status::kNotConnected);
}

TEST(EndDuringCall, RemovingAServerEndsItsRunningCallFirst) {
  ExpectRemovedInFlight<Periodic>(1ms);
  ExpectRemovedInFlight<Continuous>();
  ExpectRemovedInFlight<Signal>();
}

TEST(EndDuringCall, AClientIsNotDestroyedBeforeItsCallHasEnded) {
  for (int i = 0; i < 10; ++i) {
    CallInFlight<Signal> both;
    std::jthread release = both.ReleaseLater();

    const auto disconnected = both.manager->Disconnect({"client", "Server"});

    release.join();
    EXPECT_TRUE(disconnected.ok()) << disconnected.error().message;
    const Status ended = both.call.get();
    EXPECT_TRUE(ended == Status::kDone || ended == Status::kNotConnected ||
                ended == Status::kOutcomeUnknown)
        << ToString(ended);
    EXPECT_TRUE(both.manager->Remove("client").ok());
  }
}

TEST(EndDuringCall, DestroyingAManagerEndsRunningCalls) {
  /// A task that makes the call in every cycle.
  class Busy final : public tendon::ContinuousTask {
   public:
    explicit Busy(std::string name) : ContinuousTask(std::move(name)) {
      AddRequiredInterface("Server").AddFunction(poke_, "Poke");
    }
    ~Busy() override { Join(); }
    std::atomic<int> calls = 0;

   private:
    void Run() override {
      ++calls;
      (void)poke_.Wait(10ms);
    }
    tendon::VoidFunction poke_;
  };
  for (int i = 0; i < 5; ++i) {
    auto manager = std::make_unique<LocalManager>();
    auto& server = manager->Add<Periodic>("server", 100us);
    auto& client = manager->Add<Busy>("client");
    ASSERT_TRUE(manager->Connect({"client", "Server"}, {"server", "Control"}).ok());
    ASSERT_TRUE(manager->StartAll().ok());
    ASSERT_TRUE(EventuallyTrue([&] { return client.calls > 3 && server.pokes > 3; }));

    manager.reset();
  }
}

/// A handler that throws. It handles a queued or a direct event.
class Listener final : public tendon::SignalTask {
 public:
  explicit Listener(std::string name, bool is_direct) : SignalTask(std::move(name)) {
    auto& source = AddRequiredInterface("Source");
    if (is_direct) {
      source.AddEventHandlerVoid(&Listener::OnPoked, this, "Poked", tendon::kThreadSafe);
    } else {
      source.AddEventHandlerVoid(&Listener::OnPoked, this, "Poked");
    }
  }

 private:
  void Run() override { ProcessQueuedCommands(); }
  void OnPoked() { throw std::runtime_error("not expected"); }
};

TEST(ThrowingEventHandler, FaultsItsComponent) {
  for (const bool is_direct : {false, true}) {
    LocalManager manager;
    auto& source = manager.Add<Periodic>("source", 1ms);
    auto& listener = manager.Add<Listener>("listener", is_direct);
    auto& client = manager.Add<Client>("client");
    ASSERT_TRUE(manager.Connect({"listener", "Source"}, {"source", "Control"}).ok());
    ASSERT_TRUE(manager.Connect({"client", "Server"}, {"source", "Control"}).ok());
    ASSERT_TRUE(manager.StartAll().ok());

    EXPECT_EQ(client.poke(), Status::kQueued);

    ASSERT_TRUE(EventuallyTrue([&] { return listener.state() == ComponentState::kFaulted; }));
    EXPECT_EQ(listener.fault(), "a command or event handler: not expected");
    EXPECT_EQ(source.state(), ComponentState::kActive);
    EXPECT_EQ(client.poke(), Status::kQueued);
    EXPECT_TRUE(EventuallyTrue([&] { return source.pokes == 2; }));
  }
}

/// A task whose functions are called in another thread.
class Invaded final : public tendon::CallbackTask {
 public:
  explicit Invaded(std::string name) : CallbackTask(std::move(name)) {
    AddRequiredInterface("Server").AddFunction(poke, "Poke");
    AddProvidedInterface("Control").AddEvent(poked, "Poked");
  }
  tendon::VoidFunction poke;
  tendon::VoidEvent poked;
  std::atomic<bool> in_cycle = false;
  std::atomic<bool> may_end = false;

 private:
  void Run() override {
    in_cycle = true;
    while (!may_end) std::this_thread::yield();
  }
};

void CallFromAnotherThread(bool raises) {
  LocalManager manager;
  auto& task = manager.Add<Invaded>("arm");
  manager.Add<Signal>("server");
  (void)manager.Connect({"arm", "Server"}, {"server", "Control"});
  (void)manager.StartAll();
  std::jthread cycle([&task] { task.Cycle(); });
  while (!task.in_cycle) std::this_thread::yield();
  if (raises) {
    task.poked();
  } else {
    (void)task.poke();
  }
  task.may_end = true;
}

TEST(SecondProducerDeathTest, AbortsADebugBuild) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const char* const sentence = "a task's functions and events belong to its own thread";

  EXPECT_DEBUG_DEATH(CallFromAnotherThread(false), sentence);
  EXPECT_DEBUG_DEATH(CallFromAnotherThread(true), sentence);
}

}  // namespace
}  // namespace tendon_test
