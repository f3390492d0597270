#pragma once

#include <gtest/gtest.h>
#include <tendon/middleware/channel.h>

#include <future>

#include "conformance/kinds.h"
#include "conformance/recorder.h"
#include "conformance/requests/keeper.h"

namespace tendon::conformance {

/// A listening server and a client, for each middleware.
class Contract : public testing::TestWithParam<Kind> {
 protected:
  void Start(AcceptLink accept, Exposure exposure = Exposure::kLoopbackOnly) {
    pair_ = GetParam().make(exposure);
    auto listener = pair_.server->Listen("127.0.0.1:0", std::move(accept));
    ASSERT_TRUE(listener) << listener.error().message;
    listener_ = *std::move(listener);
  }

  Result<std::shared_ptr<Link>> Open(std::shared_ptr<LinkHandler> handler) {
    auto link = OpenUnauthenticated(std::move(handler));
    if (link) (*link)->Admit();
    return link;
  }
  Result<std::shared_ptr<Link>> OpenUnauthenticated(std::shared_ptr<LinkHandler> handler) {
    return pair_.client->Open(listener_->address(), std::move(handler), kTestTimeout);
  }

  Pair pair_;
  std::unique_ptr<Listener> listener_;
};

/// One open link, with a recorder at each end.
class LinkContract : public Contract {
 protected:
  /// `server` and `client` are called with each frame that arrives at their end.
  void Connect(Recorder::Action server = nullptr, Recorder::Action client = nullptr) {
    host_ = std::make_unique<Host>([server](const std::shared_ptr<Link>& /*link*/) {
      return std::make_shared<Recorder>(server);
    });
    Start(host_->accept());
    client_recorder_ = std::make_shared<Recorder>(std::move(client));
    auto link = Open(client_recorder_);
    ASSERT_TRUE(link) << link.error().message;
    client_ = *std::move(link);
    const auto guest = host_->guest();
    ASSERT_NE(guest.link, nullptr);
    server_ = guest.link;
    server_recorder_ = guest.recorder;
  }

  void TearDown() override {
    listener_.reset();
    pair_ = {};
  }

  std::unique_ptr<Host> host_;
  std::shared_ptr<Link> client_;
  std::shared_ptr<Link> server_;
  std::shared_ptr<Recorder> client_recorder_;
  std::shared_ptr<Recorder> server_recorder_;
};

class AddressContract : public Contract {};
class LifetimeContract : public Contract {};
/// Tests for kinds that are not always encrypted.
class ExposureContract : public Contract {};
/// Tests for kinds whose ports unauthenticated programs can reach, and whose programs can be
/// killed.
class PortContract : public Contract {
 protected:
  /// Opens `link_`, and waits until `guest_` at the other end has received a frame.
  void Meet(Host& host, std::shared_ptr<Recorder> opener = std::make_shared<Recorder>()) {
    Start(host.accept());
    auto link = Open(std::move(opener));
    ASSERT_TRUE(link) << link.error().message;
    link_ = *std::move(link);
    ASSERT_EQ(link_->Send(FrameOf(1)), Status::kQueued);
    guest_ = host.guest();
    ASSERT_NE(guest_.link, nullptr);
    ASSERT_TRUE(guest_.recorder->WaitForFrames(1));
  }

  std::shared_ptr<Link> link_;
  Host::Guest guest_;
};

/// A client, and a server that defers its replies; for middlewares with a direct path for replies.
class LaterReplyContract : public Contract {
 protected:
  void SetUp() override {
    std::promise<std::shared_ptr<Keeper>> asked;
    Start([&asked](const std::shared_ptr<Link>& link) {
      auto handler = std::make_shared<Keeper>(link);
      asked.set_value(handler);
      return handler;
    });
    auto link = Open(recorder_);
    ASSERT_TRUE(link) << link.error().message;
    asker_ = *std::move(link);
    keeper_ = asked.get_future().get();
  }
  void TearDown() override { End(); }

  void End() {
    listener_.reset();
    pair_ = {};
  }
  std::unique_ptr<ReplySlot> Ask() {
    EXPECT_EQ(asker_->Send(FrameOf(1), Delivery::kDirect), Status(Status::kQueued));
    return keeper_->Take();
  }

  std::shared_ptr<Recorder> recorder_ = std::make_shared<Recorder>();
  std::shared_ptr<Keeper> keeper_;
  std::shared_ptr<Link> asker_;
};

/// Tests for kinds whose messages are exactly frames. tests/core/ice has the same tests for the
/// messages of Ice.
class UnfinishedContract : public PortContract {};

/// Two channels after the handshake, unless the test does the handshake itself.
class ChannelContract : public Contract {
 protected:
  static constexpr std::uint64_t kCookie = 4711;

  static Hello HelloOf(const std::string& name) {
    Hello hello;
    hello.name = name;
    hello.instance = name.size();
    hello.cookie = kCookie;
    return hello;
  }

  void Connect(const std::shared_ptr<ChannelHandler>& server,
               const std::shared_ptr<ChannelHandler>& client) {
    Start(Channel::Acceptor(HelloOf("robot"), [server] { return server; }));
    auto channel =
        Channel::Open(*pair_.client, listener_->address(), HelloOf("desk"), client, kTestTimeout);
    ASSERT_TRUE(channel) << channel.error().message;
    channel_ = *std::move(channel);
  }

  void TearDown() override {
    listener_.reset();
    pair_ = {};
  }

  std::shared_ptr<Channel> channel_;
};

class LargeMessageContract : public ChannelContract {};
/// Tests for kinds whose ends authenticate by the cookie.
class CookieContract : public ChannelContract {};

inline std::string NameOfKind(const testing::TestParamInfo<Kind>& info) { return info.param.name; }

}  // namespace tendon::conformance
