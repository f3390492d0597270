#include <gtest/gtest.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/heartbeat.h>

#include <future>
#include <memory>

#include "support/wait.h"

namespace {

using tendon::Bytes;
using tendon::Channel;
using tendon::ChannelHandler;
using tendon::Hello;

constexpr std::chrono::seconds kTestTimeout(120);

/// Stores each request.
class Silent final : public ChannelHandler {
 public:
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const tendon::FrameHeader& /*header*/,
                 std::span<const std::byte> /*body*/, tendon::Responder responder) override {
    kept_.push_back(std::move(responder));
  }

 private:
  std::vector<tendon::Responder> kept_;
};

class Accepting final : public ChannelHandler {
 public:
  void OnOpen(const std::shared_ptr<Channel>& channel, const Hello& /*peer*/) override {
    opened.set_value(channel);
  }

  std::promise<std::shared_ptr<Channel>> opened;
};

TEST(KeepExpiring, ExpiresRequestsOnAnIdleChannel) {
  const auto network = std::make_shared<tendon::LoopbackNetwork>();
  tendon::LoopbackMiddleware server(network);
  tendon::LoopbackMiddleware client(network);
  const Hello hello{.instance = 1, .name = "robot", .cookie = 7};
  const auto accepting = std::make_shared<Accepting>();
  const auto listener =
      server.Listen("127.0.0.1:0", Channel::Acceptor(hello, [&] { return accepting; }));
  ASSERT_TRUE(listener.ok());
  const auto opened = Channel::Open(client, (*listener)->address(), hello,
                                    std::make_shared<Silent>(), kTestTimeout);
  ASSERT_TRUE(opened.ok());
  const auto channel = accepting->opened.get_future().get();
  tendon::Worker worker("keeper");
  std::promise<tendon::Result<Bytes>> outcome;

  channel->Request(static_cast<tendon::MessageType>(0x101), 0, Bytes(),
                   std::chrono::milliseconds(1),
                   [&](tendon::Result<Bytes> reply) { outcome.set_value(std::move(reply)); });
  KeepExpiring(worker, channel);

  auto ended = outcome.get_future();
  ASSERT_EQ(ended.wait_for(kTestTimeout), std::future_status::ready);
  EXPECT_EQ(ended.get().error().code, tendon::ErrorCode::kTimeout);
  worker.Stop();
}

}  // namespace
