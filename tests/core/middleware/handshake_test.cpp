#include <gtest/gtest.h>
#include <tendon/middleware/handshake.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

using message::Challenge;
using message::Proof;

constexpr std::uint64_t kCookie = 4711;

Hello HelloOf(const std::string& name, std::uint64_t cookie = kCookie) {
  return {.instance = 3, .name = name, .session = name == "desk" ? 99U : 0U, .cookie = cookie};
}

constexpr std::uint16_t kOurs = FrameHeader::kProtocolVersion;
constexpr std::uint16_t kOlder = kOurs - 1;
constexpr std::uint16_t kNewer = kOurs + 1;
const std::string kOursText = std::to_string(kOurs);
const std::string kOlderText = std::to_string(kOlder);
const std::string kNewerText = std::to_string(kNewer);

FrameHeader HeaderOf(MessageType type, std::uint16_t version = kOurs) {
  FrameHeader header;
  header.type = type;
  header.version = version;
  header.request = 1;
  return header;
}

/// Both ends of a link, and the messages between them.
struct Talk {
  explicit Talk(Hello one = HelloOf("desk"), Hello other = HelloOf("robot"),
                UnauthenticatedPeers unauthenticated = UnauthenticatedPeers::kRefused,
                const std::string& seen = "127.0.0.1:10705")
      : opener(Handshake::Role::kOpener, std::move(one), seen, UnauthenticatedPeers::kRefused),
        acceptor(Handshake::Role::kAcceptor, std::move(other), "127.0.0.1:10705", unauthenticated) {
  }

  Result<Handshake::Step> Hear(MessageType type, const Bytes& body) {
    return acceptor.Take(HeaderOf(type), body);
  }
  Result<Handshake::Step> Answer(const Handshake::Step& step) {
    return opener.Take(HeaderOf(step.type), step.body);
  }
  /// Returns the Hello of the peer that the acceptor admits.
  Result<Hello> Run() {
    const auto challenge = Hear(MessageType::kHello, opener.Greet());
    if (!challenge) return challenge.error();
    const auto proof = Answer(*challenge);
    if (!proof) return proof.error();
    const auto welcome = Hear(proof->type, proof->body);
    if (!welcome) return welcome.error();
    const auto end = Answer(*welcome);
    if (!end) return end.error();
    robot = *end->peer;
    return *welcome->peer;
  }

  Handshake opener;
  Handshake acceptor;
  Hello robot;  // the peer as the opener knows it
};

TEST(Handshake, BothEndsLearnThePeersIdentity) {
  Talk talk;

  const auto desk = talk.Run();

  ASSERT_TRUE(desk) << desk.error().message;
  EXPECT_EQ(desk->name, "desk");
  EXPECT_EQ(desk->instance, 3U);
  EXPECT_EQ(desk->session, 99U);
  EXPECT_EQ(talk.robot.name, "robot");
  EXPECT_EQ(desk->cookie + talk.robot.cookie + talk.robot.session, 0U);
}

TEST(Handshake, DeniesAPeerWithoutTheCookie) {
  const Error denied{ErrorCode::kDenied,
                     "robot does not know 'desk': both must run as the same user of this machine"};

  EXPECT_EQ(Talk(HelloOf("desk", 8)).Run().error(), denied);
  EXPECT_EQ(Talk(HelloOf("desk", 0)).Run().error(), denied);
  EXPECT_EQ(Talk(HelloOf("desk"), HelloOf("robot", 0)).Run().error(), denied);
}

TEST(Handshake, DeniesMissingCookiesAtBothEnds) {
  EXPECT_EQ(Talk(HelloOf("desk", 0), HelloOf("robot", 0)).Run().error().code, ErrorCode::kDenied);
}

TEST(Handshake, AnAllowedPeerMayOmitButNotForgeAProof) {
  EXPECT_TRUE(Talk(HelloOf("desk", 0), HelloOf("robot"), UnauthenticatedPeers::kAllowed).Run());
  Talk talk(HelloOf("desk", 0), HelloOf("robot"), UnauthenticatedPeers::kAllowed);
  ASSERT_TRUE(talk.Hear(MessageType::kHello, talk.opener.Greet()));
  Proof wrong;
  wrong.proof.fill(1);

  EXPECT_FALSE(talk.Hear(MessageType::kProof, EncodeBody(wrong)));
}

TEST(Handshake, RemotePeersNeedNoCookie) {
  Talk talk(HelloOf("desk", 0), HelloOf("robot", 0), UnauthenticatedPeers::kFromElsewhere);

  const auto challenge = talk.Hear(MessageType::kHello, talk.opener.Greet());

  ASSERT_TRUE(challenge);
  EXPECT_EQ(DecodeBody<Challenge>(challenge->body)->proof, message::Digest{});
  EXPECT_TRUE(
      Talk(HelloOf("desk", 0), HelloOf("robot", 0), UnauthenticatedPeers::kFromElsewhere).Run());
}

TEST(Handshake, NoMessageContainsTheCookie) {
  Talk talk;
  const Bytes greeting = talk.opener.Greet();
  const auto challenge = talk.Hear(MessageType::kHello, greeting);
  const auto proof = talk.Answer(*challenge);
  const auto wanted = std::as_bytes(std::span(&kCookie, 1));

  for (const Bytes& said : {greeting, challenge->body, proof->body}) {
    EXPECT_EQ(std::search(said.begin(), said.end(), wanted.begin(), wanted.end()), said.end());
  }
}

