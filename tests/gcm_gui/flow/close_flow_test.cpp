#include <gmock/gmock.h>
#include <program/network_options.h>
#include <tendon/base/path.h>
#include <tendon/middleware/connect_cancellation.h>
#include <tendon/middleware/middleware.h>

#include <csignal>
#include <fstream>
#include <optional>
#include <sstream>

#include "flow/flow_fixture.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

/// Closes a window while it is busy.
class CloseFlow : public FlowFixture {
 protected:
  /// Returns the number of connections of this machine to this port, counted at the opener's end.
  [[nodiscard]] static int ConnectionsTo(const std::string& address) {
    const auto place = ParseAddress(address, 1);
    if (!place) return -1;
    std::ostringstream wanted;
    wanted << std::hex << std::uppercase << place->port;
    int found = 0;
    std::ifstream all("/proc/net/tcp");
    for (std::string line; std::getline(all, line);) {
      std::istringstream words(line);
      std::string number, local, remote, state;
      words >> number >> local >> remote >> state;
      const std::string port = remote.substr(std::min(remote.find(':') + 1, remote.size()));
      if (port == wanted.str() && state == "01") ++found;
    }
    return found;
  }
};

TEST_F(CloseFlow, AHangingProcessDoesNotBlockClosing) {
  const ProcessDescription robot =
      // The last known state before it was stopped.
      session_->store().catalogue().FindProcess("robot")->process;
  std::optional<Result<std::string>> reply;  // outlives the session, which fills it
  // The time-out is longer than the test, so a wait for the handshake would make the test fail.
  auto session = std::make_unique<GcmSession>(*program::MakeMiddleware({}), address_, false,
                                              Role::kOperator, 10min);
  ASSERT_TRUE(Eventually([&] { return session->link().state() == LinkState::State::kConnected; }));
  robot_->Signal(SIGSTOP);
  const int before = ConnectionsTo(robot.address);
  ASSERT_GE(before, 0);

  session->readValue("robot/arm/Control.GetJoints", [&](const auto& heard) { reply = heard; });
  session->liveSignals().subscribe("robot/arm/state.Joints.position[0]");
  ASSERT_TRUE(Eventually([&] { return ConnectionsTo(robot.address) > before + 1; }))
      << before << " before, now " << ConnectionsTo(robot.address);
  const ConnectCancellation end;  // the program does the same after its window is closed

  ASSERT_TRUE(Eventually([&] { return reply.has_value(); }));
  ASSERT_FALSE(*reply);
  EXPECT_THAT(reply->error().message, testing::HasSubstr(ConnectCancelledError().message))
      << "it was waited for all the same";
  session.reset();
  robot_->Signal(SIGCONT);
}

}  // namespace
}  // namespace tendon::gui
