#pragma once

#include <tendon/security/role.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace tendon {

/// The messages of a type that are written to the audit log. A connection may send some messages in
/// every cycle; they are written only if they are refused. For these, the audit log has the opening
/// of the connection, and the number of its commands when it ends.
enum class Audit : std::uint8_t { kRefusals, kAll };

/// The role that a peer needs to send one type of message to a process.
struct Right {
  std::uint16_t type;    ///< MessageType
  std::string_view act;  ///< description for people
  Role role;
  Audit audit;
};

/// All rights, sorted by type. A type that is not in the list is refused from every peer. A peer on
/// a channel that this process has opened needs no right, because this process has chosen the peer.
inline constexpr auto kRights = std::to_array<Right>({
    // proxy/connection_messages.h
    {0x100, "open an interface", Role::kOperator, Audit::kRefusals},  // logged separately
    {0x101, "close an interface", Role::kViewer, Audit::kRefusals},   // only its own
    {0x102, "queue commands", Role::kOperator, Audit::kRefusals},
    {0x103, "execute a read command", Role::kOperator, Audit::kRefusals},
    {0x104, "send a ping", Role::kViewer, Audit::kRefusals},
    {0x105, "execute a command and wait", Role::kOperator, Audit::kRefusals},
    {0x120, "report lost events", Role::kOperator, Audit::kRefusals},
    // process/viewer_messages.h
    {0x200, "read schemas", Role::kViewer, Audit::kRefusals},
    {0x201, "call a command", Role::kOperator, Audit::kAll},
    {0x202, "watch a state table", Role::kViewer, Audit::kRefusals},
    {0x203, "end a subscription", Role::kViewer, Audit::kRefusals},
    {0x206, "acknowledge a row", Role::kViewer, Audit::kRefusals},
    {0x207, "listen to events and commands", Role::kViewer, Audit::kRefusals},
    {0x208, "read the counts of a connection", Role::kViewer, Audit::kRefusals},
    {0x209, "read the fill levels of mailboxes", Role::kViewer, Audit::kRefusals},
    {0x20a, "watch a state table via the broker", Role::kViewer, Audit::kRefusals},  // broadcast
    {0x20b, "mirror a read command", Role::kOperator, Audit::kRefusals},  // for a connection
    {0x20d, "ask for the version", Role::kViewer, Audit::kRefusals},  // process/version_messages.h
    {0x20e, "read past rows", Role::kViewer, Audit::kRefusals},
    // process/history/history_messages.h
    {0x218, "read past events", Role::kViewer, Audit::kRefusals},
    {0x219, "read the kept log", Role::kViewer, Audit::kRefusals},
    {0x21a, "read the state of the history", Role::kViewer, Audit::kRefusals},
    // process/membership_messages.h
    {0x300, "join", Role::kOperator, Audit::kRefusals},  // logged separately
    {0x301, "report a change", Role::kOperator, Audit::kRefusals},
    {0x302, "send a ping", Role::kViewer, Audit::kRefusals},
    {0x303, "leave", Role::kOperator, Audit::kAll},
    {0x304, "report its health", Role::kOperator, Audit::kRefusals},
    // gcm/gcm_messages.h
    {0x310, "watch the catalogue", Role::kViewer, Audit::kRefusals},
    {0x311, "connect", Role::kOperator, Audit::kAll},
    {0x312, "disconnect", Role::kOperator, Audit::kAll},
    {0x313, "undo", Role::kOperator, Audit::kAll},
    {0x314, "read the history", Role::kViewer, Audit::kRefusals},
    {0x315, "forget a process", Role::kOperator, Audit::kAll},
    {0x316, "replace a connection", Role::kOperator, Audit::kAll},
    // process/lifecycle/lifecycle_messages.h
    {0x317, "give an order", Role::kOperator, Audit::kAll},
    {0x318, "list classes", Role::kViewer, Audit::kRefusals},
    {0x319, "begin an order", Role::kOperator, Audit::kRefusals},
    // gcm/gcm_messages.h
    {0x31a, "read the health", Role::kViewer, Audit::kRefusals},
    {0x31b, "give an order for a process", Role::kOperator, Audit::kAll},
    {0x31c, "find the broker", Role::kViewer, Audit::kRefusals},  // process/telemetry/
    {0x31d, "list the started processes", Role::kViewer, Audit::kRefusals},
    {0x31e, "execute a plan", Role::kOperator, Audit::kRefusals},
    {0x31f, "skip a step", Role::kOperator, Audit::kAll},
    // process/log/log_messages.h, gcm/gcm_messages.h
    {0x340, "log", Role::kOperator, Audit::kRefusals},
    {0x341, "set a log level", Role::kOperator, Audit::kAll},
    {0x342, "watch the log", Role::kViewer, Audit::kRefusals},
});

static_assert(std::ranges::is_sorted(kRights, std::ranges::less_equal{}, &Right::type) &&
                  std::ranges::adjacent_find(kRights, {}, &Right::type) == kRights.end(),
              "each type has one right, and is found by binary search");

/// Returns the right for a type; null if the type is not listed.
[[nodiscard]] constexpr const Right* FindRight(std::uint16_t type) {
  const auto* const found = std::ranges::lower_bound(kRights, type, {}, &Right::type);
  return found != kRights.end() && found->type == type ? found : nullptr;
}

/// Returns true if `role` includes the rights of `needed`.
[[nodiscard]] constexpr bool Includes(Role role, Role needed) noexcept { return role >= needed; }

}  // namespace tendon
