#include <algorithm>
#include <future>
#include <utility>

#include "conformance/contract.h"
#include "conformance/oracle.h"
#include "support/record.h"

namespace tendon::conformance {
namespace {

constexpr std::uint16_t kOurs = FrameHeader::kProtocolVersion;
constexpr std::uint16_t kOlder = kOurs - 1;
constexpr std::uint16_t kNewer = kOurs + 1;
const std::string kOursText = std::to_string(kOurs);

/// Returns a frame of a program with another protocol version. Its body cannot be decoded.
Bytes FrameOfVersion(std::uint16_t version, MessageType type) {
  constexpr std::uint32_t kSize = 5;
  Bytes frame;
  WriteFrame({.version = version, .type = type, .request = 1, .size = kSize}, Bytes(kSize), frame);
  return frame;
}

TEST_P(ChannelContract, ARefusedOpenerVersionSaysWhichProgramToUpdate) {
  const auto server = std::make_shared<Oracle>();
  Start(Channel::Acceptor(HelloOf("robot"), [server] { return server; }));
  for (const auto& [version, outdated] :
       {std::pair<std::uint16_t, std::string>{kOlder, "this program"}, {kNewer, "robot"}}) {
    const auto reply = std::make_shared<Bytes>();
    const auto recorder = std::make_shared<Recorder>(
        [reply](std::span<const std::byte> frame) { reply->assign(frame.begin(), frame.end()); });
    const auto link = Open(recorder);
    ASSERT_TRUE(link) << link.error().message;

    ASSERT_EQ((*link)->Send(FrameOfVersion(version, MessageType::kHello)), Status::kQueued);

    ASSERT_TRUE(recorder->WaitForFrames(1));
    EXPECT_TRUE(recorder->WaitForClosed());
    EXPECT_EQ(ReadWholeFrame(*reply)->type, MessageType::kRefusal);
    EXPECT_EQ(
        ReadRefusal(std::span(*reply).subspan(FrameHeader::kSize), "robot"),
        (Error{ErrorCode::kIncompatible, "robot speaks protocol version " + kOursText +
                                             ", but this program speaks version " +
                                             std::to_string(version) + ": update " + outdated}));
  }
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.closed_.size() == 2; }));
  EXPECT_EQ(server->peer_, "");
}

TEST_P(ChannelContract, ARefusedAcceptorVersionSaysWhichProgramToUpdate) {
  for (const std::uint16_t version : {kOlder, kNewer}) {
    Host host([version](const std::shared_ptr<Link>& accepted) {
      return std::make_shared<Recorder>(
          [version, link = std::weak_ptr(accepted)](std::span<const std::byte> /*frame*/) {
            const auto open = link.lock();
            if (open) (void)open->Send(FrameOfVersion(version, MessageType::kChallenge));
          });
    });
    Start(host.accept());
    const auto client = std::make_shared<Oracle>();

    const auto channel =
        Channel::Open(*pair_.client, listener_->address(), HelloOf("desk"), client, kTestTimeout);

    ASSERT_FALSE(channel);
    EXPECT_EQ(channel.error().code, ErrorCode::kIncompatible);
    EXPECT_EQ(channel.error().message,
              listener_->address() + " speaks protocol version " + std::to_string(version) +
                  ", but this program speaks version " + kOursText + ": update " +
                  (version == kNewer ? "this program" : listener_->address()));
    ASSERT_TRUE(client->Wait([](const Oracle& oracle) { return !oracle.closed_.empty(); }));
    EXPECT_EQ(client->closed_.size(), 1U);
    EXPECT_EQ(client->peer_, "");
    listener_.reset();
  }
}

TEST_P(CookieContract, AWrongCookieIsDeniedWithoutAnOpenEvent) {
  const auto server = std::make_shared<Oracle>();
  Start(Channel::Acceptor(HelloOf("robot"), [server] { return server; }));
  for (const std::uint64_t cookie : {std::uint64_t{0}, kCookie + 1}) {
    Hello hello = HelloOf("desk");
    hello.cookie = cookie;

    const auto channel = Channel::Open(*pair_.client, listener_->address(), hello,
                                       std::make_shared<Oracle>(), kTestTimeout);

    ASSERT_FALSE(channel) << cookie;
    EXPECT_EQ(channel.error().code, ErrorCode::kDenied);
    EXPECT_EQ(channel.error().message,
              "robot does not know 'desk': both must run as the same user of this machine");
  }
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.closed_.size() == 2; }));
  EXPECT_EQ(server->peer_, "");
}

