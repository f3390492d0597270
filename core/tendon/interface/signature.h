#pragma once

#include <tendon/payload/fingerprint.h>
#include <tendon/payload/payload.h>

#include <cstdint>
#include <string_view>

namespace tendon {

/// How a command is executed. The kind is part of the signature, so a function that should be a
/// harmless read never binds to a command that blocks.
enum class CommandKind : std::int32_t {
  kVoid,           ///< no argument; queued to the server's thread
  kWrite,          ///< an argument; queued to the server's thread
  kRead,           ///< a result; runs in the caller's thread
  kQualifiedRead,  ///< an argument and a result; runs in the caller's thread
  kVoidReturn,     ///< a result; runs in the server's thread, and the caller waits
  kWriteReturn,    ///< an argument and a result; otherwise like kVoidReturn
};

template <>
inline constexpr auto kPayload<CommandKind> =
    DescribeEnum("tendon.CommandKind", Enumerator{"void", CommandKind::kVoid},
                 Enumerator{"write", CommandKind::kWrite}, Enumerator{"read", CommandKind::kRead},
                 Enumerator{"qualified_read", CommandKind::kQualifiedRead},
                 Enumerator{"void_return", CommandKind::kVoidReturn},
                 Enumerator{"write_return", CommandKind::kWriteReturn});

/// Returns "void", "write", "read", "qualified read", ...
[[nodiscard]] constexpr std::string_view ToString(CommandKind kind) noexcept {
  switch (kind) {
    case CommandKind::kVoid:
      return "void";
    case CommandKind::kWrite:
      return "write";
    case CommandKind::kRead:
      return "read";
    case CommandKind::kQualifiedRead:
      return "qualified read";
    case CommandKind::kVoidReturn:
      return "void-return";
    case CommandKind::kWriteReturn:
      return "write-return";
  }
  return "unknown";
}

/// True if the caller waits for a reply until the server's thread has executed the call.
[[nodiscard]] constexpr bool WaitsForServer(CommandKind kind) noexcept {
  return kind == CommandKind::kVoidReturn || kind == CommandKind::kWriteReturn;
}

/// The kind and types of one member; they must be equal at both ends of a connection.
struct Signature {
  CommandKind kind = CommandKind::kVoid;
  Fingerprint in;
  Fingerprint out;

  bool operator==(const Signature&) const = default;
};

template <>
inline constexpr auto kPayload<Signature> = Describe("tendon.Signature",
                                                     Field{"kind", &Signature::kind},
                                                     Field{"in", &Signature::in},
                                                     Field{"out", &Signature::out});

template <Payload In, Payload Out>
Signature SignatureOf(CommandKind kind) {
  return {kind, FingerprintOf<In>(), FingerprintOf<Out>()};
}

}  // namespace tendon
