#pragma once

#include <tendon/manager/component_description.h>
#include <tendon/middleware/frame.h>

#include <cstdint>
#include <string>
#include <vector>

/// Messages for copies of values that another process reads.
namespace tendon::message {

// From the process of a required interface, before it opens the provided one. The copies arrive as
// rows of one column, the newest only, as after kSubscribe.
inline constexpr auto kMirror = static_cast<MessageType>(0x20b);  // request: Mirror -> MirrorReply

// From the peer.
// notice: bool, whether the read command is enabled; the handle is that of its copies
inline constexpr auto kMirrorTurned = static_cast<MessageType>(0x20c);

/// Asks for copies of read commands that return the newest value of a column.
struct Mirror {
  InterfaceName provided;
  std::vector<std::string> commands;
};

/// One mirrored command; all zero if there is no such command.
struct MirroredColumn {
  std::uint32_t handle = 0;      ///< handle of the frames with its copies
  std::uint32_t capacity = 0;    ///< size of its largest value in bytes
  std::int64_t time = 0;         ///< time of the newest row, ns on the source's steady clock
  std::vector<std::byte> value;  ///< value in that row; empty if there is none
};

/// The answer to kMirror, in the order asked for.
struct MirrorReply {
  std::vector<MirroredColumn> columns;
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::Mirror> =
    tendon::Describe("tendon.Mirror", tendon::Field{"provided", &tendon::message::Mirror::provided},
                     tendon::Field{"commands", &tendon::message::Mirror::commands});

template <>
inline constexpr auto tendon::kPayload<tendon::message::MirroredColumn> = tendon::Describe(
    "tendon.MirroredColumn", tendon::Field{"handle", &tendon::message::MirroredColumn::handle},
    tendon::Field{"capacity", &tendon::message::MirroredColumn::capacity},
    tendon::Field{"time", &tendon::message::MirroredColumn::time, "ns"},
    tendon::Field{"value", &tendon::message::MirroredColumn::value});

template <>
inline constexpr auto tendon::kPayload<tendon::message::MirrorReply> = tendon::Describe(
    "tendon.MirrorReply", tendon::Field{"columns", &tendon::message::MirrorReply::columns});
