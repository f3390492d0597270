#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/process/membership_messages.h>
#include <tendon/process/messages.h>

#include <map>
#include <string>

namespace tendon {

/// Of each process that is there, the payload types which have the name of another type, as two
/// versions of a component's do, and which FindSchema() does not know. Once they are learned,
/// Compare() can say in what the two differ. Linear in the members.
[[nodiscard]] std::map<std::string, message::GetSchemas> DisputedTypes(const Catalog& catalog);

/// Those of two interfaces alone, each to be asked of its own process.
[[nodiscard]] std::map<std::string, message::GetSchemas> DisputedTypesBetween(
    const Catalog& catalog, const message::Wire& wire);

}  // namespace tendon
