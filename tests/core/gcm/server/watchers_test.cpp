#include <sys/socket.h>
#include <tests/core/gcm/gcm_fixture.h>

#include <atomic>
#include <thread>

namespace tendon {
namespace {

using test::FakeProcess;
using test::Recorder;

class WatchersTest : public test::GcmFixture {};

INSTANTIATE_TEST_SUITE_P(Over, WatchersTest, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(WatchersTest, ASnapshotComesFirstThenChanges) {
  const auto robot = Join("robot", {test::Arm()});
  const auto recorder = std::make_shared<Recorder>();
  const auto client = Watch(recorder);
  ASSERT_TRUE(EventuallyTrue([&] { return recorder->snapshots() == 1; }));
  EXPECT_EQ(recorder->catalogue(), gcm_->catalogue());

  const auto desk = Join("desk", {test::Teleoperation()});

  EXPECT_TRUE(EventuallyTrue([&] { return client->catalogue() == gcm_->catalogue(); }));
  EXPECT_TRUE(EventuallyTrue([&] { return recorder->catalogue() == gcm_->catalogue(); }));
  EXPECT_EQ(recorder->snapshots(), 1);
}

TEST_P(WatchersTest, AResyncSendsASnapshotThenChanges) {
  const auto robot = Join("robot", {test::Arm()});
  const auto recorder = std::make_shared<Recorder>();
  const auto client = Watch(recorder);
  ASSERT_TRUE(EventuallyTrue([&] { return recorder->snapshots() == 1; }));

  client->Resync();

  ASSERT_TRUE(EventuallyTrue([&] { return recorder->snapshots() == 2; }));
  const auto desk = Join("desk", {test::Teleoperation()});
  EXPECT_TRUE(EventuallyTrue([&] { return recorder->catalogue() == gcm_->catalogue(); }));
  EXPECT_EQ(recorder->holes(), 0);
}

TEST_P(WatchersTest, AViewerStoresEqualInterfacesOnce) {
  const auto robot = Join("robot", {test::Arm()});
  const auto client = Watch();
  const auto spare = Join("spare", {test::Arm()});
  ASSERT_TRUE(
      EventuallyTrue([&] { return client->catalogue().FindComponent("spare", "arm") != nullptr; }));

  const Catalogue catalogue = client->catalogue();
  const auto& interfaces = catalogue.FindComponent("robot", "arm")->provided;
  EXPECT_EQ(interfaces.data(), catalogue.FindComponent("spare", "arm")->provided.data());
  EXPECT_EQ(interfaces, test::Arm().provided);
}

TEST_P(WatchersTest, AllWatchersSeeTheSameSequenceOfChanges) {
  const auto one = std::make_shared<Recorder>();
  const auto two = std::make_shared<Recorder>();
  const auto first = Watch(one);
  const auto second = Watch(two);

  std::vector<std::thread> threads;
  for (const std::string name : {"robot", "desk", "hall"}) {
    threads.emplace_back([this, name] {
      const auto middleware = NewMiddleware();
      for (int i = 0; i < 10; ++i) {
        FakeProcess process(middleware, name);
        process.Add(test::Arm());
        ASSERT_TRUE(process.Join(address_));
        process.Add(test::Teleoperation());
        if (i % 2 == 0) {
          ASSERT_TRUE(process.Leave());
        }
        process.BreakLink();
        ASSERT_TRUE(EventuallyTrue([&] { return StateOf(name) >= ProcessState::kLost; }));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();

  const Catalogue last = gcm_->catalogue();
  ASSERT_TRUE(EventuallyTrue([&] { return one->catalogue() == last && two->catalogue() == last; }));
  const auto changes = one->changes();
  EXPECT_EQ(changes, two->changes());
  ASSERT_EQ(changes.size(), last.revision());
  for (std::size_t i = 0; i < changes.size(); ++i) ASSERT_EQ(changes[i].revision, i + 1);
  EXPECT_EQ(one->snapshots() + two->snapshots(), 2);
}

/// Limits the socket buffers of this program, so that a link is full soon.
void ShrinkSockets() {
  constexpr int kDescriptors = 1024;
  constexpr int kBytes = 1 << 16;
  for (int descriptor = 0; descriptor < kDescriptors; ++descriptor) {
    (void)setsockopt(descriptor, SOL_SOCKET, SO_SNDBUF, &kBytes, sizeof kBytes);
    (void)setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &kBytes, sizeof kBytes);
  }
}

/// Reads nothing after its first snapshot, until it is released.
class StuckListener final : public Recorder {
 public:
  void OnChanges(const std::vector<CatalogueChange>& changes) override {
    is_released_.wait(false);
    Recorder::OnChanges(changes);
  }
  void Release() {
    is_released_ = true;
    is_released_.notify_all();
  }

 private:
  std::atomic<bool> is_released_ = false;
};

TEST_P(WatchersTest, ASlowWatcherCatchesUpByASnapshot) {
  const auto robot = Join("robot", {test::Arm()});
  const auto stuck = std::make_shared<StuckListener>();
  const auto quick = std::make_shared<Recorder>();
  const auto stuck_client = Watch(stuck);
  const auto quick_client = Watch(quick);
  const std::shared_ptr<void> at_the_end(nullptr, [&](void*) { stuck->Release(); });
  ShrinkSockets();
  // More changes than a link and the log of changes can hold.
  constexpr int kBatches = 32;
  constexpr int kBatch = 100;
  ComponentDescription arm = test::Arm();
  for (int batch = 0; batch < kBatches; ++batch) {
    std::vector<CatalogueChange> changes;
    for (int i = 0; i < kBatch; ++i) {
      arm.fault = std::to_string(batch * kBatch + i) + std::string(4000, '.');
      changes.push_back({.kind = CatalogueChange::Kind::kComponent, .components = {arm}});
    }
    robot->Report(changes);
    ASSERT_TRUE(EventuallyTrue([&] {
      const Catalogue seen = quick->catalogue();
      const auto* component = seen.FindComponent("robot", "arm");
      return component != nullptr && component->fault == arm.fault;
    })) << batch;
  }
  EXPECT_EQ(quick->snapshots(), 1);
  EXPECT_EQ(quick->holes(), 0);

  stuck->Release();

  EXPECT_TRUE(EventuallyTrue([&] { return stuck->catalogue() == gcm_->catalogue(); }));
  EXPECT_EQ(stuck->snapshots(), 2);
  EXPECT_EQ(stuck->holes(), 0);
  EXPECT_LT(stuck->changes().size(), quick->changes().size());
}

TEST_P(WatchersTest, AClientWithoutAGcmReportsAddressAndRemedy) {
  gcm_.reset();
  const auto recorder = std::make_shared<Recorder>();
  GcmClient client(NewMiddleware(),
                   {.name = "test", .address = address_, .timeout = std::chrono::seconds(1)},
                   recorder);

  const auto watching = client.WaitUntilWatching();

  ASSERT_FALSE(watching);
  EXPECT_EQ(watching.error().code, ErrorCode::kUnreachable);
  EXPECT_EQ(watching.error().message.find("no GCM at " + address_ + " ("), 0U)
      << watching.error().message;
  EXPECT_NE(watching.error().message.find("); start one with: gcm serve --gcm " + address_),
            std::string::npos);
  const auto connected = Connect(client);
  ASSERT_FALSE(connected);
  EXPECT_EQ(connected.error().code, ErrorCode::kUnreachable);
  ASSERT_TRUE(EventuallyTrue([&] { return !recorder->losses().empty(); }));
  EXPECT_EQ(recorder->losses()[0].message, watching.error().message);
}

TEST_P(WatchersTest, AClientReconnectsToItsGcm) {
  auto robot = Join("robot", {test::Arm()});
  const auto recorder = std::make_shared<Recorder>();
  const auto client = Watch(recorder);

  gcm_.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return recorder->losses().size() == 1; }));
  EXPECT_EQ(client->catalogue().processes().size(), 1U);  // the last known catalogue
  StartGcm(address_);
  const auto desk = Join("desk", {test::Teleoperation()});

  EXPECT_TRUE(client->WaitUntilWatching());
  EXPECT_TRUE(EventuallyTrue([&] { return recorder->catalogue() == gcm_->catalogue(); }));
  EXPECT_EQ(recorder->snapshots(), 2);
  EXPECT_EQ(recorder->losses().size(), 1U);
}

TEST_P(WatchersTest, AClientWithAnotherCookieIsRefusedAtOnce) {
  const auto middleware = NewMiddleware();
  const auto handler = std::make_shared<ChannelHandler>();
  const auto channel = Channel::Open(
      *middleware, address_, {.instance = 1, .name = "unknown", .cookie = 17}, handler, kLong);

  ASSERT_FALSE(channel);
  EXPECT_EQ(channel.error().code, ErrorCode::kDenied);
}

}  // namespace
}  // namespace tendon
