#include <gmock/gmock.h>
#include <tendon/gcm/system/plan_execution.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tendon {
namespace {

using testing::ElementsAre;
using Kind = PlanStep::Kind;

/// Records the steps, and fails at some of them.
class FakeExecutor : public PlanExecutor {
 public:
  explicit FakeExecutor(std::set<std::string> failing = {}) : failing_(std::move(failing)) {}

  Result<void> Execute(const PlanStep& step) override {
    const std::string text = ToString(step);
    tried_.push_back(text);
    if (failing_.contains(text)) return Error{ErrorCode::kTimeout, "no reply to " + text};
    return {};
  }
  [[nodiscard]] const std::vector<std::string>& tried() const { return tried_; }

 private:
  const std::set<std::string> failing_;
  std::vector<std::string> tried_;
};

PlanStep Step(Kind kind, const std::string& component) {
  PlanStep step{.kind = kind, .process = "p"};
  step.component.name = component;
  return step;
}

/// Returns a step that connects R of `client` to P of `server`.
PlanStep Connect(const std::string& client, const std::string& server) {
  return {.kind = Kind::kConnect, .ends = {{"p", client, "R"}, {"p", server, "P"}}};
}

/// Returns the step that starts the process of all the other steps.
PlanStep StartProcess() { return {.kind = Kind::kStartProcess, .process = "p"}; }

Plan ThreeStarts() {
  return {.steps = {Step(Kind::kStart, "a"), Step(Kind::kStart, "b"), Step(Kind::kStart, "c")}};
}

/// Executes the plan and returns its reports: "2 start p/b failed: no reply".
std::vector<std::string> Execute(const Plan& plan, FakeExecutor& executor, AfterError after_error) {
  std::vector<std::string> told;
  ExecutePlan(plan, executor, after_error,
              [&](std::size_t number, const PlanStep& step, const StepOutcome& outcome) {
                const char* const fates[] = {"done", "failed", "left"};
                told.push_back(std::to_string(number) + " " + ToString(step) + " " +
                               fates[static_cast<int>(outcome.state)] +
                               (outcome.reason.empty() ? "" : ": " + outcome.reason));
              });
  return told;
}

/// Executes a plan in which the step `failing` fails, and continues. Returns the steps that were
/// not executed.
std::vector<std::string> LeftAfter(const std::string& failing, const std::vector<PlanStep>& steps) {
  FakeExecutor executor({failing});
  std::vector<std::string> left;
  ExecutePlan({.steps = steps}, executor, AfterError::kGoOn,
              [&](std::size_t, const PlanStep& step, const StepOutcome& outcome) {
                if (outcome.state != StepOutcome::State::kLeft) return;
                EXPECT_EQ(outcome.reason,
                          "not executed, because an earlier step failed: " + failing);
                left.push_back(ToString(step));
              });
  return left;
}

TEST(ExecutePlan, ReportsEachStep) {
  FakeExecutor executor;

  EXPECT_THAT(Execute(ThreeStarts(), executor, AfterError::kStop),
              ElementsAre("1 start p/a done", "2 start p/b done", "3 start p/c done"));
}

TEST(ExecutePlan, StopsAtTheFirstErrorAndListsRemainingSteps) {
  FakeExecutor executor({"start p/b"});

  EXPECT_THAT(Execute(ThreeStarts(), executor, AfterError::kStop),
              ElementsAre("1 start p/a done", "2 start p/b failed: no reply to start p/b",
                          "3 start p/c left"));
  EXPECT_THAT(executor.tried(), ElementsAre("start p/a", "start p/b"));
}

TEST(ExecutePlan, AnInterruptStopsBetweenSteps) {
  const auto nothing = [](std::size_t, const PlanStep&, const StepOutcome&) {};
  FakeExecutor executor;

  const PlanOutcome outcome = ExecutePlan(ThreeStarts(), executor, AfterError::kGoOn, nothing,
                                          [&] { return !executor.tried().empty(); });

  EXPECT_THAT(executor.tried(), ElementsAre("start p/a"));
  EXPECT_EQ(outcome,
            (PlanOutcome{.done = 1, .failed = 0, .left = 2, .error = {}, .is_interrupted = true}));
}

TEST(ExecutePlan, CountsTheOutcomesOfSteps) {
  const auto nothing = [](std::size_t, const PlanStep&, const StepOutcome&) {};
  const Error error{ErrorCode::kTimeout, "no reply to start p/b"};
  FakeExecutor whole;
  FakeExecutor stopped({"start p/b"});
  FakeExecutor gone_on({"start p/b"});

  EXPECT_EQ(ExecutePlan(ThreeStarts(), whole, AfterError::kStop, nothing),
            (PlanOutcome{.done = 3, .failed = 0, .left = 0, .error = {}}));
  EXPECT_EQ(ExecutePlan(ThreeStarts(), stopped, AfterError::kStop, nothing),
            (PlanOutcome{.done = 1, .failed = 1, .left = 1, .error = error}));
  EXPECT_EQ(ExecutePlan(ThreeStarts(), gone_on, AfterError::kGoOn, nothing),
            (PlanOutcome{.done = 2, .failed = 1, .left = 0, .error = error}));
}

TEST(ExecutePlan, StartsNothingThatLacksAConnection) {
  EXPECT_THAT(LeftAfter("connect p/a/R -> p/b/P",
                        {Connect("a", "b"), Connect("a", "c"), Step(Kind::kStart, "b"),
                         Step(Kind::kStart, "a"), Step(Kind::kStartSuspended, "c")}),
              ElementsAre("start p/a"));
}

TEST(ExecutePlan, SkipsStepsThatDependOnAFailedComponent) {
  EXPECT_THAT(
      LeftAfter("configure p/b",
                {Step(Kind::kConfigure, "b"), Connect("b", "c"), Connect("a", "b"),
                 Step(Kind::kStart, "c"), Step(Kind::kStart, "b"), Step(Kind::kStart, "a")}),
      ElementsAre("connect p/b/R -> p/c/P", "connect p/a/R -> p/b/P", "start p/b", "start p/a"));
  EXPECT_THAT(LeftAfter("stop p/a", {Step(Kind::kStop, "a"), Step(Kind::kRemove, "a"),
                                     Step(Kind::kRemove, "b")}),
              ElementsAre("remove p/a"));
}

TEST(PlanExecution, SkipsAllStepsOfAnUnstartedProcess) {
  FakeExecutor executor({"start process p (restart never)"});
  PlanStep elsewhere = Step(Kind::kStart, "d");
  elsewhere.process = "q";

  const auto told = Execute({.steps = {StartProcess(), Step(Kind::kCreate, "a"), Connect("b", "c"),
                                       Step(Kind::kStart, "a"), elsewhere}},
                            executor, AfterError::kGoOn);

  EXPECT_THAT(executor.tried(), ElementsAre("start process p (restart never)", "start q/d"));
  ASSERT_EQ(told.size(), 5U);
  EXPECT_EQ(told[2],
            "3 connect p/b/R -> p/c/P left: not executed, because an earlier step failed: start "
            "process p "
            "(restart never)");
}

}  // namespace
}  // namespace tendon
