#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/transition_to.h>

#include <stdexcept>

namespace tendon {
namespace {

using testing::HasSubstr;

constexpr Patience kShort = std::chrono::milliseconds(20);
constexpr Patience kLater = std::chrono::seconds(1);

/// Goes on where it is to rest.
class Restless final : public Component {
 public:
  using Component::Component;

 private:
  void Pause() override {}
};

/// Is active when somebody has waited for that in vain.
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

class BringToTest : public testing::Test {
 protected:
  [[nodiscard]] ComponentState StateOf(const std::string& component) const {
    return manager_.Find(component)->state();
  }

  LocalManager manager_;
};

TEST_F(BringToTest, AComponentComesToTheStateThatIsWanted) {
  using enum ComponentState;
  const auto bring = [this](const std::string& name, ComponentState wanted) {
    manager_.Add<Component>(name);
    EXPECT_TRUE(TransitionTo(manager_, name, wanted));
    return StateOf(name);
  };

  EXPECT_EQ(bring("active", kActive), kActive);
  EXPECT_EQ(bring("suspended", kSuspended), kSuspended);
  EXPECT_EQ(bring("finished", kFinished), kConstructed);
  EXPECT_EQ(bring("constructed", kConstructed), kConstructed);
}

TEST_F(BringToTest, WhatCannotBeSuspendedIsStopped) {
  manager_.Add<Restless>("arm");

  const auto brought = TransitionTo(manager_, "arm", ComponentState::kSuspended, kShort);

  ASSERT_FALSE(brought);
  EXPECT_EQ(brought.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(brought.error().message, HasSubstr("'arm' could not be suspended: "));
  EXPECT_THAT(brought.error().message, HasSubstr("it was stopped instead"));
  EXPECT_EQ(StateOf("arm"), ComponentState::kFinished);
}

TEST_F(BringToTest, WhatStartsTooLateIsStoppedOnceItHas) {
  Slow& arm = manager_.Add<Slow>("arm");

  const auto brought = TransitionTo(manager_, "arm", ComponentState::kSuspended, kShort);

  ASSERT_FALSE(brought);
  EXPECT_EQ(brought.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(brought.error().message, HasSubstr("it was stopped instead"));
  EXPECT_EQ(arm.state(), ComponentState::kFinished);
}

TEST_F(BringToTest, WhatDoesNotStartIsNotStopped) {
  manager_.Add<Failing>("arm");

  const auto brought = TransitionTo(manager_, "arm", ComponentState::kSuspended);

  ASSERT_FALSE(brought);
  EXPECT_THAT(brought.error().message, HasSubstr("no power"));
  EXPECT_EQ(brought.error().message.find("stopped"), std::string::npos);
  EXPECT_EQ(StateOf("arm"), ComponentState::kFaulted);
}

}  // namespace
}  // namespace tendon
