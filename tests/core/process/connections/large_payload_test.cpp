#include <gmock/gmock.h>
#include <tendon/manager/local_manager.h>
#include <tendon/middleware/payload_limit.h>
#include <tendon/proxy/component_proxy.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "support/log/log_record.h"
#include "support/network_test.h"
#include "support/record.h"

namespace {

using namespace std::chrono_literals;
using tendon::Status;
using testing::Contains;
using testing::HasSubstr;

using Cloud = std::vector<std::uint8_t>;

const tendon::InterfaceName kCloud("robot", "arm", "Cloud");
const tendon::InterfaceName kViewer("desk", "viewer", "Cloud");

#ifdef __SANITIZE_THREAD__
// Enough points that a slow transfer would take longer than a lease.
constexpr std::size_t kPoints = std::size_t{1} << 20U;
#else
constexpr std::size_t kPoints = std::size_t{9} << 20U;  // more than may wait on a link
#endif
constexpr std::size_t kTooMany = tendon::kMaxPayload + tendon::kMaxPayload / 10'000;

/// Receives point clouds and returns them.
class Arm final : public tendon::PeriodicTask {
 public:
  explicit Arm(std::string name) : PeriodicTask(std::move(name), 1ms) {
    auto& cloud = AddProvidedInterface("Cloud");
    cloud.AddCommandWrite(&Arm::Store, this, "cloud");
    cloud.AddCommandWrite(&Arm::Count, this, "Count");
    cloud.AddCommandQualifiedRead(&Arm::Points, this, "Points", tendon::kThreadSafe);
    cloud.AddCommandWriteReturn(&Arm::Grow, this, "Grow");
    cloud.AddEvent(stored, "Stored");
  }
  ~Arm() override { Join(); }

  void Run() override { ProcessQueuedCommands(); }

  [[nodiscard]] std::vector<std::string> log() const { return log_.values(); }

  tendon::WriteEvent<Cloud> stored;

 private:
  void Store(const Cloud& cloud) {
    Log("stored " + std::to_string(cloud.size()));
    stored(cloud);
  }
  void Count(int number) { Log("counted " + std::to_string(number)); }
  void Points(const std::uint64_t& size, Cloud& cloud) const { cloud.assign(size, 7); }
  void Grow(const Cloud& cloud, Cloud& grown) {
    grown = cloud;
    grown.push_back(8);
  }
  void Log(std::string line) { log_.Add(std::move(line)); }

  tendon::test::Record<std::string> log_;
};

/// A component without a thread: the test calls its functions and executes its received events.
class Viewer final : public tendon::Component {
 public:
  explicit Viewer(std::string name)
      : Component(std::move(name), std::make_unique<tendon::Inbox>()) {
    auto& arm = AddRequiredInterface("Cloud");
    arm.AddFunction(store, "cloud");
    arm.AddFunction(count, "Count");
    arm.AddFunction(points, "Points");
    arm.AddFunction(grow, "Grow");
    arm.AddEventHandlerWrite(&Viewer::OnStored, this, "Stored");
    arm.SetMailboxCapacity(4);
    arm.SetReadDeadline(20s);
  }

  void Process() { inbox()->ExecuteQueued(); }

  tendon::WriteFunction<Cloud> store;
  tendon::WriteFunction<int> count;
  tendon::QualifiedReadFunction<std::uint64_t, Cloud> points;
  tendon::WriteReturnFunction<Cloud, Cloud> grow;
  std::vector<std::size_t> stored;

 private:
  void OnStored(const Cloud& cloud) { stored.push_back(cloud.size()); }
};

class LargePayload : public NetworkTest {
 protected:
  LargePayload() {
    arm = &robot->Add<Arm>("arm");
    viewer = &desk->Add<Viewer>("viewer");
    EXPECT_TRUE(robot->StartAll().ok());
    EXPECT_TRUE(desk->StartAll().ok());
    const auto id = desk->Connect(kViewer, kCloud);
    EXPECT_TRUE(id.ok()) << id.error().message;
    EXPECT_TRUE(EventuallyActive(*desk, 1));
  }

  const tendon_test::LogRecord log{"network"};
  std::unique_ptr<tendon::Process> robot = Start("robot");
  std::unique_ptr<tendon::Process> desk = Start("desk");
  Arm* arm = nullptr;
  Viewer* viewer = nullptr;
};

TEST_P(LargePayload, IsSupportedByAllCommandsAndEvents) {
  const Cloud cloud(kPoints, 7);

  EXPECT_EQ(viewer->store(cloud), Status(Status::kQueued));
  EXPECT_TRUE(EventuallyTrue([&] {
    viewer->Process();
    return viewer->stored.size() == 1;
  }));
  Cloud result;
  EXPECT_EQ(viewer->points(kPoints, result), Status(Status::kDone));
  EXPECT_EQ(result, cloud);
  EXPECT_EQ(viewer->grow.Wait(cloud, result, 20s), Status(Status::kDone));

  EXPECT_EQ(result.size(), kPoints + 1);
  EXPECT_EQ(viewer->stored, std::vector{kPoints});
}

TEST_P(LargePayload, KeepsTheOrderOfItsConnectionsCalls) {
  const Cloud cloud(kPoints);

  EXPECT_EQ(viewer->count(1), Status(Status::kQueued));
  EXPECT_EQ(viewer->store(cloud), Status(Status::kQueued));
  EXPECT_EQ(viewer->count(2), Status(Status::kQueued));

  const std::vector<std::string> expected{"counted 1", "stored " + std::to_string(kPoints),
                                          "counted 2"};
  EXPECT_TRUE(EventuallyTrue([&] { return arm->log().size() == expected.size(); }));
  EXPECT_EQ(arm->log(), expected);
}

TEST_P(LargePayload, IsExecutedDespiteADisconnect) {
  EXPECT_EQ(viewer->store(Cloud(kPoints)), Status(Status::kQueued));

  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(desk->Disconnect(kViewer).ok());
  ASSERT_TRUE(EventuallyTrue([&] { return robot->proxies().empty(); }));
  const auto taken = std::chrono::steady_clock::now() - start;

  const std::vector executed{"stored " + std::to_string(kPoints)};
  EXPECT_TRUE(arm->log() == executed || taken >= tendon::LocalManager::kDrainTimeout)
      << "it may be dropped only after the timeout of an end";
}

TEST_P(LargePayload, OverTheLimitIsRefusedByTheSender) {
  const auto before = desk->connections();

  EXPECT_EQ(viewer->store(Cloud(kTooMany)), Status(Status::kInvalid));

  EXPECT_TRUE(EventuallyTrue([this] {
    return testing::Matches(
        Contains(HasSubstr("'cloud' of 67 115 578 B exceeds max_payload "
                           "67 108 864 B of robot/arm/Cloud")))(log.texts());
  }));
  EXPECT_EQ(desk->connections(), before);
  EXPECT_EQ(viewer->count(1), Status(Status::kQueued));
  EXPECT_TRUE(EventuallyTrue([&] { return arm->log() == std::vector<std::string>{"counted 1"}; }));
}

TEST_P(LargePayload, AReplyOverTheLimitFailsOnlyThatCall) {
  Cloud result;

  EXPECT_EQ(viewer->points(kTooMany, result), Status(Status::kFailed));

  EXPECT_THAT(log.texts(), Contains(HasSubstr("'Points' of 67 115 578 B exceeds max_payload")));
  EXPECT_EQ(viewer->points(10, result), Status(Status::kDone));
  EXPECT_EQ(result, Cloud(10, 7));
}

INSTANTIATE_TEST_SUITE_P(Over, LargePayload, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
