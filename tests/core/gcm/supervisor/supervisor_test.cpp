#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/base/os/process.h>
#include <tendon/gcm/supervisor/supervisor.h>
#include <tendon/middleware/channel.h>
#include <tendon/payload/json.h>
#include <tests/core/gcm/samples.h>
#include <tests/support/folder.h>
#include <tests/support/wait.h>

#include <atomic>
#include <mutex>

namespace tendon::server {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::HasSubstr;

/// Ends when the test says so. Under the lock of the launcher's user.
class FakeProcessOfGcm final : public StartedProcess {
 public:
  explicit FakeProcessOfGcm(std::int64_t pid) : pid_(pid) {}

  [[nodiscard]] std::int64_t pid() const override { return pid_; }
  std::optional<ProcessEnd> Ended() override { return end; }
  void Terminate() override { terminated = true; }
  void Kill() override { killed = true; }

  std::optional<ProcessEnd> end;
  bool terminated = false;
  bool killed = false;

 private:
  const std::int64_t pid_;
};

class FakeLauncher final : public Launcher {
 public:
  Result<std::shared_ptr<StartedProcess>> Start(const Order& order) override {
    const std::scoped_lock lock(mutex_);
    orders_.push_back(order);
    if (!refusal.empty()) return Error{ErrorCode::kFailed, refusal};
    processes_.push_back(std::make_shared<FakeProcessOfGcm>(orders_.size()));
    return std::shared_ptr<StartedProcess>(processes_.back());
  }
  Traces TracesOf(const std::string& process) override { return {"alas", process + ".log"}; }
  void ShortenLog(const std::string& process) override {
    const std::scoped_lock lock(mutex_);
    shortened_.push_back(process);
  }

  [[nodiscard]] std::size_t starts() const {
    const std::scoped_lock lock(mutex_);
    return orders_.size();
  }
  /// Of the last one.
  [[nodiscard]] Order order() const {
    const std::scoped_lock lock(mutex_);
    return orders_.back();
  }
  [[nodiscard]] std::shared_ptr<FakeProcessOfGcm> process() const {
    const std::scoped_lock lock(mutex_);
    return processes_.back();
  }

  /// Whose log was looked at.
  [[nodiscard]] std::vector<std::string> shortened() const {
    const std::scoped_lock lock(mutex_);
    return shortened_;
  }

  std::string refusal;

 private:
  mutable std::mutex mutex_;
  std::vector<Order> orders_;
  std::vector<std::string> shortened_;
  std::vector<std::shared_ptr<FakeProcessOfGcm>> processes_;
};

/// A GCM's part that starts processes which the test plays.
class SupervisorTest : public testing::Test {
 protected:
  /// What came of an order.
  struct Answer {
    std::atomic<bool> is_here = false;
    std::string text;  ///< "" where it was done
  };
  using SharedAnswer = std::shared_ptr<Answer>;

  template <typename Action>
  void Locked(Action&& action) {
    {
      const std::scoped_lock lock(mutex_);
      action();
    }
    outbox_.Flush();
  }

