#include <gtest/gtest.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

#include "support/wait.h"

namespace tendon_test {
namespace {

using namespace std::chrono_literals;
using tendon::Status;

/// Answers a question that its clients wait for.
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

/// Asks in every cycle.
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

using TaskThatWaits = Pilgrimage;

TEST_F(TaskThatWaits, IsAnsweredByATaskOfAnotherThread) {
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return pilgrim.answers > 3; }));

  EXPECT_TRUE(manager.Stop("pilgrim").ok());
}

TEST_F(TaskThatWaits, IsRefusedWhereItRunsInTheThreadItWaitsFor) {
  ASSERT_TRUE(manager.RunAfter("pilgrim", "oracle").ok());
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return pilgrim.outcome == Status::kWouldDeadlock; }));

  EXPECT_EQ(pilgrim.answers, 0);
}

}  // namespace
}  // namespace tendon_test
