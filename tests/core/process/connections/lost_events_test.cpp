#include <gtest/gtest.h>
#include <tendon/proxy/component_proxy.h>
#include <tendon/task/periodic_task.h>

#include <memory>
#include <string>
#include <vector>

#include "support/network_test.h"

namespace {

using namespace std::chrono_literals;
using tendon::Status;

const tendon::InterfaceName kBell("robot", "bell", "Bell");
const tendon::InterfaceName kEar("desk", "ear", "Bell");

/// Raises a requested number of events in one cycle.
class Bell final : public tendon::PeriodicTask {
 public:
  explicit Bell(std::string name) : PeriodicTask(std::move(name), 1ms) {
    auto& bell = AddProvidedInterface("Bell");
    bell.AddCommandWrite(&Bell::Ring, this, "Ring");
    bell.AddEvent(rung, "Rung");
  }
  ~Bell() override { Join(); }

  void Run() override { ProcessQueuedCommands(); }

  tendon::WriteEvent<int> rung;

 private:
  void Ring(int times) {
    for (int i = 0; i < times; ++i) rung(++number_);
  }

  int number_ = 0;
};

/// A component without a thread: it handles events when the test executes them.
class Ear final : public tendon::Component {
 public:
  explicit Ear(std::string name) : Component(std::move(name), std::make_unique<tendon::Inbox>()) {
    auto& bell = AddRequiredInterface("Bell");
    bell.AddFunction(ring, "Ring");
    bell.AddEventHandlerWrite(&Ear::OnRung, this, "Rung");
    bell.SetMailboxCapacity(8);
    bell_ = &bell;
  }

  void Process() { inbox()->ExecuteQueued(); }
  [[nodiscard]] std::uint64_t lost() const { return bell_->lost_events(); }

  tendon::WriteFunction<int> ring;
  std::vector<int> heard;

 private:
  void OnRung(int number) { heard.push_back(number); }

  const tendon::RequiredInterface* bell_ = nullptr;
};

class RemoteEvents : public NetworkTest {};

TEST_P(RemoteEvents, LossesAreCountedAtBothEnds) {
  constexpr int kTimes = 500;
  const auto robot = Start("robot");
  const auto desk = Start("desk");
  auto& bell = robot->Add<Bell>("bell");
  auto& ear = desk->Add<Ear>("ear");
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(desk->StartAll().ok());
  ASSERT_TRUE(desk->Connect(kEar, kBell).ok());
  ASSERT_TRUE(EventuallyActive(*desk, 1));
  const auto all = [&ear] { return ear.heard.size() + ear.lost(); };

  ASSERT_EQ(ear.ring.Wait(kTimes, 20s), Status(Status::kDone));
  ASSERT_TRUE(EventuallyTrue([&] { return all() + 8 == kTimes; })) << all();
  EXPECT_TRUE(ear.heard.empty());
  EXPECT_TRUE(EventuallyTrue([&] {
    ear.Process();
    return all() == kTimes;
  }));

  const auto served = robot->proxies().front().required.front();
  EXPECT_TRUE(EventuallyTrue([&] { return served->lost_events() == ear.lost(); }));
  EXPECT_LE(bell.rung.lost(), ear.lost()) << "those that could not be sent";
  EXPECT_EQ(ear.heard, (std::vector{1, 2, 3, 4, 5, 6, 7, 8}));
}

INSTANTIATE_TEST_SUITE_P(Over, RemoteEvents, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
