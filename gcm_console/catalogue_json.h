#pragma once

#include <tendon/gcm/catalog.h>

#include <nlohmann/json_fwd.hpp>

namespace console {

// The catalogue as scripts see it; keys are stable within "schema": 1.

nlohmann::ordered_json ToJson(const tendon::ProcessEntry& entry);
nlohmann::ordered_json ToJson(const tendon::ComponentDescription& component);
nlohmann::ordered_json ToJson(const tendon::ProvidedDescription& interface);
nlohmann::ordered_json ToJson(const tendon::RequiredDescription& interface);
nlohmann::ordered_json ToJson(const tendon::MemberDescription& member);
nlohmann::ordered_json ToJson(const tendon::ConnectionDescription& connection);

}  // namespace console
