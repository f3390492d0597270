#include <tendon/gcm/members/registry.h>
#include <tests/core/gcm/gcm_fixture.h>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr std::int64_t kOneSecond = 1'000'000'000;
constexpr std::uint64_t kMiB = 1U << 20U;

class RegistryHealth : public testing::Test {
 protected:
  server::SessionToken Join(const std::string& name, std::uint64_t instance) {
    const auto admission = registry_.Join({test::ProcessNamed(name, instance), {}, {}}, 0, nullptr);
    EXPECT_TRUE(admission) << admission.error().message;
    return admission ? admission->session : 0;
  }
  /// Returns the health of the only process that has reported.
  [[nodiscard]] message::ProcessHealth Only() const {
    const auto health = registry_.health();
    EXPECT_EQ(health.processes.size(), 1U);
    return health.processes.empty() ? message::ProcessHealth{} : health.processes.front();
  }

  ManualClock clock_;
  server::Registry registry_{server::Leases{}, clock_};
};

TEST_F(RegistryHealth, HasNoEntryBeforeTheFirstReport) {
  Join("robot", 1);

  EXPECT_TRUE(registry_.health().processes.empty());
}

TEST_F(RegistryHealth, CpuLoadUsesTheLastTwoReports) {
  const auto robot = Join("robot", 7);

  ASSERT_TRUE(
      registry_.UpdateHealth(robot, {.cpu_time = kOneSecond, .memory = kMiB, .time = kOneSecond}));
  EXPECT_LT(Only().cpu, 0.0);
  EXPECT_EQ(Only().memory, kMiB);
  // The load is computed with the clock of the process, on which two seconds pass.
  clock_.Advance(100ms);
  ASSERT_TRUE(registry_.UpdateHealth(
      robot, {.cpu_time = 4 * kOneSecond, .memory = 2 * kMiB, .time = 3 * kOneSecond}));

  EXPECT_EQ(Only().process, "robot");
  EXPECT_EQ(Only().instance, 7U);
  EXPECT_DOUBLE_EQ(Only().cpu, 1.5);
  EXPECT_EQ(Only().memory, 2 * kMiB);
  ASSERT_TRUE(registry_.UpdateHealth(robot, {.cpu_time = 4 * kOneSecond, .time = 4 * kOneSecond}));
  EXPECT_DOUBLE_EQ(Only().cpu, 0.0);
}

TEST_F(RegistryHealth, TimesThatGoBackGiveNoCpuLoad) {
  const auto robot = Join("robot", 1);
  ASSERT_TRUE(registry_.UpdateHealth(robot, {.cpu_time = kOneSecond, .time = kOneSecond}));

  for (const message::Health& nonsense :
       {message::Health{.cpu_time = 2 * kOneSecond, .time = kOneSecond},
        message::Health{.cpu_time = 3 * kOneSecond, .time = INT64_MIN},
        message::Health{.cpu_time = INT64_MIN, .time = INT64_MAX}}) {
    ASSERT_TRUE(registry_.UpdateHealth(robot, nonsense));
    EXPECT_LT(Only().cpu, 0.0);
  }
}

TEST_F(RegistryHealth, AnEntryAgesUntilTheProcessIsGone) {
  const auto robot = Join("robot", 1);
  ASSERT_TRUE(registry_.UpdateHealth(robot, {.memory = kMiB}));

  clock_.Advance(1400ms);
  EXPECT_EQ(Only().age, 1400ms);

  registry_.End(robot, ProcessState::kLost, "killed");
  EXPECT_TRUE(registry_.health().processes.empty());
  EXPECT_EQ(registry_.UpdateHealth(robot, {}).error().code, ErrorCode::kDenied);
  Join("robot", 2);
  EXPECT_TRUE(registry_.health().processes.empty());
}

TEST_F(RegistryHealth, DoesNotChangeTheCatalogue) {
  const auto robot = Join("robot", 1);
  static_cast<void>(registry_.TakeChanges());
  const Catalogue before = registry_.catalogue();

  ASSERT_TRUE(registry_.UpdateHealth(robot, {.memory = kMiB}));

  EXPECT_TRUE(registry_.TakeChanges().empty());
  EXPECT_EQ(registry_.catalogue(), before);
}

class Health : public test::GcmFixture {
 protected:
  static message::SystemHealth Ask(GcmClient& client) {
    const auto health =
        Wait<message::SystemHealth>(kLong, [&](auto handler) { client.GetHealth(handler); });
    EXPECT_TRUE(health) << health.error().message;
    return health ? *health : message::SystemHealth{};
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Health, testing::Values("loopback", "tcp"), test::NameOfParameter);

TEST_P(Health, IsSentOnlyToViewersThatRequestIt) {
  const auto robot = Join("robot", {test::Arm()});
  const auto desk = Join("desk", {});
  const auto recorder = std::make_shared<test::Recorder>();
  GcmClient viewer(NewMiddleware(),
                   {.name = "viewer", .address = address_, .timeout = kLong, .role = Role::kViewer},
                   recorder);
  ASSERT_TRUE(viewer.WaitUntilWatching());

  ASSERT_TRUE(robot->ReportHealth({.memory = kMiB, .clock_offset = 3ms, .clock_uncertainty = 1ms}));
  ASSERT_TRUE(desk->ReportHealth({.memory = 2 * kMiB}));
  clock_.Advance(250ms);

  const auto processes = Ask(viewer).processes;
  ASSERT_EQ(processes.size(), 2U);
  EXPECT_EQ(processes[0].process, "desk");
  EXPECT_EQ(processes[0].memory, 2 * kMiB);
  EXPECT_LT(processes[0].clock_uncertainty, 0ns);
  EXPECT_EQ(processes[1].process, "robot");
  EXPECT_EQ(processes[1].clock_offset, 3ms);
  EXPECT_EQ(processes[1].clock_uncertainty, 1ms);
  EXPECT_EQ(processes[1].age, 250ms);
  EXPECT_TRUE(recorder->changes().empty());
}

TEST_P(Health, ANonMemberHasNone) {
  test::FakeProcess unjoined(NewMiddleware(), "robot");
  EXPECT_FALSE(unjoined.ReportHealth({}));

  const auto robot = Join("robot", {});
  ASSERT_TRUE(robot->Leave());
  EXPECT_FALSE(robot->ReportHealth({}));

  EXPECT_TRUE(Ask(*Watch()).processes.empty());
}

TEST_P(Health, TheReplyContainsTheTime) {
  const auto robot = Join("robot", {});
  const SteadyTime before = SteadyClock().Now();

  const auto clock = robot->ReportHealth({});

  ASSERT_TRUE(clock) << clock.error().message;
  const SteadyTime there{std::chrono::nanoseconds(clock->time)};
  EXPECT_GE(there, before);
  EXPECT_LE(there, SteadyClock().Now());
}

}  // namespace
}  // namespace tendon
