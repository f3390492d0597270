#pragma once

#include <tendon/gcm/messages.h>

#include <nlohmann/json_fwd.hpp>

namespace console {

// The catalogue as scripts see it; keys are stable within "schema": 1.

nlohmann::ordered_json ToJson(const tendon::ProcessEntry& entry);
nlohmann::ordered_json ToJson(const tendon::PluginDescription& plugin);
/// `process` is its own.
nlohmann::ordered_json ToJson(const tendon::ComponentDescription& component,
                              const tendon::ProcessEntry& process);
nlohmann::ordered_json ToJson(const tendon::ProvidedDescription& interface);
nlohmann::ordered_json ToJson(const tendon::RequiredDescription& interface);
nlohmann::ordered_json ToJson(const tendon::MemberDescription& member);
nlohmann::ordered_json ToJson(const tendon::ConnectionDescription& connection);
nlohmann::ordered_json ToJson(const tendon::ConnectionCounts& counts);
nlohmann::ordered_json ToJson(const tendon::MailboxFill& fill);

/// As the GCM has it of the process, with its age: without what is not known, empty where that is
/// all.
nlohmann::ordered_json HealthOf(const tendon::message::SystemHealth& health,
                                const tendon::ProcessDescription& process);

}  // namespace console
