#pragma once

#include <tendon/base/result.h>
#include <tendon/process/log/log_messages.h>
#include <tendon/process/membership_messages.h>

#include <string>

/// Checks the names in a report of an LCM, cuts free texts and makes them printable, and fills in
/// missing process names. Errors of code kInvalid.
namespace tendon::server {

Result<void> Sanitize(ComponentDescription& component);

/// A connection that `process` owns.
Result<void> Sanitize(ConnectionDescription& connection, const std::string& process);

/// Checks all of it; components and connections must be unique.
Result<void> Sanitize(message::Join& join);

/// One change in a Report: must be about `process`, with exactly the fields of its kind.
Result<void> Sanitize(CatalogueChange& change, const std::string& process);

void Sanitize(message::LogRecords& batch);

}  // namespace tendon::server
