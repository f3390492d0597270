#include <tests/core/gcm/gcm_fixture.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <span>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class NoEvents final : public EventSink {
 public:
  void OnListening(const std::vector<MemberDescription>& /*events*/) override {}
  void OnEvent(std::size_t /*event*/, std::span<const std::byte> /*value*/,
               const EventTime& /*time*/) override {}
  void OnEventsLost(std::size_t /*event*/, std::uint64_t /*lost*/) override {}
  void OnStale(const Error& /*reason*/) override {}
};

class PastEventsOfAClient : public test::GcmFixture {};

INSTANTIATE_TEST_SUITE_P(Over, PastEventsOfAClient, testing::Values("loopback", "tcp"),
                         [](const auto& one) { return one.param; });

TEST_P(PastEventsOfAClient, AReadingThatWaitsForTheProcessIsForgottenWithTheClient) {
  ComponentDescription arm = test::Arm();
  arm.provided[0].events = {{.name = "Moved",
                             .signature = SignatureOf<double, None>(CommandKind::kWrite),
                             .in_type = "float64"}};
  const auto robot = Join("robot", {arm});
  auto client = Watch();
  const auto is_done = std::make_shared<std::atomic<bool>>(false);
  client->ReadPastEvents({.provided = test::kControl, .events = {"Moved"}}, 30s,
                         std::make_shared<NoEvents>(),
                         [is_done](const PastEvents& /*past*/) { *is_done = true; });
  ASSERT_TRUE(EventuallyTrue([&] { return robot->waiting_readers() > 0; }));

  client.reset();

  EXPECT_FALSE(*is_done);
}

}  // namespace
}  // namespace tendon
