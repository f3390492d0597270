#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/process/membership_messages.h>
#include <tendon/process/viewer_messages.h>

#include <map>
#include <string>

namespace tendon {

/// Finds payload types that have the same name but differ, for example because two processes run
/// different versions of a component. Returns, for each present process, a request for those
/// schemas that FindSchema() does not know yet. When the schemas are known, Compare() can name the
/// difference. The cost is linear in the number of members.
[[nodiscard]] std::map<std::string, message::GetSchemas> ConflictingTypes(
    const Catalogue& catalogue);

/// Like ConflictingTypes(), but only for the types of the two interfaces of `ends`.
[[nodiscard]] std::map<std::string, message::GetSchemas> ConflictingTypesBetween(
    const Catalogue& catalogue, const message::ConnectionEnds& ends);

}  // namespace tendon
