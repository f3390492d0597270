#include <gtest/gtest.h>
#include <tendon/process/messages.h>
#include <tendon/process/telemetry_client.h>

#include "core/process/telemetry/listening.h"
#include "support/wait.h"

namespace tendon {
namespace {

/// Answers every subscription with a column too few.
class Confused final : public Listening {
 public:
  static constexpr std::uint32_t kHandle = 5;

 private:
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    if (header.type != message::kSubscribe) {
      return ChannelHandler::OnRequest(channel, header, body, std::move(responder));
    }
    responder.Reply(EncodeBody(message::Subscribed{.handle = kHandle, .epoch = 1}));
  }
};

class DeafSink final : public RowSink {
 public:
  void OnSubscribed(const std::vector<Schema>& /*columns*/) override {}
  std::size_t OnRows(const RowBatch& /*batch*/) override { return 0; }
  void OnStale(const Error& /*reason*/) override {}
};

TEST(RowSource, ASubscriptionWhoseAnswerMakesNoSenseIsEndedThere) {
  const auto network = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware process(network);
  const auto confused = std::make_shared<Confused>();
  const auto listener =
      *process.Listen("127.0.0.1:0", Channel::Acceptor(HelloOf("robot"), [&] { return confused; }));
  const auto viewer = MakeTelemetryClient(
      std::make_shared<LoopbackMiddleware>(network),
      [&](const std::string& /*process*/) { return Result<std::string>(listener->address()); },
      HelloOf("viewer"));

  viewer->Subscribe({"robot", "plant", "state", {"Move"}}, std::make_shared<DeafSink>());

  EXPECT_TRUE(
      EventuallyTrue([&] { return confused->HasHeard(message::kUnsubscribe, Confused::kHandle); }));
}

}  // namespace
}  // namespace tendon
