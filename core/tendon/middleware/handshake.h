#pragma once

#include <tendon/middleware/body.h>
#include <tendon/middleware/hello.h>
#include <tendon/security/certificate.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace tendon {
namespace message {

/// The first message of an end: its identity and a random number.
struct Greeting {
  std::uint64_t instance = 0;
  std::string name;
  std::array<std::uint8_t, 16> nonce{};
};

/// Proof that an end knows the cookie: HMAC-SHA256; zeroes if it has none.
using Digest = std::array<std::uint8_t, 32>;

/// The acceptor's answer to a greeting.
struct Challenge {
  Greeting greeting;
  Digest proof{};
};

/// The opener's answer to a challenge.
struct Proof {
  Digest proof{};
  std::uint64_t session = 0;
};

}  // namespace message

/// The handshake of a link: each end learns the identity of the other, and proves that it knows the
/// cookie without sending it:
///
///     opener     kHello      Greeting
///     acceptor   kChallenge  Challenge: its greeting and its proof
///     opener     kProof      Proof, and the session, which an impostor must not get
///     acceptor   kWelcome    None
///
/// The header of each frame has the protocol version of its sender. An end refuses a frame of
/// another version without reading its body, and says which program must be updated. A kRefusal is
/// read in any version, so the body of an Error never changes.
///
/// A proof is computed from both greetings, so it is valid on this link only. The acceptor's
/// address, as the opener knows it, is part of it, so a process at another address cannot relay it.
/// Under TLS both cookies are 0: certificates prove the same, and give the peer's name and role.
///
/// One end of one link; not thread-safe.
class Handshake {
 public:
  enum class Role { kOpener, kAcceptor };

  /// `address` is the acceptor's address as the opener knows it. `certificate` is the peer's, or
  /// null without TLS; it must outlive this object.
  Handshake(Role role, Hello mine, std::string address, UnauthenticatedPeers unauthenticated,
            const Certificate* certificate = nullptr);

  /// Returns the body of the opener's kHello.
  [[nodiscard]] Bytes Greet();

  /// The reaction to a frame of the peer.
  struct Step {
    MessageType type = MessageType::kHello;
    Bytes body;
    bool has_answer = false;    ///< `type` and `body` must be sent
    std::optional<Hello> peer;  ///< set by the last step: the peer is authenticated
  };
  /// Handles the peer's next frame. If the peer is not accepted, returns an error with a text for
  /// the opener.
  Result<Step> Take(const FrameHeader& header, std::span<const std::byte> body);

 private:
  enum class Stage { kHello, kChallenge, kProof, kWelcome };

  Result<Step> OnHello(const FrameHeader& header, std::span<const std::byte> body);
  Result<Step> OnChallenge(const FrameHeader& header, std::span<const std::byte> body);
  Result<Step> OnProof(const FrameHeader& header, std::span<const std::byte> body);
  Result<Step> OnWelcome(const FrameHeader& header);

  [[nodiscard]] message::Greeting MyGreeting() const;
  [[nodiscard]] Hello Peer(std::uint64_t session) const;
  [[nodiscard]] message::Digest ProofOf(Role role, std::uint64_t session) const;
  [[nodiscard]] bool IsWelcome(const message::Proof& proof) const;
  [[nodiscard]] Result<void> CheckAcceptor() const;
  [[nodiscard]] Error NotKnown() const;

  const Hello mine_;
  const std::string address_;
  const UnauthenticatedPeers unauthenticated_;
  const Certificate* const certificate_;
  Stage stage_;
  message::Greeting opener_;
  message::Greeting acceptor_;
};

}  // namespace tendon

template <>
inline constexpr auto tendon::kPayload<tendon::message::Greeting> = tendon::Describe(
    "tendon.Greeting", tendon::Field{"instance", &tendon::message::Greeting::instance},
    tendon::Field{"name", &tendon::message::Greeting::name},
    tendon::Field{"nonce", &tendon::message::Greeting::nonce});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Challenge> = tendon::Describe(
    "tendon.Challenge", tendon::Field{"greeting", &tendon::message::Challenge::greeting},
    tendon::Field{"proof", &tendon::message::Challenge::proof});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Proof> =
    tendon::Describe("tendon.Proof", tendon::Field{"proof", &tendon::message::Proof::proof},
                     tendon::Field{"session", &tendon::message::Proof::session});