  SharedAnswer Order(ProcessVerb verb, RestartPolicy restart = RestartPolicy::kOnFailure) {
    const auto answer = std::make_shared<Answer>();
    const message::ProcessOrder order{
        .verb = verb, .process = "robot", .restart = restart, .patience = 5s};
    Locked([&] {
      supervisor_.Obey(order, "test", [answer](const Result<None>& result) {
        answer->text = result ? "" : result.error().message;
        answer->is_here = true;
      });
    });
    return answer;
  }
  void Tick() {
    Locked([this] { supervisor_.Tick(); });
  }
  template <typename Predicate>
  testing::AssertionResult Comes(Predicate predicate) {
    const bool came = EventuallyTrue([&] {
      Tick();
      const std::scoped_lock lock(mutex_);
      return predicate();
    });
    return came ? testing::AssertionSuccess() : testing::AssertionFailure() << Reason();
  }
  testing::AssertionResult IsAnswered(const SharedAnswer& answer) {
    return Comes([&] { return answer->is_here.load(); });
  }
  /// Of one that is answered without a process.
  static std::string TextOf(const SharedAnswer& answer) {
    EXPECT_TRUE(EventuallyTrue([&] { return answer->is_here.load(); }));
    return answer->text;
  }
  /// As the process does once it runs.
  void Join(std::vector<ComponentDescription> components = {}) {
    Locked([&] {
      const auto admission = registry_.Join({{.name = "robot",
                                              .instance = launcher_->starts(),
                                              .host = os::HostName(),
                                              .pid = launcher_->process()->pid()},
                                             std::move(components),
                                             {}},
                                            0, nullptr);
      ASSERT_TRUE(admission) << admission.error().message;
      session_ = admission->session;
    });
  }
  /// Starts it, and lets it join.
  void Run(RestartPolicy restart, std::vector<ComponentDescription> components = {}) {
    const auto answer = Order(ProcessVerb::kStart, restart);
    ASSERT_TRUE(Comes([this] { return launcher_->starts() == 1; }));
    Join(std::move(components));
    ASSERT_TRUE(IsAnswered(answer));
    ASSERT_EQ(answer->text, "");
  }
  void End(const ProcessEnd& end, ProcessState state = ProcessState::kLost) {
    Locked([&] {
      launcher_->process()->end = end;
      registry_.End(session_, state, "its connection broke");
    });
  }
  /// It fails, is started again after the pause, and joins again.
  void FailOnce(std::chrono::milliseconds pause, std::vector<ComponentDescription> components) {
    const std::size_t before = launcher_->starts();
    End(kKilled);
    ASSERT_TRUE(Comes([&] { return ReasonNow().find("started again in") != std::string::npos; }));
    clock_.Advance(pause);
    ASSERT_TRUE(Comes([&] { return launcher_->starts() == before + 1; }));
    Join(std::move(components));
  }
  [[nodiscard]] std::string ReasonNow() const {
    const auto* const entry = registry_.catalog().FindProcess("robot");
    return entry == nullptr ? "" : entry->process.reason;
  }
  [[nodiscard]] std::string Reason() {
    const std::scoped_lock lock(mutex_);
    return ReasonNow();
  }

  static inline const ProcessEnd kKilled{true, "was ended by SIGKILL"};

  const test::Folder folder_;
  ManualClock clock_;
  std::mutex mutex_;
  Registry registry_{Leases{}, clock_};
  History history_{folder_.path() / "history.jsonl"};
  Outbox outbox_;
  Session session_ = 0;
  const std::shared_ptr<FakeLauncher> launcher_ = std::make_shared<FakeLauncher>();
  Supervisor supervisor_{{registry_, history_, outbox_, clock_, launcher_},
                         [this](const std::function<void(Supervisor&)>& action) {
                           Locked([&] { action(supervisor_); });
                         }};
};

TEST_F(SupervisorTest, TheLogOfOneThatRunsIsLookedAtEachSecond) {
  Run(RestartPolicy::kNever);
  const std::size_t before = launcher_->shortened().size();

  clock_.Advance(1s);
  EXPECT_TRUE(Comes([&] { return launcher_->shortened().size() == before + 1; }));
  Tick();
  Tick();
  clock_.Advance(1s);
  EXPECT_TRUE(Comes([&] { return launcher_->shortened().size() == before + 2; }));
  EXPECT_EQ(launcher_->shortened().back(), "robot");
}

TEST_F(SupervisorTest, AStartIsDoneOnceTheProcessHasJoined) {
  const auto answer = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 1; }));
  EXPECT_FALSE(launcher_->order().system);
  EXPECT_EQ(launcher_->order().patience, 5s);
  EXPECT_FALSE(answer->is_here);

  Join();

  EXPECT_TRUE(IsAnswered(answer));
  EXPECT_EQ(answer->text, "");
  ASSERT_EQ(history_.steps().entries.size(), 1U);
  EXPECT_EQ(ToString(history_.steps().entries[0]), "start robot");
  EXPECT_EQ(history_.steps().entries[0].who, "test");
}

