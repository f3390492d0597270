#pragma once

#include <tendon/base/result.h>
#include <tendon/process/log/messages.h>
#include <tendon/process/membership_messages.h>

#include <string>

/// What an LCM says of itself, made fit to be kept and shown: names are checked, free texts cut and
/// made printable, missing process names filled in. Errors of code kInvalid.
namespace tendon::server {

Result<void> TakeIn(ComponentDescription& component);

/// A connection that `process` owns.
Result<void> TakeIn(ConnectionDescription& connection, const std::string& process);

/// Everything in it; each component and each connection once.
Result<void> TakeIn(message::Join& join);

/// One step of a Report of `process`: about itself, with exactly what its kind needs.
Result<void> TakeIn(CatalogChange& change, const std::string& process);

void TakeIn(message::LogRecords& batch);

}  // namespace tendon::server
