#include <gtest/gtest.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/telemetry/row_source.h>
#include <tendon/process/telemetry/table_feed.h>

#include <future>
#include <memory>
#include <mutex>
#include <vector>

#include "support/wait.h"

namespace tendon {
namespace {

constexpr std::chrono::seconds kPatience(20);

Hello HelloOf(const std::string& name) { return {.instance = 1, .name = name, .cookie = 4711}; }

/// One end of a channel that notes down what it hears.
class Listening : public ChannelHandler {
 public:
  void OnOpen(const std::shared_ptr<Channel>& opened, const Hello& /*peer*/) override {
    channel_.set_value(opened);
  }
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> /*body*/) override {
    const std::scoped_lock held(gate);
    const std::scoped_lock lock(mutex_);
    notices_.push_back(header);
  }
  void OnClosed(const std::shared_ptr<Channel>& /*channel*/, const Error& /*reason*/) override {
    const std::scoped_lock lock(mutex_);
    is_closed_ = true;
  }

  std::shared_ptr<Channel> channel() { return channel_.get_future().get(); }
  bool HasHeard(MessageType type, std::uint32_t handle) const {
    const std::scoped_lock lock(mutex_);
    return std::any_of(notices_.begin(), notices_.end(), [&](const FrameHeader& one) {
      return one.type == type && one.handle == handle;
    });
  }
  bool is_closed() const {
    const std::scoped_lock lock(mutex_);
    return is_closed_;
  }

  std::mutex gate;  ///< whoever brings notices waits while it is locked

 private:
  std::promise<std::shared_ptr<Channel>> channel_;
  mutable std::mutex mutex_;
  std::vector<FrameHeader> notices_;
  bool is_closed_ = false;
};

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
  void OnRows(const RowBatch& /*batch*/) override {}
  void OnStale(const Error& /*reason*/) override {}
};

TEST(TableFeed, ItsEndIsHeardAlsoByAViewerWhoseLinkIsFull) {
  const auto network = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware process(network);
  LoopbackMiddleware viewer(network);
  const auto feeding = std::make_shared<Listening>();
  const auto viewing = std::make_shared<Listening>();
  const auto listener =
      *process.Listen("127.0.0.1:0", Channel::Acceptor(HelloOf("robot"), [&] { return feeding; }));
  const auto opened =
      Channel::Open(viewer, listener->address(), HelloOf("viewer"), viewing, kPatience);
  ASSERT_TRUE(opened) << opened.error().message;
  const auto channel = feeding->channel();
  const StateTable table;
  TableFeed feed("camera", table, {});
  feed.Add(channel, 3);
  {
    const std::scoped_lock held(viewing->gate);
    for (const std::size_t size : {std::size_t{1} << 20U, std::size_t{1} << 10U, std::size_t{0}}) {
      while (channel->Notify(message::kRows, 3, Bytes(size))) {
      }
    }

    feed.End({ErrorCode::kNotFound, "the camera was removed"});
  }

  EXPECT_TRUE(EventuallyTrue(
      [&] { return viewing->HasHeard(message::kRowsEnded, 3) || viewing->is_closed(); }));
}

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
