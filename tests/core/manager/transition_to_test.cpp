#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/local_manager.h>

#include <stdexcept>

namespace tendon {
namespace {

using testing::HasSubstr;

constexpr std::chrono::nanoseconds kShort = std::chrono::milliseconds(20);
constexpr std::chrono::nanoseconds kLater = std::chrono::seconds(1);

/// A component that continues to run after a request to suspend.
class Restless final : public Component {
 public:
  using Component::Component;

 private:
  void Pause() override {}
};

/// A component that becomes active only after a wait for this has timed out.
class Slow final : public Component {
 public:
  using Component::Component;

 private:
  Result<void> Launch() override {
    begin_ = SteadyClock().Now();
    return {};
  }
  void ServeWaiting() override {
    if (is_starting() && SteadyClock().Now() > begin_ + kLater) {
      SetState(ComponentState::kActive);
    }
  }

  SteadyTime begin_;
};

class Failing final : public Component {
 public:
  using Component::Component;

 private:
  void Startup() override { throw std::runtime_error("no power"); }
};

class TransitionToTest : public testing::Test {
 protected:
  [[nodiscard]] ComponentState StateOf(const std::string& component) const {
    return manager_.Find(component)->state();
  }

  LocalManager manager_;
};

TEST_F(TransitionToTest, ReachesTheWantedState) {
  using enum ComponentState;
  const auto transition_to = [this](const std::string& name, ComponentState wanted) {
    manager_.Add<Component>(name);
    EXPECT_TRUE(manager_.TransitionTo(name, wanted));
    return StateOf(name);
  };

  EXPECT_EQ(transition_to("active", kActive), kActive);
  EXPECT_EQ(transition_to("suspended", kSuspended), kSuspended);
  EXPECT_EQ(transition_to("finished", kFinished), kConstructed);
  EXPECT_EQ(transition_to("constructed", kConstructed), kConstructed);
}

TEST_F(TransitionToTest, StopsAComponentThatCannotBeSuspended) {
  manager_.Add<Restless>("arm");

  const auto result = manager_.TransitionTo("arm", ComponentState::kSuspended, kShort);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(result.error().message, HasSubstr("'arm' could not be suspended: "));
  EXPECT_THAT(result.error().message, HasSubstr("it was stopped instead"));
  EXPECT_EQ(StateOf("arm"), ComponentState::kFinished);
}

TEST_F(TransitionToTest, StopsAComponentThatStartsTooLate) {
  Slow& arm = manager_.Add<Slow>("arm");

  const auto result = manager_.TransitionTo("arm", ComponentState::kSuspended, kShort);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(result.error().message, HasSubstr("it was stopped instead"));
  EXPECT_EQ(arm.state(), ComponentState::kFinished);
}

TEST_F(TransitionToTest, DoesNotStopAComponentThatFailsToStart) {
  manager_.Add<Failing>("arm");

  const auto result = manager_.TransitionTo("arm", ComponentState::kSuspended);

  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("no power"));
  EXPECT_EQ(result.error().message.find("stopped"), std::string::npos);
  EXPECT_EQ(StateOf("arm"), ComponentState::kFaulted);
}

}  // namespace
}  // namespace tendon
