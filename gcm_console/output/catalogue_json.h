#pragma once

#include <tendon/gcm/gcm_messages.h>
#include <tendon/process/history/history_messages.h>

#include <nlohmann/json_fwd.hpp>

namespace console {

// The catalogue as JSON for scripts. The keys do not change as long as "schema" is 1.

nlohmann::ordered_json ToJson(const tendon::ProcessEntry& entry);
nlohmann::ordered_json ToJson(const tendon::PluginDescription& plugin);
/// `process` is the process to which the component belongs.
nlohmann::ordered_json ToJson(const tendon::ComponentDescription& component,
                              const tendon::ProcessEntry& process);
nlohmann::ordered_json ToJson(const tendon::ProvidedDescription& interface);
nlohmann::ordered_json ToJson(const tendon::RequiredDescription& interface);
nlohmann::ordered_json ToJson(const tendon::MemberDescription& member);
nlohmann::ordered_json ToJson(const tendon::ConnectionDescription& connection);
nlohmann::ordered_json ToJson(const tendon::ConnectionCounts& counts);
nlohmann::ordered_json ToJson(const tendon::MailboxFill& fill);

/// Returns the state of a process's history. If the process keeps no history, the object has only
/// `limit_bytes`, which is 0.
nlohmann::ordered_json ToJson(const tendon::message::ProcessHistoryState& history);

/// Returns the health of a process as the GCM reports it, with its age. Unknown values are left
/// out; the result is empty if all are unknown.
nlohmann::ordered_json HealthOf(const tendon::message::SystemHealth& health,
                                const tendon::ProcessDescription& process);

}  // namespace console