TEST_F(SupervisorTest, AnotherProcessOfTheNameIsNotTheOneThatWasStarted) {
  const auto answer = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 1; }));
  Locked([this] {
    ASSERT_TRUE(registry_.Join({test::ProcessNamed("robot", 9), {}, {}}, 0, nullptr));
    launcher_->process()->end = {true, "ended with exit code 1"};
  });

  ASSERT_TRUE(IsAnswered(answer));
  EXPECT_EQ(
      answer->text,
      "process 'robot' ended with exit code 1 before it had joined; it said last: alas; its log: "
      "robot.log");
  EXPECT_THAT(history_.steps().entries, testing::IsEmpty());
}

TEST_F(SupervisorTest, WhatCannotBeStartedIsSaid) {
  launcher_->refusal = "no such program";
  const auto answer = Order(ProcessVerb::kStart);
  ASSERT_TRUE(IsAnswered(answer));
  EXPECT_EQ(answer->text, "no such program");

  Locked([this] {
    launcher_->refusal = "";
    ASSERT_TRUE(registry_.Join({test::ProcessNamed("robot", 9), {}, {}}, 0, nullptr));
  });
  const auto taken = Order(ProcessVerb::kStart);
  EXPECT_THAT(TextOf(taken), testing::StartsWith("process 'robot' is there already: host "));
  const auto alien = Order(ProcessVerb::kKill);
  EXPECT_THAT(TextOf(alien), HasSubstr("was not started by this GCM: end it where it was started"));
}

TEST_F(SupervisorTest, OneThatNeverJoinsIsEndedAgain) {
  const auto answer = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 1; }));
  ASSERT_TRUE(Comes([this] {
    clock_.Advance(1s);
    return launcher_->process()->terminated;
  }));
  EXPECT_FALSE(answer->is_here);
  EXPECT_FALSE(launcher_->process()->killed);
  EXPECT_THAT(TextOf(Order(ProcessVerb::kStart)), HasSubstr("was started already as pid 1"));

  clock_.Advance(2s);
  Tick();
  EXPECT_TRUE(launcher_->process()->killed);
  Locked([this] { launcher_->process()->end = kKilled; });

  ASSERT_TRUE(IsAnswered(answer));
  EXPECT_EQ(answer->text,
            "process 'robot' has not joined within 5000 ms, so it was ended again; it said last: "
            "alas; its log: robot.log");
}

TEST_F(SupervisorTest, OneThatFailsIsStartedAgainWithWhatItHad) {
  Run(RestartPolicy::kOnFailure);
  message::LifeOrder create{.verb = LifeVerb::kCreate, .process = "robot", .component = "arm"};
  ThreadOptions thread;
  thread.lock_memory = true;
  create.thread = ToJson(thread);
  Locked([&] {
    supervisor_.NoteOrder(create);
    ASSERT_TRUE(registry_.Report(
        session_, {{{.kind = CatalogChange::Kind::kComponent, .components = {test::Arm()}}}}));
    create.thread.clear();
    supervisor_.NoteOrder(create);  // which is refused, for it is there
  });

  End(kKilled);

  ASSERT_TRUE(Comes([this] { return ReasonNow().find("SIGKILL") != std::string::npos; }));
  EXPECT_EQ(Reason(), "was ended by SIGKILL; its log: robot.log; it is started again in 500 ms");
  clock_.Advance(499ms);
  Tick();
  EXPECT_EQ(launcher_->starts(), 1U);
  clock_.Advance(1ms);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 2; }));
  const auto system = launcher_->order().system;
  ASSERT_TRUE(system);
  const auto* const arm = system->FindComponent("robot", "arm");
  ASSERT_NE(arm, nullptr);
  EXPECT_EQ(arm->class_name, "SimulatedArm");
  EXPECT_EQ(arm->state, ComponentState::kActive);
  EXPECT_EQ(arm->thread, thread);
}

/// Else one that fails while its components are started would come back without them running, or
/// one that was stopped would run again.
TEST_F(SupervisorTest, WhatItHadIsWhatItWasStartedWithAndWhatWasOrderedSince) {
  ComponentDescription resting = test::Arm();
  resting.state = ComponentState::kConstructed;
  const auto state = [this] {
    return launcher_->order().system->FindComponent("robot", "arm")->state;
  };
  Run(RestartPolicy::kOnFailure, {test::Arm()});
  FailOnce(500ms, {resting});  // it has begun to start it

  FailOnce(1s, {resting});
  EXPECT_EQ(state(), ComponentState::kActive);

  Locked([this] { supervisor_.NoteChange("robot"); });  // somebody has stopped it
  FailOnce(2s, {resting});
  EXPECT_EQ(state(), ComponentState::kConstructed);
}

