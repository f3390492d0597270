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

constexpr std::uint16_t kNewest = FrameHeader::kProtocolVersion;
constexpr std::uint16_t kOldest = FrameHeader::kOldestVersion;
constexpr std::uint16_t kNewer = kNewest + 1;
const std::string kNewerText = std::to_string(kNewer);
const std::string kOurs =
    (kOldest < kNewest ? std::to_string(kOldest) + "-" : "") + std::to_string(kNewest);

/// One that speaks these protocol versions.
Hello Speaking(Hello hello, int oldest, int newest) {
  hello.oldest_version = static_cast<std::uint16_t>(oldest);
  hello.protocol_version = static_cast<std::uint16_t>(newest);
  return hello;
}

FrameHeader HeaderOf(MessageType type, std::uint16_t version = kOldest) {
  FrameHeader header;
  header.type = type;
  header.version = version;
  header.request = 1;
  return header;
}

/// The two ends of a link, and what they say to each other.
struct Talk {
  explicit Talk(Hello one = HelloOf("desk"), Hello other = HelloOf("robot"),
                Strangers strangers = Strangers::kRefused,
                const std::string& seen = "127.0.0.1:10705")
      : openers_oldest(one.oldest_version),
        acceptors_oldest(other.oldest_version),
        opener(Handshake::Role::kOpener, std::move(one), seen, Strangers::kRefused),
        acceptor(Handshake::Role::kAcceptor, std::move(other), "127.0.0.1:10705", strangers) {}

  Result<Handshake::Step> Hear(MessageType type, const Bytes& body) {
    return acceptor.Take(HeaderOf(type, openers_oldest), body);
  }
  Result<Handshake::Step> Answer(const Handshake::Step& step) {
    return opener.Take(HeaderOf(step.type, acceptors_oldest), step.body);
  }
  /// Whom the acceptor lets in.
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

  const std::uint16_t openers_oldest;
  const std::uint16_t acceptors_oldest;
  Handshake opener;
  Handshake acceptor;
  Hello robot;  // as the opener knows it
};

TEST(Handshake, BothEndsLearnWhoTheOtherIsAndTheAcceptorTheSession) {
  Talk talk;

  const auto desk = talk.Run();

  ASSERT_TRUE(desk) << desk.error().message;
  EXPECT_EQ(desk->name, "desk");
  EXPECT_EQ(desk->instance, 3U);
  EXPECT_EQ(desk->session, 99U);
  EXPECT_EQ(talk.robot.name, "robot");
  EXPECT_EQ(desk->cookie + talk.robot.cookie + talk.robot.session, 0U);
}

TEST(Handshake, WhoDoesNotKnowTheCookieIsDenied) {
  const Error denied{ErrorCode::kDenied,
                     "robot does not know 'desk': both must run as the same user of this machine"};

  EXPECT_EQ(Talk(HelloOf("desk", 8)).Run().error(), denied);
  EXPECT_EQ(Talk(HelloOf("desk", 0)).Run().error(), denied);
  EXPECT_EQ(Talk(HelloOf("desk"), HelloOf("robot", 0)).Run().error(), denied);
}

TEST(Handshake, NoCookieAtBothEndsIsNoKnowledge) {
  EXPECT_EQ(Talk(HelloOf("desk", 0), HelloOf("robot", 0)).Run().error().code, ErrorCode::kDenied);
}

TEST(Handshake, AllowedStrangersMayShowNoneButNoWrongOne) {
  EXPECT_TRUE(Talk(HelloOf("desk", 0), HelloOf("robot"), Strangers::kAllowed).Run());
  Talk talk(HelloOf("desk", 0), HelloOf("robot"), Strangers::kAllowed);
  ASSERT_TRUE(talk.Hear(MessageType::kHello, talk.opener.Greet()));
  Proof wrong;
  wrong.proof.fill(1);

  EXPECT_FALSE(talk.Hear(MessageType::kProof, EncodeBody(wrong)));
}

TEST(Handshake, FromElsewhereNoCookieIsAskedForAndNoneIsUsed) {
  Talk talk(HelloOf("desk", 0), HelloOf("robot", 0), Strangers::kFromElsewhere);

  const auto challenge = talk.Hear(MessageType::kHello, talk.opener.Greet());

  ASSERT_TRUE(challenge);
  EXPECT_EQ(DecodeBody<Challenge>(challenge->body)->proof, message::Digest{});
  EXPECT_TRUE(Talk(HelloOf("desk", 0), HelloOf("robot", 0), Strangers::kFromElsewhere).Run());
}

TEST(Handshake, NothingThatIsSaidHoldsTheCookie) {
  Talk talk;
  const Bytes greeting = talk.opener.Greet();
  const auto challenge = talk.Hear(MessageType::kHello, greeting);
  const auto proof = talk.Answer(*challenge);
  const auto wanted = std::as_bytes(std::span(&kCookie, 1));

  for (const Bytes& said : {greeting, challenge->body, proof->body}) {
    EXPECT_EQ(std::search(said.begin(), said.end(), wanted.begin(), wanted.end()), said.end());
  }
}

