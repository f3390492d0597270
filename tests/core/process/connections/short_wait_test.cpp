#include <gmock/gmock.h>
#include <tendon/task/signal_task.h>

#include <atomic>
#include <future>
#include <numeric>
#include <thread>
#include <vector>

#include "support/network_test.h"
#include "support/record.h"

namespace {

using namespace std::chrono_literals;
using tendon::Status;

const tendon::InterfaceName kGong("robot", "gong", "Control");
const tendon::InterfaceName kPorter("desk", "porter", "Gong");

/// Sleeps until a command arrives. Executes commands at once, unless it is stuck.
class Gong final : public tendon::SignalTask {
 public:
  explicit Gong(std::string name) : SignalTask(std::move(name)) {
    auto& control = AddProvidedInterface("Control");
    control.AddCommandWrite(&Gong::Strike, this, "Strike");
    control.AddCommandWriteReturn(&Gong::Echo, this, "Echo");
    control.AddCommandVoid(&Gong::Stick, this, "Stick");
    control.AddCommandRead(&Gong::Count, this, "Count", tendon::kThreadSafe);
  }
  ~Gong() override { Join(); }

  void Run() override { ProcessQueuedCommands(); }

  [[nodiscard]] std::vector<int> strikes() const { return strikes_.values(); }

  std::atomic<bool> stuck{false};
  std::atomic<int> sticks{0};

 private:
  void Strike(int number) { strikes_.Add(number); }
  void Echo(const std::vector<double>& in, std::vector<double>& out) { out = in; }
  void Stick() {
    ++sticks;
    while (stuck) std::this_thread::yield();
  }
  void Count(int& out) const { out = static_cast<int>(strikes_.size()); }

  tendon::test::Record<int> strikes_;
};

/// A component without a thread: the tests call its functions in any thread.
class Porter final : public tendon::Component {
 public:
  explicit Porter(std::string name) : Component(std::move(name)) {
    auto& gong = AddRequiredInterface("Gong");
    gong.AddFunction(strike, "Strike");
    gong.AddFunction(echo, "Echo");
    gong.AddFunction(stick, "Stick");
    gong.AddFunction(count, "Count");
    gong.SetReadDeadline(20s);
  }

  tendon::WriteFunction<int> strike;
  tendon::WriteReturnFunction<std::vector<double>, std::vector<double>> echo;
  tendon::VoidFunction stick;
  tendon::ReadFunction<int> count;
};

/// Callers wait for a task that executes commands quickly.
class ShortWait : public NetworkTest {
 protected:
  static constexpr auto kTestTimeout = 120s;

  ShortWait() {
    gong = &robot->Add<Gong>("gong");
    porter = &desk->Add<Porter>("porter");
    EXPECT_TRUE(robot->StartAll().ok());
    EXPECT_TRUE(desk->StartAll().ok());
    Connect();
  }
  ~ShortWait() override { gong->stuck = false; }

  void Connect() {
    const auto id = desk->Connect(kPorter, kGong);
    EXPECT_TRUE(id.ok()) << id.error().message;
    EXPECT_TRUE(EventuallyActive(*desk, 1)) << desk->connections().front().reason;
  }
  /// Makes many short calls, and then a call in which the gong hangs.
  std::future<Status> WaitForStick() {
    constexpr int kSoonDone = 20;
    for (int i = 0; i < kSoonDone; ++i) {
      EXPECT_EQ(porter->stick.Wait(kTestTimeout), Status(Status::kDone));
    }
    gong->stuck = true;
    auto status =
        std::async(std::launch::async, [this] { return porter->stick.Wait(kTestTimeout); });
    EXPECT_TRUE(EventuallyTrue([this] { return gong->sticks > kSoonDone; }));
    return status;
  }

  std::unique_ptr<tendon::Process> robot = Start("robot");
  std::unique_ptr<tendon::Process> desk = Start("desk");
  Gong* gong = nullptr;
  Porter* porter = nullptr;
};

INSTANTIATE_TEST_SUITE_P(Over, ShortWait, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

TEST_P(ShortWait, KeepsTheOrderWithTheCallsBeforeAndAfterIt) {
  constexpr int kStrikes = 600;

  for (int i = 0; i < kStrikes; ++i) {
    if (i % 3 == 2) {
      ASSERT_EQ(porter->strike.Wait(i, kTestTimeout), Status(Status::kDone));
      EXPECT_EQ(gong->strikes().size(), static_cast<std::size_t>(i + 1));
    } else {
      ASSERT_TRUE(EventuallyTrue([&] { return porter->strike(i) == Status(Status::kQueued); }));
    }
  }

  std::vector<int> expected(kStrikes);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(gong->strikes(), expected);
}

TEST_P(ShortWait, IsNotExecutedAfterItsDeadline) {
  EXPECT_EQ(porter->strike.Wait(1, 0s), Status(Status::kTimeout));

  EXPECT_EQ(porter->strike.Wait(2, kTestTimeout), Status(Status::kDone));
  EXPECT_EQ(gong->strikes(), std::vector{2});
}

TEST_P(ShortWait, ReturnsRepliesOfAllSizes) {
  for (const std::size_t size : {0U, 1U, 1000U, 32'000U, 33'000U, 200'000U}) {
    const std::vector<double> question(size, 0.5);
    std::vector<double> result{1, 2, 3};

    ASSERT_EQ(porter->echo.Wait(question, result, kTestTimeout), Status(Status::kDone)) << size;

    EXPECT_EQ(result, question);
  }
}

TEST_P(ShortWait, BlocksNobodyIfItIsLong) {
  auto status = WaitForStick();

  int strikes = -1;
  EXPECT_EQ(porter->count(strikes), Status(Status::kDone));
  EXPECT_EQ(strikes, 0);
  EXPECT_EQ(porter->strike(1), Status(Status::kQueued));
  gong->stuck = false;

  EXPECT_EQ(status.get(), Status(Status::kDone));
  EXPECT_EQ(porter->strike.Wait(2, kTestTimeout), Status(Status::kDone));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(porter->stick.Wait(kTestTimeout), Status(Status::kDone));
  EXPECT_EQ(gong->strikes(), (std::vector{1, 2}));
}

TEST_P(ShortWait, EndsWithADisconnect) {
  auto status = WaitForStick();

  ASSERT_TRUE(desk->Disconnect(kPorter).ok());

  EXPECT_EQ(status.get(), Status(Status::kOutcomeUnknown));
  gong->stuck = false;
  Connect();
  EXPECT_EQ(porter->strike.Wait(1, kTestTimeout), Status(Status::kDone));
}

TEST_P(ShortWait, ReportsTrueOutcomesDuringReconnects) {
  std::atomic<bool> is_done{false};
  std::atomic<int> done{0};
  std::atomic<int> unknown{0};
  std::vector<std::jthread> callers;
  for (int caller = 0; caller < 3; ++caller) {
    callers.emplace_back([&] {
      while (!is_done) {
        const Status status = porter->strike.Wait(1, kTestTimeout);
        if (status == Status(Status::kDone)) ++done;
        if (status == Status(Status::kOutcomeUnknown)) ++unknown;
        if (!status) std::this_thread::yield();
      }
    });
  }

  for (int round = 1; round <= 10; ++round) {
    EXPECT_TRUE(EventuallyTrue([&] { return done >= 50 * round; }));
    EXPECT_TRUE(desk->Disconnect(kPorter).ok());
    Connect();
  }
  is_done = true;
  callers.clear();

  const int strikes = static_cast<int>(gong->strikes().size());
  EXPECT_GE(strikes, done);
  EXPECT_LE(strikes, done + unknown);
}

}  // namespace
