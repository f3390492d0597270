#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/process/membership_messages.h>
#include <tendon/process/viewer_messages.h>

#include <map>
#include <string>

namespace tendon {

/// Finds payload types that have the same name but differ, for example because two processes run
/// different versions of a component. Returns, by present process, a request for the schemas that
/// FindSchema() does not know; with them, Compare() can name the difference. Linear in the members.
[[nodiscard]] std::map<std::string, message::GetSchemas> ConflictingTypes(
    const Catalogue& catalogue);

/// The same, but only for the types of two interfaces.
[[nodiscard]] std::map<std::string, message::GetSchemas> ConflictingTypesBetween(
    const Catalogue& catalogue, const message::Wire& wire);

}  // namespace tendon
