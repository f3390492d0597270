#pragma once

#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/context.h>
#include <tendon/base/result.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/manager/component_description.h>
#include <tendon/payload/schema.h>

#include <optional>
#include <string>

/// Requests of verbs to the GCM and to processes. Each function waits for the reply, at most
/// --timeout.
namespace console {

/// Requests the health of all processes. Empty if the GCM does not provide it; this is not an
/// error.
[[nodiscard]] tendon::message::SystemHealth AskHealth(Context& context);

/// Requests the counters of the target's required interface from its process. Empty if the
/// interface is not connected, or if the process does not answer.
[[nodiscard]] std::optional<tendon::ConnectionCounts> AskCounts(Context& context,
                                                                const PathTarget& target);

/// Requests the fill level of the component's mailbox. Empty if it has no mailbox, or if its
/// process does not answer.
[[nodiscard]] std::optional<tendon::MailboxFill> AskFill(Context& context,
                                                         const PathTarget& target);

/// Requests the state of the process's history. Returns nullopt if the process does not answer.
[[nodiscard]] std::optional<tendon::message::ProcessHistoryState> AskHistory(
    Context& context, const std::string& process);

/// Requests the type with this fingerprint from a process that uses it.
[[nodiscard]] tendon::Result<tendon::Schema> AskSchema(Context& context, const std::string& process,
                                                       const tendon::Fingerprint& type);

/// Requests the classes and the plug-ins of a process.
[[nodiscard]] tendon::Result<tendon::message::Classes> AskClasses(Context& context,
                                                                  const std::string& process);

}  // namespace console