TEST_F(SupervisorTest, GivesUpWhatFailsAgainAndAgain) {
  Run(RestartPolicy::kOnFailure);
  for (const auto pause : {500ms, 1000ms, 2000ms, 4000ms}) FailOnce(pause, {});

  End(kKilled);

  ASSERT_TRUE(Comes([this] { return ReasonNow().find("not started again") != std::string::npos; }));
  EXPECT_EQ(Reason(),
            "was ended by SIGKILL; its log: robot.log; it is not started again, for it has failed "
            "5 times "
            "within a minute; when it is mended: gcm apply");
  clock_.Advance(1h);
  Tick();
  EXPECT_EQ(launcher_->starts(), 5U);
  (void)Order(ProcessVerb::kStart);
  EXPECT_TRUE(Comes([this] { return launcher_->starts() == 6; }));
}

TEST_F(SupervisorTest, OneThatEndsByItselfOrIsToEndStaysEnded) {
  Run(RestartPolicy::kOnFailure);
  End({false, "ended with exit code 0"}, ProcessState::kLeft);
  ASSERT_TRUE(Comes([this] { return ReasonNow() == "ended with exit code 0 by itself"; }));

  const auto again = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return launcher_->starts() == 2; }));
  Join();
  ASSERT_TRUE(IsAnswered(again));
  const auto killed = Order(ProcessVerb::kKill);
  EXPECT_TRUE(launcher_->process()->terminated);
  EXPECT_EQ(TextOf(Order(ProcessVerb::kKill)), "process 'robot' is being ended already");
  clock_.Advance(5s);
  Tick();
  EXPECT_TRUE(launcher_->process()->killed);
  End(kKilled);
  ASSERT_TRUE(IsAnswered(killed));
  EXPECT_EQ(killed->text, "");

  clock_.Advance(1h);
  Tick();
  EXPECT_EQ(launcher_->starts(), 2U);
  EXPECT_EQ(TextOf(Order(ProcessVerb::kKill)), "process 'robot' is gone already");
}

TEST_F(SupervisorTest, OneThatIsToRestartNeverDoesNot) {
  Run(RestartPolicy::kNever);

  End(kKilled);

  EXPECT_TRUE(Comes([this] {
    return ReasonNow() ==
           "was ended by SIGKILL; its log: robot.log; it is not started again (restart never)";
  }));
}

TEST_F(SupervisorTest, WhatWaitsToBeStartedAgainCanBeToldToStayEnded) {
  Run(RestartPolicy::kOnFailure);
  End(kKilled);
  ASSERT_TRUE(Comes([this] { return ReasonNow().find("started again in") != std::string::npos; }));

  const auto answer = Order(ProcessVerb::kKill);

  EXPECT_EQ(TextOf(answer), "");
  clock_.Advance(1h);
  Tick();
  EXPECT_EQ(launcher_->starts(), 1U);
  EXPECT_EQ(Reason(), "was told to end, and is not started again");
}

TEST_F(SupervisorTest, AStartIsUndoneAsLongAsNothingIsInTheProcess) {
  Run(RestartPolicy::kOnFailure, {test::Arm()});
  const auto step = history_.steps().entries.at(0);
  EXPECT_EQ(supervisor_.CheckUndo(step).error().message,
            "process 'robot' has components since, such as arm");
  Locked([this] {
    ASSERT_TRUE(registry_.Report(session_, {{{.kind = CatalogChange::Kind::kComponentRemoved,
                                              .process = "robot",
                                              .component = "arm"}}}));
  });
  EXPECT_TRUE(supervisor_.CheckUndo(step));

  Locked([&] { supervisor_.Undo(step, 1s, [](const auto& /*done*/) {}); });

  EXPECT_TRUE(launcher_->process()->terminated);
}

}  // namespace
}  // namespace tendon::server
