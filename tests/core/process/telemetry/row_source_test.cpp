#include <gtest/gtest.h>
#include <tendon/process/telemetry/make_telemetry_client.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/viewer_messages.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
  std::promise<PastRows> reply;

  viewer->ReadPast({"robot", "plant", "state", {"Move"}}, std::chrono::seconds(1),
                   std::make_shared<DeafSink>(),
                   [&](const PastRows& past) { reply.set_value(past); });
  const PastRows past = reply.get_future().get();

  ASSERT_TRUE(past.failure);
  EXPECT_EQ(past.failure->message,
            "process 'robot' does not know the request 'read past rows', because it runs an older "
            "version of Tendon; start it again with " +
                OwnVersion().release + " or later");
}

/// Answers the first requests for past rows with one row each. Keeps the others waiting.
class SlowReader final : public RecordingHandler {
 public:
  explicit SlowReader(std::uint64_t pages) : pages_(pages) {}

  [[nodiscard]] bool is_asked_for_more() const { return is_waiting_; }

 private:
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    if (header.type != message::kReadRows) {
      return ChannelHandler::OnRequest(channel, header, body, std::move(responder));
    }
    if (tick_ == pages_) {
      waiting_.emplace(std::move(responder));
      is_waiting_ = true;
      return;
    }
    RowBatchWriter rows({});
    rows.BeginRow(tick_, 1);
    const auto page = rows.Finish({.rows_before = tick_, .next_tick = tick_ + 1});
    ++tick_;
    responder.Reply(EncodeBody(message::ReadRowsReply{.subscribed = {.epoch = 1},
                                                      .now = 1,
                                                      .end_tick = pages_ + 1,
                                                      .rows = {page.begin(), page.end()}}));
  }

  const std::uint64_t pages_;
  std::uint64_t tick_ = 0;
  std::optional<Responder> waiting_;
  std::atomic<bool> is_waiting_{false};
};

/// Counts the rows, and those that arrive after the end of the client.
class CountingSink final : public RowSink {
 public:
  void OnSubscribed(const std::vector<Schema>& /*columns*/) override {}
  void OnRows(const RowBatch& batch) override {
    rows += batch.count;
    if (has_ended) late += batch.count;
  }
  void OnStale(const Error& /*reason*/) override {}

  std::atomic<std::uint64_t> rows{0};
  std::atomic<std::uint64_t> late{0};
  std::atomic<bool> has_ended{false};
};

/// A client that reads past rows of a process.
class PastRowsOf {
 public:
  explicit PastRowsOf(std::shared_ptr<RecordingHandler> process)
      : listener_(*middleware_.Listen(
            "127.0.0.1:0", Channel::Acceptor(HelloOf("robot"), [process] { return process; }))),
        client_(MakeTelemetryClient(
            std::make_shared<LoopbackMiddleware>(network_),
            [this](const std::string& /*process*/) {
              return Result<std::string>(listener_->address());
            },
            HelloOf("viewer"))) {
    client_->ReadPast({"robot", "plant", "state", {}}, std::chrono::seconds(1), sink,
                      [done = done](const PastRows& /*past*/) { *done = true; });
  }
  void EndClient() {
    client_.reset();
    sink->has_ended = true;
  }

  const std::shared_ptr<CountingSink> sink = std::make_shared<CountingSink>();
  const std::shared_ptr<std::atomic<bool>> done = std::make_shared<std::atomic<bool>>(false);

 private:
  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware middleware_{network_};
  std::unique_ptr<Listener> listener_;
  std::unique_ptr<TelemetryClient> client_;
};

TEST(RowSource, AReadingThatWaitsForThePeerIsForgottenWithTheClient) {
  const auto process = std::make_shared<SlowReader>(1);
  PastRowsOf reading(process);
  ASSERT_TRUE(EventuallyTrue([&] { return process->is_asked_for_more(); }));

  reading.EndClient();

  EXPECT_TRUE(EventuallyTrue([&] { return process->is_closed(); }));
  EXPECT_EQ(reading.sink->rows, 1U);
  EXPECT_FALSE(*reading.done);
}

TEST(RowSource, TheClientMayEndWhilePastRowsArrive) {
  constexpr std::uint64_t kEndless = std::uint64_t{1} << 40U;
  for (int i = 0; i < 20; ++i) {
    const auto process = std::make_shared<SlowReader>(kEndless);
    PastRowsOf reading(process);
    ASSERT_TRUE(EventuallyTrue([&] { return reading.sink->rows > 10; }));

    reading.EndClient();

    ASSERT_TRUE(EventuallyTrue([&] { return process->is_closed(); }));
    EXPECT_EQ(reading.sink->late, 0U);
    EXPECT_FALSE(*reading.done);
  }
}

}  // namespace
}  // namespace tendon
