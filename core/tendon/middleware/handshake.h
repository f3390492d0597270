#pragma once

#include <tendon/middleware/body.h>
#include <tendon/middleware/hello.h>
#include <tendon/security/certificate.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace tendon {
namespace message {

/// The first message that each end sends: its identity and a random number.
struct Greeting {
  std::uint64_t instance = 0;
  std::string name;
  std::array<std::uint8_t, 16> nonce{};
};

/// The proof that an end knows the cookie, an HMAC-SHA256. All bytes are zero if the end has no
/// cookie.
using Digest = std::array<std::uint8_t, 32>;

/// The acceptor's reply to a greeting.
struct Challenge {
  Greeting greeting;
  Digest proof{};
};

/// The opener's reply to a challenge.
struct Proof {
  Digest proof{};
  std::uint64_t session = 0;
};

}  // namespace message

/// The handshake of a link. Each end sends its identity, and proves that it knows the cookie
/// without sending the cookie:
///
///     opener     kHello      Greeting
///     acceptor   kChallenge  Challenge: its greeting and its proof
///     opener     kProof      Proof, and the session, which an impostor must not get
///     acceptor   kWelcome    None
///
/// The header of each frame contains the protocol version of the sender. If the two versions
/// differ, the receiver does not read the body; it refuses the link and says which program must be
/// updated. A kRefusal is read in every version, so the encoding of an Error must never change.
///
/// A proof is computed from both greetings, so it is valid only on this link. The proof also covers
/// the acceptor's address as the opener knows it, so that a process at another address cannot relay
/// the proof. With TLS, both cookies are 0; instead, the certificates prove the identity, the name
/// and the role of the peer.
///
/// An object handles one end of one link. Not thread-safe.
class Handshake {
 public:
  enum class Role { kOpener, kAcceptor };

  /// `address` is the acceptor's address as the opener knows it. `certificate` is the peer's, or
  /// null without TLS; it must outlive this object.
  Handshake(Role role, Hello mine, std::string address, UnauthenticatedPeers unauthenticated,
            const Certificate* certificate = nullptr);

  /// Returns the body of the opener's kHello.
  [[nodiscard]] Bytes Greet();

  /// The action after a frame of the peer was handled.
  struct Step {
    MessageType type = MessageType::kHello;
    Bytes body;
    bool has_reply = false;     ///< true if `type` and `body` must be sent to the peer
    std::optional<Hello> peer;  ///< set by the last step, when the peer is authenticated
  };
  /// Handles the next frame of the peer. Returns an error if the peer is not accepted; the text of
  /// the error is for the user of the opener.
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
