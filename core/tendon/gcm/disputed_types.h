#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/process/membership/membership_messages.h>
#include <tendon/process/viewer_messages.h>

#include <map>
#include <string>

namespace tendon {

/// For each present process, the payload types that have the same name as another type, for example
/// because of two versions of a component, and that FindSchema() does not know. With these schemas,
/// Compare() can name the difference. Linear in the members.
[[nodiscard]] std::map<std::string, message::GetSchemas> DisputedTypes(const Catalogue& catalogue);

/// The same for two interfaces only; each process is asked for its own types.
[[nodiscard]] std::map<std::string, message::GetSchemas> DisputedTypesBetween(
    const Catalogue& catalogue, const message::Wire& wire);

}  // namespace tendon
