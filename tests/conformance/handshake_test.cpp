#include <algorithm>
#include <future>

#include "conformance/contract.h"
#include "conformance/oracle.h"
#include "support/record.h"

namespace tendon::conformance {
namespace {

const std::string kOurs = (FrameHeader::kOldestVersion < FrameHeader::kProtocolVersion
                               ? std::to_string(FrameHeader::kOldestVersion) + "-"
                               : "") +
                          std::to_string(FrameHeader::kProtocolVersion);
constexpr std::uint16_t kNewer = FrameHeader::kProtocolVersion + 1;
const std::string kNewerText = std::to_string(kNewer);

/// The same of one that speaks this protocol version alone.
Hello Speaking(Hello hello, std::uint16_t version) {
  hello.protocol_version = hello.oldest_version = version;
  return hello;
}

TEST_P(ChannelContract, TheNewestVersionThatBothSpeakIsSpoken) {
  constexpr std::size_t kLarge = std::size_t{600} << 10U;
  for (const std::uint16_t openers : {FrameHeader::kProtocolVersion, FrameHeader::kOldestVersion}) {
    for (const std::uint16_t acceptors :
         {FrameHeader::kProtocolVersion, FrameHeader::kOldestVersion}) {
      Hello robot = HelloOf("robot");
      robot.protocol_version = acceptors;
      Hello desk = HelloOf("desk");
      desk.protocol_version = openers;
      Start(Channel::Acceptor(robot, [] { return std::make_shared<Oracle>(); }));
      const auto channel = Channel::Open(*pair_.client, listener_->address(), desk,
                                         std::make_shared<Oracle>(), kPatience);
      ASSERT_TRUE(channel) << channel.error().message;

      EXPECT_EQ((*channel)->protocol_version(), std::min(openers, acceptors));
      for (const std::size_t size : {std::size_t{1}, kLarge}) {  // whole, and in parts
        const auto reply = (*channel)->Call<Question>(
            kAsk, 1, Question{.text = std::string(size, 'x')}, kPatience);
        ASSERT_TRUE(reply) << reply.error().message;
        EXPECT_EQ(reply->text.size(), 2 * size);
      }
      (*channel)->Close();
      listener_.reset();
    }
  }
}

TEST_P(ChannelContract, AnotherProtocolVersionIsRefusedWithWhomToUpdate) {
  Start(Channel::Acceptor(HelloOf("robot"), [] { return std::make_shared<Oracle>(); }));
  const Hello newer = Speaking(HelloOf("desk"), kNewer);
  const auto client = std::make_shared<Oracle>();

  const auto channel = Channel::Open(*pair_.client, listener_->address(), newer, client, kPatience);

  ASSERT_FALSE(channel);
  EXPECT_EQ(channel.error().code, ErrorCode::kIncompatible);
  EXPECT_EQ(channel.error().message,
            "robot speaks protocol " + kOurs + ", this program " + kNewerText + ": update robot");
  ASSERT_TRUE(client->Wait([](const Oracle& oracle) { return !oracle.closed_.empty(); }));
  EXPECT_EQ(client->closed_.size(), 1U);
  EXPECT_EQ(client->peer_, "");
}

TEST_P(ChannelContract, AnOlderProgramIsToldToUpdateItself) {
  const Hello newer = Speaking(HelloOf("robot"), kNewer);
  Start(Channel::Acceptor(newer, [] { return std::make_shared<Oracle>(); }));

  const auto channel = Channel::Open(*pair_.client, listener_->address(), HelloOf("desk"),
                                     std::make_shared<Oracle>(), kPatience);

  ASSERT_FALSE(channel);
  EXPECT_EQ(channel.error().message, "robot speaks protocol " + kNewerText + ", this program " +
                                         kOurs + ": update this program");
}

TEST_P(CookieContract, AWrongCookieIsDeniedAndNoOpenIsHeard) {
  const auto server = std::make_shared<Oracle>();
  Start(Channel::Acceptor(HelloOf("robot"), [server] { return server; }));
  for (const std::uint64_t cookie : {std::uint64_t{0}, kCookie + 1}) {
    Hello hello = HelloOf("desk");
    hello.cookie = cookie;

    const auto channel = Channel::Open(*pair_.client, listener_->address(), hello,
                                       std::make_shared<Oracle>(), kPatience);

    ASSERT_FALSE(channel) << cookie;
    EXPECT_EQ(channel.error().code, ErrorCode::kDenied);
    EXPECT_EQ(channel.error().message,
              "robot does not know 'desk': both must run as the same user of this machine");
  }
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.closed_.size() == 2; }));
  EXPECT_EQ(server->peer_, "");
}

/// Which of `frames` hold the cookie.
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
      Bytes answer;
      WriteFrame(header, body, answer);
      (void)link->Send(answer);
    });
  });
  Start(impostor.accept());

  const auto channel = Channel::Open(*pair_.client, listener_->address(), HelloOf("desk"),
                                     std::make_shared<Oracle>(), kPatience);

  ASSERT_FALSE(channel);
  EXPECT_EQ(channel.error().code, ErrorCode::kDenied);
  EXPECT_TRUE(impostor.guest().recorder->WaitForClosed());
  EXPECT_EQ(heard.size(), 1U) << "a Hello and no proof";
  EXPECT_EQ(CountOfCookie(heard.values(), kCookie), 0U);
}

TEST_P(CookieContract, WhoPassesOnWhatOthersSayIsDenied) {
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
                                     std::make_shared<Oracle>(), kPatience);

  ASSERT_FALSE(channel);
  EXPECT_EQ(channel.error().code, ErrorCode::kDenied);
  (*to_robot)->Close();
  ASSERT_TRUE(robot->Wait([](const Oracle& oracle) { return oracle.closed_.size() == 1; }));
  EXPECT_EQ(robot->peer_, "");
}

TEST_P(ChannelContract, StrangersAreLetInWhereTheAcceptorSaysSo) {
  Start(Channel::Acceptor(
      HelloOf("robot"), [] { return std::make_shared<Oracle>(); }, Strangers::kAllowed));
  Hello hello = HelloOf("desk");
  hello.cookie = 0;

  const auto channel = Channel::Open(*pair_.client, listener_->address(), hello,
                                     std::make_shared<Oracle>(), kPatience);

  EXPECT_TRUE(channel) << channel.error().message;
}

TEST_P(ChannelContract, ALinkThatBeginsWithSomethingElseIsClosed) {
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
