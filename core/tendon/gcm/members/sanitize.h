#pragma once

#include <tendon/base/result.h>
#include <tendon/process/log/log_messages.h>
#include <tendon/process/membership_messages.h>

#include <string>

/// Functions that clean up the data of an LCM. They check names, shorten free texts and make them
/// printable, and fill in missing process names. Errors have the code kInvalid.
namespace tendon::server {

Result<void> Sanitize(ComponentDescription& component);

/// Checks a connection that `process` owns.
Result<void> Sanitize(ConnectionDescription& connection, const std::string& process);

/// Checks everything in a Join; components and connections must be unique.
Result<void> Sanitize(message::Join& join);

/// Checks one change in a Report. The change must be about `process` and must contain exactly one
/// object of its kind.
Result<void> Sanitize(CatalogueChange& change, const std::string& process);

void Sanitize(message::LogRecords& batch);

}  // namespace tendon::server