/// Returns how many of `frames` contain the cookie.
std::size_t CountOfCookie(const std::vector<Bytes>& frames, std::uint64_t cookie) {
  const auto wanted = std::as_bytes(std::span(&cookie, 1));
  return static_cast<std::size_t>(
      std::count_if(frames.begin(), frames.end(), [&](const Bytes& one) {
        return std::search(one.begin(), one.end(), wanted.begin(), wanted.end()) != one.end();
      }));
}

TEST_P(CookieContract, AnImpostorAtThePortIsDeniedAndLearnsNothing) {
  test::Record<Bytes> heard;
  Host impostor([&](const std::shared_ptr<Link>& link) {
    return std::make_shared<Recorder>([&, link](std::span<const std::byte> frame) {
      heard.Add({frame.begin(), frame.end()});
      message::Challenge challenge;
      challenge.greeting.name = "robot";
      challenge.proof.fill(7);
      const Bytes body = EncodeBody(challenge);
      FrameHeader header{.type = MessageType::kChallenge, .request = 1};
      header.size = static_cast<std::uint32_t>(body.size());
      Bytes reply;
      WriteFrame(header, body, reply);
      (void)link->Send(reply);
    });
  });
  Start(impostor.accept());

  const auto channel = Channel::Open(*pair_.client, listener_->address(), HelloOf("desk"),
                                     std::make_shared<Oracle>(), kTestTimeout);

  ASSERT_FALSE(channel);
  EXPECT_EQ(channel.error().code, ErrorCode::kDenied);
  EXPECT_TRUE(impostor.guest().recorder->WaitForClosed());
  EXPECT_EQ(heard.size(), 1U) << "a Hello and no proof";
  EXPECT_EQ(CountOfCookie(heard.values(), kCookie), 0U);
}

TEST_P(CookieContract, ARelayedHandshakeIsDenied) {
  const auto robot = std::make_shared<Oracle>();
  Start(Channel::Acceptor(HelloOf("robot"), [robot] { return robot; }));
  std::promise<std::shared_ptr<Link>> to_desk;
  const auto desk = to_desk.get_future().share();
  const auto to_robot = Open(std::make_shared<Recorder>(
      [&](std::span<const std::byte> frame) { (void)desk.get()->Send(frame); }));
  ASSERT_TRUE(to_robot);
  const auto relay = pair_.server->Listen("127.0.0.1:0", [&](const std::shared_ptr<Link>& link) {
    to_desk.set_value(link);
    return std::make_shared<Recorder>(
        [&](std::span<const std::byte> frame) { (void)(*to_robot)->Send(frame); });
  });
  ASSERT_TRUE(relay);

  const auto channel = Channel::Open(*pair_.client, (*relay)->address(), HelloOf("desk"),
                                     std::make_shared<Oracle>(), kTestTimeout);

  ASSERT_FALSE(channel);
  EXPECT_EQ(channel.error().code, ErrorCode::kDenied);
  (*to_robot)->Close();
  ASSERT_TRUE(robot->Wait([](const Oracle& oracle) { return oracle.closed_.size() == 1; }));
  EXPECT_EQ(robot->peer_, "");
}

TEST_P(ChannelContract, AcceptsUnauthenticatedPeersIfAllowed) {
  Start(Channel::Acceptor(
      HelloOf("robot"), [] { return std::make_shared<Oracle>(); }, UnauthenticatedPeers::kAllowed));
  Hello hello = HelloOf("desk");
  hello.cookie = 0;

  const auto channel = Channel::Open(*pair_.client, listener_->address(), hello,
                                     std::make_shared<Oracle>(), kTestTimeout);

  EXPECT_TRUE(channel) << channel.error().message;
}

TEST_P(ChannelContract, ClosesALinkThatDoesNotBeginWithHello) {
  const auto server = std::make_shared<Oracle>();
  Start(Channel::Acceptor(HelloOf("robot"), [server] { return server; }));
  const auto recorder = std::make_shared<Recorder>();
  const auto link = Open(recorder);
  ASSERT_TRUE(link);

  ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);

  EXPECT_TRUE(recorder->WaitForClosed());
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.closed_.size() == 1; }));
  EXPECT_EQ(server->peer_, "");
}

TEST_P(ChannelContract, AnAcceptorThatNeverAnswersTimesOut) {
  Host mute;
  Start(mute.accept());

  const auto channel = Channel::Open(*pair_.client, listener_->address(), HelloOf("desk"),
                                     std::make_shared<Oracle>(), std::chrono::milliseconds(200));

  ASSERT_FALSE(channel);
  EXPECT_EQ(channel.error().code, ErrorCode::kTimeout);
}

}  // namespace
}  // namespace tendon::conformance