TEST(Handshake, AProofIsBoundToItsLink) {
  Talk recorded;
  const Bytes greeting = recorded.opener.Greet();
  const auto proof = recorded.Answer(*recorded.Hear(MessageType::kHello, greeting));
  ASSERT_TRUE(proof);
  Talk replayed;
  ASSERT_TRUE(replayed.Hear(MessageType::kHello, greeting));

  const auto judged = replayed.Hear(MessageType::kProof, proof->body);

  ASSERT_FALSE(judged);
  EXPECT_EQ(judged.error().code, ErrorCode::kDenied);
}

TEST(Handshake, AnAcceptorsProofCannotBeReflected) {
  Talk talk;
  const auto challenge = talk.Hear(MessageType::kHello, talk.opener.Greet());
  Proof mirrored;
  mirrored.proof = DecodeBody<Challenge>(challenge->body)->proof;

  EXPECT_FALSE(talk.Hear(MessageType::kProof, EncodeBody(mirrored)));
}

TEST(Handshake, AProofCoversTheSession) {
  Talk talk;
  const auto reply = talk.Answer(*talk.Hear(MessageType::kHello, talk.opener.Greet()));
  auto proof = DecodeBody<Proof>(reply->body);
  ++proof->session;

  EXPECT_FALSE(talk.Hear(MessageType::kProof, EncodeBody(*proof)));
}

TEST(Handshake, DeniesAnOpenerWithAnotherAddress) {
  Talk talk(HelloOf("desk"), HelloOf("robot"), UnauthenticatedPeers::kRefused, "127.0.0.1:6666");

  EXPECT_EQ(talk.Run().error().code, ErrorCode::kDenied);
}

TEST(Handshake, RefusesAHelloOfAnotherVersion) {
  const auto refusal_of = [](std::uint16_t version) {
    return Talk().acceptor.Take(HeaderOf(MessageType::kHello, version), Bytes(5)).error();
  };
  const std::string begin =
      "robot speaks protocol version " + kOursText + ", but this program speaks version ";

  EXPECT_EQ(refusal_of(kOlder),
            (Error{ErrorCode::kIncompatible, begin + kOlderText + ": update this program"}));
  EXPECT_EQ(refusal_of(kNewer),
            (Error{ErrorCode::kIncompatible, begin + kNewerText + ": update robot"}));
}

TEST(Handshake, RefusesAChallengeOfAnotherVersion) {
  const auto refusal_of = [](std::uint16_t version) {
    Talk talk;
    (void)talk.opener.Greet();
    return talk.opener.Take(HeaderOf(MessageType::kChallenge, version), Bytes(5)).error();
  };
  const std::string begin = "127.0.0.1:10705 speaks protocol version ";
  const std::string ours = ", but this program speaks version " + kOursText + ": update ";

  EXPECT_EQ(refusal_of(kOlder),
            (Error{ErrorCode::kIncompatible, begin + kOlderText + ours + "127.0.0.1:10705"}));
  EXPECT_EQ(refusal_of(kNewer),
            (Error{ErrorCode::kIncompatible, begin + kNewerText + ours + "this program"}));
}

TEST(Handshake, RefusesALaterFrameOfAnotherVersion) {
  Talk talk;
  const auto challenge = talk.Hear(MessageType::kHello, talk.opener.Greet());
  ASSERT_TRUE(challenge);
  const auto proof = talk.Answer(*challenge);
  ASSERT_TRUE(proof);

  const auto late_proof = talk.acceptor.Take(HeaderOf(proof->type, kNewer), proof->body);
  const auto welcome = talk.Hear(proof->type, proof->body);
  ASSERT_TRUE(welcome);
  const auto late_welcome = talk.opener.Take(HeaderOf(welcome->type, kOlder), welcome->body);

  EXPECT_EQ(late_proof.error().code, ErrorCode::kIncompatible);
  EXPECT_EQ(late_welcome.error().code, ErrorCode::kIncompatible);
}

TEST(Handshake, RefusesMessagesOutOfTurn) {
  for (const auto type : {MessageType::kProof, MessageType::kWelcome, MessageType::kReply}) {
    EXPECT_EQ(Talk().Hear(type, Bytes(5)).error().code, ErrorCode::kInvalid);
  }
  EXPECT_EQ(Talk().Hear(MessageType::kHello, Bytes(5)).error().code, ErrorCode::kInvalid);
  Talk talk;
  ASSERT_TRUE(talk.Hear(MessageType::kHello, talk.opener.Greet()));
  EXPECT_EQ(talk.Hear(MessageType::kHello, talk.opener.Greet()).error().code, ErrorCode::kInvalid);
  EXPECT_EQ(talk.Answer({.type = MessageType::kWelcome, .body = Bytes(1)}).error().code,
            ErrorCode::kInvalid);
}

TEST(Handshake, ReadsARefusalOfAnotherVersion) {
  const Error refusal{ErrorCode::kIncompatible, "robot speaks protocol version " + kNewerText +
                                                    ", but this program speaks version 6: update"};
  Talk talk;
  (void)talk.opener.Greet();

  const auto judged =
      talk.opener.Take(HeaderOf(MessageType::kRefusal, kNewer), EncodeBody(refusal));

  EXPECT_EQ(judged.error(), refusal);
}

}  // namespace
}  // namespace tendon
