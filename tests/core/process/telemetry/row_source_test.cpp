#include <gtest/gtest.h>
#include <tendon/process/telemetry/make_telemetry_client.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/viewer_messages.h>

#include <chrono>
#include <future>
#include <memory>
#include <string>

#include "core/process/telemetry/recording_handler.h"
#include "support/wait.h"

namespace tendon {
namespace {

/// Answers every subscription with one column too few.
class Confused final : public RecordingHandler {
 public:
  static constexpr std::uint32_t kHandle = 5;

 private:
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    if (header.type != message::kSubscribe) {
      return ChannelHandler::OnRequest(channel, header, body, std::move(responder));
    }
    responder.Reply(EncodeBody(message::SubscribeReply{.handle = kHandle, .epoch = 1}));
  }
};

/// Sends rows, but never answers the subscription.
class Forgotten final : public RecordingHandler {
 public:
  static constexpr std::uint32_t kHandle = 6;

 private:
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    if (header.type != message::kSubscribe) {
      return ChannelHandler::OnRequest(channel, header, body, std::move(responder));
    }
    RowBatchWriter rows({});
    EXPECT_TRUE(channel->Notify(message::kRows, kHandle, rows.Finish({})));
  }
};

class DeafSink final : public RowSink {
 public:
  void OnSubscribed(const std::vector<Schema>& /*columns*/) override {}
  void OnRows(const RowBatch& /*batch*/) override {}
  void OnStale(const Error& /*reason*/) override {}
};

/// Returns true if a viewer ends a subscription about which `process` sends something wrong.
template <typename Process>
bool EndsThere(const std::shared_ptr<Process>& process) {
  const auto network = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware middleware(network);
  const auto listener = *middleware.Listen(
      "127.0.0.1:0", Channel::Acceptor(HelloOf("robot"), [&] { return process; }));
  const auto viewer = MakeTelemetryClient(
      std::make_shared<LoopbackMiddleware>(network),
      [&](const std::string& /*process*/) { return Result<std::string>(listener->address()); },
      HelloOf("viewer"));

  viewer->Subscribe({"robot", "plant", "state", {"Move"}}, std::make_shared<DeafSink>());

  return EventuallyTrue([&] { return process->HasHeard(message::kUnsubscribe, Process::kHandle); });
}

TEST(RowSource, EndsASubscriptionAfterAnInvalidReply) {
  EXPECT_TRUE(EndsThere(std::make_shared<Confused>()));
}

TEST(RowSource, EndsASubscriptionAfterAMissingReply) {
  EXPECT_TRUE(EndsThere(std::make_shared<Forgotten>()));
}

/// A process that is too old for past rows.
class Older final : public RecordingHandler {};

TEST(RowSource, SaysThatAProcessIsTooOldForPastRows) {
  const auto network = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware middleware(network);
  const auto listener = *middleware.Listen(
      "127.0.0.1:0", Channel::Acceptor(HelloOf("robot"), [] { return std::make_shared<Older>(); }));
  const auto viewer = MakeTelemetryClient(
      std::make_shared<LoopbackMiddleware>(network),
      [&](const std::string& /*process*/) { return Result<std::string>(listener->address()); },
      HelloOf("viewer"));
  std::promise<PastRows> answer;

  viewer->ReadPast({"robot", "plant", "state", {"Move"}}, std::chrono::seconds(1),
                   std::make_shared<DeafSink>(),
                   [&](const PastRows& past) { answer.set_value(past); });
  const PastRows past = answer.get_future().get();

  ASSERT_TRUE(past.failure);
  EXPECT_EQ(past.failure->message,
            "process 'robot' does not know the request 'read past rows', because it runs an older "
            "version of Tendon; start it again with " +
                OwnVersion().release + " or later");
}

}  // namespace
}  // namespace tendon
