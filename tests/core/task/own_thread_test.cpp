#include <gtest/gtest.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/callback_task.h>
#include <tendon/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "support/wait.h"

namespace tendon_test {
namespace {

using namespace std::chrono_literals;
using tendon::Status;

/// A server with a command that returns a result.
class Oracle final : public tendon::PeriodicTask {
 public:
  explicit Oracle(std::string name) : PeriodicTask(std::move(name), 1ms) {
    AddProvidedInterface("Answers").AddCommandVoidReturn(&Oracle::Answer, this, "Answer");
  }
  ~Oracle() override { Join(); }

  void Run() override { ProcessQueuedCommands(); }

 private:
  void Answer(std::int32_t& answer) { answer = 42; }
};

/// A client that makes the call in every cycle.
class Pilgrim final : public tendon::PeriodicTask {
 public:
  explicit Pilgrim(std::string name) : PeriodicTask(std::move(name), 1ms) {
    AddRequiredInterface("Oracle").AddFunction(ask_, "Answer");
  }
  ~Pilgrim() override { Join(); }

  void Run() override {
    std::int32_t answer = 0;
    outcome = ask_.Wait(answer, 20s).code();
    if (answer == 42) ++answers;
  }

  std::atomic<Status::Code> outcome = Status::kNotConnected;
  std::atomic<int> answers = 0;

 private:
  tendon::VoidReturnFunction<std::int32_t> ask_;
};

struct Pilgrimage : testing::Test {
  Pilgrimage() { EXPECT_TRUE(manager.Connect({"pilgrim", "Oracle"}, {"oracle", "Answers"}).ok()); }

  tendon::LocalManager manager;
  Oracle& oracle = manager.Add<Oracle>("oracle");
  Pilgrim& pilgrim = manager.Add<Pilgrim>("pilgrim");
};

using WaitingTask = Pilgrimage;

TEST_F(WaitingTask, IsAnsweredByATaskOfAnotherThread) {
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return pilgrim.answers > 3; }));

  EXPECT_TRUE(manager.Stop("pilgrim").ok());
}

TEST_F(WaitingTask, IsRefusedInTheThreadItWaitsFor) {
  ASSERT_TRUE(manager.RunAfter("pilgrim", "oracle").ok());
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return pilgrim.outcome == Status::kWouldDeadlock; }));

  EXPECT_EQ(pilgrim.answers, 0);
}

TEST(CallbackTask, IsNotBoundToTheThreadThatStartsIt) {
  class Driven final : public tendon::CallbackTask {
   public:
    explicit Driven(std::string name) : CallbackTask(std::move(name)) {
      AddProvidedInterface("Answers").AddCommandVoidReturn(&Driven::Answer, this, "Answer");
    }

   private:
    void Run() override { ProcessQueuedCommands(); }
    void Answer(std::int32_t& answer) { answer = 42; }
  };
  class Asker final : public tendon::Component {
   public:
    explicit Asker(std::string name) : Component(std::move(name)) {
      AddRequiredInterface("Oracle").AddFunction(ask, "Answer");
    }
    tendon::VoidReturnFunction<std::int32_t> ask;
  };
  tendon::LocalManager manager;
  auto& driven = manager.Add<Driven>("driven");
  auto& asker = manager.Add<Asker>("asker");
  ASSERT_TRUE(manager.Connect({"asker", "Oracle"}, {"driven", "Answers"}).ok());
  ASSERT_TRUE(manager.StartAll().ok());
  std::int32_t answer = 0;
  EXPECT_EQ(asker.ask.Wait(answer, 1ms), Status::kTimeout);  // the server has not run a cycle yet

  std::jthread driver([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) driven.Cycle();
  });

  EXPECT_EQ(asker.ask.Wait(answer, 20s), Status::kDone);
  EXPECT_EQ(answer, 42);
}

}  // namespace
}  // namespace tendon_test
