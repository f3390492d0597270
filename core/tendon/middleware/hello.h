#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/frame.h>
#include <tendon/payload/payload.h>

#include <cstdint>
#include <span>
#include <string>

namespace tendon {

/// What each end says first on a link. Its frame's header carries the protocol version too, so that
/// ends of any two versions can refuse each other in a sentence.
struct Hello {
  std::uint16_t protocol_version = FrameHeader::kProtocolVersion;
  std::uint64_t instance = 0;  ///< of the process, new at each start
  std::string name;            ///< of the process or program, for people: "robot", "gcm ls"
  std::uint64_t session = 0;   ///< the token of a joined process, or 0
  std::uint64_t cookie = 0;    ///< proves the same user on this machine: LoopbackCookie()
};

template <>
inline constexpr auto kPayload<Hello> =
    Describe("tendon.Hello", Field{"protocol_version", &Hello::protocol_version},
             Field{"instance", &Hello::instance}, Field{"name", &Hello::name},
             Field{"session", &Hello::session}, Field{"cookie", &Hello::cookie});

/// The secret of this user on this machine: a file of mode 0600 in os::RuntimeFolder(), made by
/// whoever needs it first. kDenied where it cannot be read or made.
Result<std::uint64_t> LoopbackCookie();

/// Whom an acceptor lets in: those who know the cookie; in tests also those who show none; or, from
/// addresses off this machine, where Exposure let them in, anyone.
enum class Strangers { kRefused, kAllowed, kFromElsewhere };

/// What an acceptor with `mine` thinks of the first frame on a link: the peer's Hello, or why it is
/// refused, in the words of the one who opened the link and will read it there.
Result<Hello> CheckHello(const FrameHeader& header, std::span<const std::byte> body,
                         const Hello& mine, Strangers strangers);

/// What the opener thinks of the answer to the Hello it sent: the peer's, or the refusal. `peer` is
/// its address.
Result<Hello> CheckWelcome(const FrameHeader& header, std::span<const std::byte> body,
                           const Hello& sent, const std::string& peer);

/// The body of a kRefusal as the reason.
[[nodiscard]] Error ReadRefusal(std::span<const std::byte> body, const std::string& peer);

}  // namespace tendon
