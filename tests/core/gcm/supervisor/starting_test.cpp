#include <tendon/gcm/lookup.h>
#include <tests/core/gcm/supervisor/supervisor_fixture.h>

namespace tendon::server {
namespace {

using testing::HasSubstr;

/// A process whose program was started, but that has not joined yet.
class StartingProcess : public SupervisorTest {
 protected:
  [[nodiscard]] std::string State() const {
    const auto* const entry = registry_.catalogue().FindProcess("robot");
    return entry == nullptr ? std::string("none") : std::string(ToString(entry->process.state));
  }
  [[nodiscard]] bool HasPid(std::int64_t pid) const {
    const auto* const entry = registry_.catalogue().FindProcess("robot");
    return entry != nullptr && entry->process.pid == pid;
  }
};

TEST_F(StartingProcess, IsShownAsStartingUntilItJoins) {
  const auto reply = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return HasPid(1); }));
  Locked([&] {
    EXPECT_EQ(State(), "starting");
    EXPECT_EQ(RequirePresent(registry_.catalogue().FindProcess("robot")->process).error().message,
              "process 'robot' is starting; try again when it has joined");
    EXPECT_EQ(registry_.Forget("robot").error().message,
              "process 'robot' is starting; only a process that is gone can be forgotten");
  });

  Join({test::Arm()});
  ASSERT_TRUE(IsAnswered(reply));
  Locked([&] { EXPECT_EQ(State(), "alive"); });

  End(kKilled);
  ASSERT_TRUE(Comes([&] { return State() == "lost"; }));
  ASSERT_TRUE(Comes([this] { return ReasonNow().find("500 ms") != std::string::npos; }));
  clock_.Advance(500ms);
  ASSERT_TRUE(Comes([&] { return launcher_->starts() == 2 && State() == "starting"; }));
  Locked([&] {  // its former components are still known
    EXPECT_NE(registry_.catalogue().FindComponent("robot", "arm"), nullptr);
  });
}

TEST_F(StartingProcess, LeavesNoTraceIfItDoesNotJoin) {
  const auto reply = Order(ProcessVerb::kStart);
  ASSERT_TRUE(Comes([this] { return HasPid(1); }));
  Locked([this] { launcher_->process()->end = kKilled; });

  ASSERT_TRUE(IsAnswered(reply));

  EXPECT_THAT(reply->text, HasSubstr("was ended by SIGKILL before it had joined"));
  Locked([this] { EXPECT_EQ(registry_.catalogue().FindProcess("robot"), nullptr); });
}

}  // namespace
}  // namespace tendon::server
