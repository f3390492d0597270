#include <tendon/middleware/handshake.h>

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <tendon/base/os/process.h>

#include <cstring>
#include <stdexcept>
#include <utility>

namespace tendon {
namespace {

using message::Challenge;
using message::Digest;
using message::Greeting;
using message::Proof;

/// The data that a proof covers. Parts of variable length are encoded with their size, so that
/// different data never has the same encoding.
struct SignedPart {
  std::uint8_t role = 0;
  Greeting opener;
  Greeting acceptor;
  std::string address;
  std::uint64_t session = 0;
};

}  // namespace
}  // namespace tendon

template <>
inline constexpr auto tendon::kPayload<tendon::SignedPart> =
    tendon::Describe("tendon.SignedPart", tendon::Field{"role", &tendon::SignedPart::role},
                     tendon::Field{"opener", &tendon::SignedPart::opener},
                     tendon::Field{"acceptor", &tendon::SignedPart::acceptor},
                     tendon::Field{"address", &tendon::SignedPart::address},
                     tendon::Field{"session", &tendon::SignedPart::session});

namespace tendon {
namespace {

Digest Sign(std::uint64_t cookie, const SignedPart& part) {
  const Bytes text = EncodeBody(part);
  Digest digest{};
  unsigned size = 0;
  const unsigned char* made =
      HMAC(EVP_sha256(), &cookie, sizeof cookie,
           reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data(), &size);
  if (made == nullptr || size != digest.size()) throw std::runtime_error("HMAC-SHA256 failed");
  return digest;
}

/// Compares in constant time, so that the time does not show where the digests differ.
bool AreEqual(const Digest& one, const Digest& other) {
  return CRYPTO_memcmp(one.data(), other.data(), one.size()) == 0;
}

void FillWithRandom(std::array<std::uint8_t, 16>& nonce) {
  const std::array<std::uint64_t, 2> random{os::RandomNumber(), os::RandomNumber()};
  static_assert(sizeof random == sizeof nonce);
  std::memcpy(nonce.data(), random.data(), sizeof random);
}

/// Returns the error for different protocol versions. The text is for the user of the opener.
Error VersionsDiffer(const std::string& acceptor, unsigned its, unsigned openers) {
  return {ErrorCode::kIncompatible, acceptor + " speaks protocol version " + std::to_string(its) +
                                        ", but this program speaks version " +
                                        std::to_string(openers) + ": update " +
                                        (its > openers ? "this program" : acceptor)};
}

Handshake::Step StepWith(MessageType type, Bytes body) {
  return {.type = type, .body = std::move(body), .has_reply = true, .peer = std::nullopt};
}

}  // namespace

Handshake::Handshake(Role role, Hello mine, std::string address,
                     UnauthenticatedPeers unauthenticated, const Certificate* certificate)
    : mine_(std::move(mine)),
      address_(std::move(address)),
      unauthenticated_(unauthenticated),
      certificate_(certificate),
      stage_(role == Role::kOpener ? Stage::kChallenge : Stage::kHello) {}

Bytes Handshake::Greet() {
  opener_ = MyGreeting();
  return EncodeBody(opener_);
}

Result<Handshake::Step> Handshake::Take(const FrameHeader& header,
                                        std::span<const std::byte> body) {
  const bool is_opener = stage_ == Stage::kChallenge || stage_ == Stage::kWelcome;
  if (is_opener && header.type == MessageType::kRefusal) return ReadRefusal(body, address_);
  constexpr unsigned kOurs = FrameHeader::kProtocolVersion;
  if (header.version != kOurs) {  // then the format of the body is unknown
    return is_opener ? VersionsDiffer(address_, header.version, kOurs)
                     : VersionsDiffer(mine_.name, kOurs, header.version);
  }
  switch (stage_) {
    case Stage::kHello:
      return OnHello(header, body);
    case Stage::kChallenge:
      return OnChallenge(header, body);
    case Stage::kProof:
      return OnProof(header, body);
    default:
      return OnWelcome(header);
  }
}

Result<Handshake::Step> Handshake::OnHello(const FrameHeader& header,
                                           std::span<const std::byte> body) {
  if (header.type != MessageType::kHello || header.request == 0) {
    return Error{ErrorCode::kInvalid, mine_.name + " expects a Hello first"};
  }
  auto greeting = DecodeBody<Greeting>(body);
  if (!greeting) return greeting.error();
  opener_ = *std::move(greeting);
  acceptor_ = MyGreeting();
  stage_ = Stage::kProof;
  const Challenge challenge{.greeting = acceptor_, .proof = ProofOf(Role::kAcceptor, 0)};
  return StepWith(MessageType::kChallenge, EncodeBody(challenge));
}

Result<Handshake::Step> Handshake::OnChallenge(const FrameHeader& header,
                                               std::span<const std::byte> body) {
  auto challenge = DecodeBody<Challenge>(body);
  if (header.type != MessageType::kChallenge || !challenge) {
    return Error{ErrorCode::kInvalid, address_ + " answered the Hello with an unexpected message"};
  }
  acceptor_ = std::move(challenge->greeting);
  const bool is_proved = AreEqual(challenge->proof, ProofOf(Role::kAcceptor, 0));
  if (mine_.cookie != 0 && !is_proved) return NotKnown();
  if (const auto checked = CheckAcceptor(); !checked) return checked.error();
  stage_ = Stage::kWelcome;
  const Proof proof{.proof = ProofOf(Role::kOpener, mine_.session), .session = mine_.session};
  return StepWith(MessageType::kProof, EncodeBody(proof));
}

Result<Handshake::Step> Handshake::OnProof(const FrameHeader& header,
                                           std::span<const std::byte> body) {
  const auto proof = DecodeBody<Proof>(body);
  if (header.type != MessageType::kProof || !proof) {
    return Error{ErrorCode::kInvalid, mine_.name + " expects a proof after the Hello"};
  }
  if (!IsWelcome(*proof)) return NotKnown();
  Step step = StepWith(MessageType::kWelcome, EncodeBody(None{}));
  step.peer = Peer(proof->session);
  return step;
}

Result<Handshake::Step> Handshake::OnWelcome(const FrameHeader& header) {
  if (header.type != MessageType::kWelcome) {
    return Error{ErrorCode::kInvalid, address_ + " answered the proof with an unexpected message"};
  }
  return Step{.peer = Peer(0)};
}

Greeting Handshake::MyGreeting() const {
  Greeting greeting{.instance = mine_.instance, .name = mine_.name, .nonce = {}};
  FillWithRandom(greeting.nonce);
  return greeting;
}

Hello Handshake::Peer(std::uint64_t session) const {
  const Greeting& greeting = stage_ == Stage::kProof ? opener_ : acceptor_;
  Hello peer{.instance = greeting.instance, .name = greeting.name, .session = session};
  if (certificate_ == nullptr) return peer;
  peer.role = certificate_->role;
  const bool is_process = certificate_->holder == Holder::kProcess;
  if (!is_process || peer.name != certificate_->name) {
    peer.name = certificate_->name + " (" + peer.name + ")";
  }
  return peer;
}

/// Computes a proof. All bytes are zero if this end has no cookie.
Digest Handshake::ProofOf(Role role, std::uint64_t session) const {
  if (mine_.cookie == 0) return {};
  return Sign(mine_.cookie, {.role = static_cast<std::uint8_t>(role),
                             .opener = opener_,
                             .acceptor = acceptor_,
                             .address = address_,
                             .session = session});
}

bool Handshake::IsWelcome(const Proof& proof) const {
  if (certificate_ != nullptr) return true;  // TLS has authenticated the peer
  if (unauthenticated_ == UnauthenticatedPeers::kFromElsewhere) return true;
  if (AreEqual(proof.proof, Digest{})) return unauthenticated_ == UnauthenticatedPeers::kAllowed;
  return mine_.cookie != 0 && AreEqual(proof.proof, ProofOf(Role::kOpener, proof.session));
}

/// Checks the certificate and the name of the acceptor. Called before the opener sends anything
/// confidential.
Result<void> Handshake::CheckAcceptor() const {
  const std::string& name = acceptor_.name;
  const bool is_proved = certificate_ == nullptr ||
                         (certificate_->holder == Holder::kProcess && certificate_->name == name);
  if (!is_proved) {
    return Error{ErrorCode::kDenied, address_ + " calls itself '" + name +
                                         "', but shows the certificate of the " +
                                         std::string(ToString(certificate_->holder)) + " '" +
                                         certificate_->name + "': do not trust that program"};
  }
  if (certificate_ != nullptr && certificate_->role != tendon::Role::kOperator) {
    return Error{
        ErrorCode::kDenied,
        address_ + " has the certificate of a viewer, but only operators may give orders: issue '" +
            name + "' a certificate with --role operator"};
  }
  if (mine_.wanted.empty() || mine_.wanted == name) return {};
  return Error{ErrorCode::kUnreachable, "the process at " + address_ + " is '" + name + "', but '" +
                                            mine_.wanted + "' was expected"};
}

Error Handshake::NotKnown() const {
  return {ErrorCode::kDenied, acceptor_.name + " does not know '" + opener_.name +
                                  "': both must run as the same user of this machine"};
}

}  // namespace tendon
