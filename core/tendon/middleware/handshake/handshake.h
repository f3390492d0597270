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

/// What an end says first: who it is, and a number that nobody can foresee.
struct Greeting {
  std::uint16_t protocol_version = 0;  // the newest it speaks
  std::uint64_t instance = 0;
  std::string name;
  std::array<std::uint8_t, 16> nonce{};
};

/// That an end knows the cookie: HMAC-SHA256, or zeroes where it shows none.
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

/// How the ends of a link learn who the other is, and prove that they know the cookie without
/// saying it:
///
///     opener     kHello      Greeting
///     acceptor   kChallenge  Challenge: its greeting and its proof
///     opener     kProof      Proof, and the session, which an impostor must not hear
///     acceptor   kWelcome    None
///
/// These frames carry the oldest protocol version that their sender speaks, so that an older
/// program reads them, and their bodies never change; both then speak the newest that both know.
///
/// A proof covers all that was said, so that none is good for another link, and the address at
/// which the opener finds the acceptor, so that one who listens elsewhere has no use for passing it
/// on. Under TLS, which proves the same by certificates, both cookies are 0; the peer's name and
/// role are then what its certificate says.
///
/// One end of one link; not thread-safe.
class Handshake {
 public:
  enum class Role { kOpener, kAcceptor };

  /// `address` is where the opener finds the acceptor; `certificate` the peer's, null without TLS,
  /// which must live as long as this.
  Handshake(Role role, Hello mine, std::string address, Strangers strangers,
            const Certificate* certificate = nullptr);

  /// The body of the opener's kHello.
  [[nodiscard]] Bytes Greet();

  /// What a frame of the peer leads to.
  struct Step {
    MessageType type = MessageType::kHello;
    Bytes body;
    bool has_answer = false;    ///< of `type` and `body`
    std::optional<Hello> peer;  ///< the last step: the peer is one of ours
  };
  /// The next frame of the peer; an error, in the words of the opener, when it is not welcome.
  Result<Step> Take(const FrameHeader& header, std::span<const std::byte> body);

 private:
  enum class Stage { kHello, kChallenge, kProof, kWelcome };

  Result<Step> OnHello(const FrameHeader& header, std::span<const std::byte> body);
  Result<Step> OnChallenge(const FrameHeader& header, std::span<const std::byte> body);
  Result<Step> OnProof(const FrameHeader& header, std::span<const std::byte> body);
  Result<Step> OnWelcome(const FrameHeader& header);

  [[nodiscard]] Result<void> CheckVersions(unsigned peers_oldest, unsigned peers_newest) const;
  [[nodiscard]] message::Greeting MyGreeting() const;
  [[nodiscard]] Hello Peer(std::uint64_t session) const;
  [[nodiscard]] message::Digest ProofOf(Role role, std::uint64_t session) const;
  [[nodiscard]] bool IsWelcome(const message::Proof& proof) const;
  [[nodiscard]] Result<void> CheckAcceptor() const;
  [[nodiscard]] Error NotKnown() const;

  const Hello mine_;
  const std::string address_;
  const Strangers strangers_;
  const Certificate* const certificate_;
  Stage stage_;
  message::Greeting opener_;
  message::Greeting acceptor_;
};

}  // namespace tendon

template <>
inline constexpr auto tendon::kPayload<tendon::message::Greeting> = tendon::Describe(
    "tendon.Greeting",
    tendon::Field{"protocol_version", &tendon::message::Greeting::protocol_version},
    tendon::Field{"instance", &tendon::message::Greeting::instance},
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