TEST(Handshake, AProofIsOfNoUseOnAnotherLink) {
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

TEST(Handshake, AnAcceptorsProofIsNoOpeners) {
  Talk talk;
  const auto challenge = talk.Hear(MessageType::kHello, talk.opener.Greet());
  Proof mirrored;
  mirrored.proof = DecodeBody<Challenge>(challenge->body)->proof;

  EXPECT_FALSE(talk.Hear(MessageType::kProof, EncodeBody(mirrored)));
}

TEST(Handshake, AProofCoversTheSession) {
  Talk talk;
  const auto answer = talk.Answer(*talk.Hear(MessageType::kHello, talk.opener.Greet()));
  auto proof = DecodeBody<Proof>(answer->body);
  ++proof->session;

  EXPECT_FALSE(talk.Hear(MessageType::kProof, EncodeBody(*proof)));
}

TEST(Handshake, WhoFoundTheAcceptorElsewhereIsDenied) {
  Talk talk(HelloOf("desk"), HelloOf("robot"), Strangers::kRefused, "127.0.0.1:6666");

  EXPECT_EQ(talk.Run().error().code, ErrorCode::kDenied);
}

TEST(Handshake, BothSpeakTheNewestThatBothKnow) {
  struct Case {
    int oldest, newest, agreed;
  };
  for (const Case one : {Case{kOldest, kNewest, kNewest}, Case{kOldest, kOldest, kOldest},
                         Case{kOldest - 1, kOldest, kOldest}, Case{kNewest, kNewest + 1, kNewest},
                         Case{kOldest, kNewest + 5, kNewest}}) {
    const Hello robot = Speaking(HelloOf("robot"), one.oldest, one.newest);
    Talk to_it(HelloOf("desk"), robot);
    Talk from_it(Speaking(HelloOf("desk"), one.oldest, one.newest));

    const auto its_peer = to_it.Run();
    const auto our_peer = from_it.Run();

    ASSERT_TRUE(its_peer) << its_peer.error().message;
    ASSERT_TRUE(our_peer) << our_peer.error().message;
    for (const Hello& peer : {*its_peer, to_it.robot, *our_peer, from_it.robot}) {
      EXPECT_EQ(peer.protocol_version, one.agreed) << one.oldest << "-" << one.newest;
    }
  }
}

TEST(Handshake, WhoSpeaksNoVersionOfOursIsToldWhomToUpdate) {
  const auto refusal_of = [](int oldest, int newest) {
    return Talk(Speaking(HelloOf("desk"), oldest, newest)).Run().error();
  };
  const std::string begin = "robot speaks protocol " + kOurs + ", this program ";
  const auto differs = [&](const std::string& end) {
    return Error{ErrorCode::kIncompatible, begin + end};
  };

  EXPECT_EQ(refusal_of(kOldest - 2, kOldest - 1),
            differs(std::to_string(kOldest - 2) + "-" + std::to_string(kOldest - 1) +
                    ": update this program"));
  EXPECT_EQ(refusal_of(kOldest - 1, kOldest - 1),
            differs(std::to_string(kOldest - 1) + ": update this program"));
  EXPECT_EQ(refusal_of(kNewest + 1, kNewest + 1),
            differs(std::to_string(kNewest + 1) + ": update robot"));
}

TEST(Handshake, AChallengeInAnOlderVersionIsRefusedHere) {
  Talk talk(HelloOf("desk"), Speaking(HelloOf("robot"), kOldest - 1, kNewest));
  const auto challenge = talk.Hear(MessageType::kHello, talk.opener.Greet());
  ASSERT_TRUE(challenge);
  Handshake newer(Handshake::Role::kOpener, Speaking(HelloOf("desk", 0), kNewest + 1, kNewest + 2),
                  "127.0.0.1:10705", Strangers::kRefused);
  (void)newer.Greet();

  const auto judged = newer.Take(HeaderOf(MessageType::kChallenge, kOldest - 1), challenge->body);

  ASSERT_FALSE(judged);
  EXPECT_EQ(judged.error().message,
            "127.0.0.1:10705 speaks protocol " + std::to_string(kOldest - 1) + "-" +
                std::to_string(kNewest) + ", this program " + std::to_string(kNewest + 1) + "-" +
                std::to_string(kNewest + 2) + ": update 127.0.0.1:10705");
}

TEST(Handshake, AnotherVersionIsRefusedBeforeItsBodyIsRead) {
  Talk talk;

  const auto judged = talk.acceptor.Take(HeaderOf(MessageType::kHello, kNewer), Bytes(5));

  EXPECT_EQ(judged.error(),
            (Error{ErrorCode::kIncompatible, "robot speaks protocol " + kOurs + ", this program " +
                                                 kNewerText + ": update robot"}));
}

TEST(Handshake, WhatIsOutOfTurnIsInvalid) {
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

TEST(Handshake, TheRefusalOfAnotherVersionIsReadAllTheSame) {
  const Error refusal{ErrorCode::kIncompatible,
                      "robot speaks protocol " + kNewerText + ", this program 6: update"};
  Talk talk;
  (void)talk.opener.Greet();

  const auto judged =
      talk.opener.Take(HeaderOf(MessageType::kRefusal, kNewer), EncodeBody(refusal));

  EXPECT_EQ(judged.error(), refusal);
}

TEST(Handshake, AChallengeInAnotherVersionIsRefusedHere) {
  Talk talk;
  (void)talk.opener.Greet();

  const auto judged = talk.opener.Take(HeaderOf(MessageType::kChallenge, kNewer), Bytes(5));

  EXPECT_EQ(judged.error().message, "127.0.0.1:10705 speaks protocol " + kNewerText +
                                        ", this program " + kOurs + ": update this program");
}

}  // namespace
}  // namespace tendon
