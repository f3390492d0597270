#include <poll.h>
#include <tendon/base/os/socket.h>
#include <tendon/middleware/connect_cancellation.h>

#include <future>
#include <optional>

#include "conformance/contract.h"
#include "conformance/oracle.h"

namespace tendon::conformance {
namespace {

constexpr auto kMuchLonger = 4 * kTestTimeout;  // longer than the test waits

/// Receives requests, and never answers.
class Mute final : public LinkHandler {
 public:
  explicit Mute(std::promise<void> heard) : heard_(std::move(heard)) {}
  void OnFrame(std::span<const std::byte> /*frame*/) override { heard_.set_value(); }
  void OnClosed(const Error& /*reason*/) override {}

 private:
  std::promise<void> heard_;
};

TEST_P(ChannelContract, ProgramExitCancelsAPendingHandshake) {
  std::promise<void> promise;
  auto heard = promise.get_future();
  Start([mute = std::make_shared<Mute>(std::move(promise))](const auto& /*link*/) { return mute; });
  const auto open = [this] {
    return Channel::Open(*pair_.client, listener_->address(), HelloOf("desk"),
                         std::make_shared<Oracle>(), kMuchLonger);
  };
  auto opening = std::async(std::launch::async, open);
  ASSERT_EQ(heard.wait_for(kTestTimeout), std::future_status::ready);

  const ConnectCancellation end;

  ASSERT_EQ(opening.wait_for(kTestTimeout), std::future_status::ready);
  const auto opened = opening.get();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::kUnreachable);
  EXPECT_EQ(opened.error().message, ConnectCancelledError().message);
}

/// The listener accepts nothing, like a stopped process: the kernel accepts the connection, but no
/// program reads it.
TEST_P(PortContract, ProgramExitCancelsOpeningALinkToAHungPeer) {
  const auto hanging = os::ListenAt("127.0.0.1", 0);
  ASSERT_TRUE(hanging);
  const std::string address = os::LocalAddress(*hanging);
  pair_ = GetParam().make(Exposure::kLoopbackOnly);
  Hello hello;
  hello.name = "desk";
  auto opening = std::async(std::launch::async, [&] {
    return Channel::Open(*pair_.client, address, hello, std::make_shared<Oracle>(), kMuchLonger);
  });
  pollfd come{hanging->descriptor(), POLLIN, 0};
  ASSERT_EQ(poll(&come, 1, static_cast<int>(std::chrono::milliseconds(kTestTimeout).count())), 1);

  std::optional<ConnectCancellation> end(std::in_place);

  ASSERT_EQ(opening.wait_for(kTestTimeout), std::future_status::ready);
  const auto opened = opening.get();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().message, ConnectCancelledError().message);
  pair_ = {};
  end.reset();
  EXPECT_FALSE(AreConnectsCancelled());
}

}  // namespace
}  // namespace tendon::conformance
