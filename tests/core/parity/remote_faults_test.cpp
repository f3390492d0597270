#include <gmock/gmock.h>
#include <tendon/middleware/loopback.h>

#include <filesystem>
#include <iterator>

#include "core/process/connections/remote_connection.h"

// Tests of the faults of cisst between processes, as far as no other test covers them. See the
// README of this folder.

namespace {

using tendon::Status;
using testing::StartsWith;

using RemoteFault = RemoteConnection;

TEST_P(RemoteFault, ListensOnlyLocallyByDefault) {
  StartRobot();

  EXPECT_THAT(robot->address(), StartsWith("127.0.0.1:"));
  EXPECT_THAT(tendon::ProcessOptions().listen, StartsWith("127.0.0.1:"));
  EXPECT_THAT(tendon::GlobalManager::Options().address, StartsWith("127.0.0.1:"));
}

TEST_P(RemoteFault, FurtherConnectionsOfTwoProcessesNeedNoThreads) {
  const auto threads = [] {
    const std::filesystem::directory_iterator entries("/proc/self/task");
    return std::distance(begin(entries), end(entries));
  };
  constexpr int kFurther = 16;
  // The thread pools of Ice may grow under load: three ends, by three threads each.
  constexpr int kPoolsMayGrow = 9;
  const auto name_of = [](int i) { return "further" + std::to_string(i); };
  StartRobot();
  StartDesk();
  for (int i = 0; i < kFurther; ++i) desk->Add<plant::Operator>(name_of(i));
  ASSERT_TRUE(desk->StartAll().ok());
  Connect();
  const auto before = threads();

  for (int i = 0; i < kFurther; ++i) {
    ASSERT_TRUE(desk->Connect({"desk", name_of(i), "Robot"}, kControl).ok());
  }
  ASSERT_TRUE(EventuallyActive(*desk, 1 + kFurther));

  EXPECT_LE(threads(), before + kPoolsMayGrow);
}

INSTANTIATE_TEST_SUITE_P(Over, RemoteFault, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

/// A network on which, on request, nothing arrives any more.
std::shared_ptr<tendon::LoopbackNetwork>& TheNetwork() {
  static auto network = std::make_shared<tendon::LoopbackNetwork>();
  return network;
}

struct FrozenPeer : RemoteConnection {
  FrozenPeer() {
    StartRobot();
    StartDesk();
    Connect();
  }
  ~FrozenPeer() override { TheNetwork()->SetFaultInjector(nullptr); }

  static void Freeze() {
    TheNetwork()->SetFaultInjector([](const auto& /*frame*/) { return tendon::loopback::kDrop; });
  }
};

TEST_P(FrozenPeer, AQueuedCallWaitsForNoReply) {
  Freeze();

  // Calls in the mailbox here, and calls that the credit of the other end allows.
  constexpr int kRoom = 64 + 64;
  int accepted = 0;
  EXPECT_TRUE(EventuallyTrue([&] {
    if (user->move_to({}) == Status(Status::kQueued)) ++accepted;
    return accepted == kRoom;
  }));

  EXPECT_EQ(user->move_to({}), Status::kQueueFull);
}

TEST_P(FrozenPeer, AReadEndsAtItsDeadlineAndDoesNotSucceedAfterwards) {
  std::uint64_t result = 0;
  ASSERT_TRUE(EventuallyTrue([&] { return bool(user->ask(result)); }));
  Freeze();
  result = 0;

  EXPECT_EQ(user->ask(result), Status::kTimeout);
  EXPECT_EQ(user->ask(result), Status::kTimeout);

  EXPECT_EQ(result, 0U);
}

INSTANTIATE_TEST_SUITE_P(Over, FrozenPeer,
                         testing::Values(NetworkKind{
                             .name = "loopback",
                             .make =
                                 [] {
                                   TheNetwork() = std::make_shared<tendon::LoopbackNetwork>();
                                   return [] {
                                     return std::make_shared<tendon::LoopbackMiddleware>(
                                         TheNetwork());
                                   };
                                 }}),
                         NameOfNetwork);

}  // namespace
