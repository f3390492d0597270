#pragma once

#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/context.h>
#include <tendon/base/result.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/manager/component_description.h>
#include <tendon/payload/schema.h>

#include <optional>
#include <string>

/// Questions of verbs to the GCM and to processes. Each waits for an answer, at most --timeout.
namespace console {

/// The health of all processes; empty if the GCM does not provide it, which is not an error.
[[nodiscard]] tendon::message::SystemHealth AskHealth(Context& context);

/// The counters of the target's required interface, from its process. Empty if it is not connected
/// or the process does not answer.
[[nodiscard]] std::optional<tendon::ConnectionCounts> AskCounts(Context& context,
                                                                const PathTarget& target);

/// The mailbox level of the component; empty without a mailbox or an answer of its process.
[[nodiscard]] std::optional<tendon::MailboxFill> AskFill(Context& context,
                                                         const PathTarget& target);

/// The type with this fingerprint, from a process that uses it.
[[nodiscard]] tendon::Result<tendon::Schema> AskSchema(Context& context, const std::string& process,
                                                       const tendon::Fingerprint& type);

/// The classes and the plug-ins of a process.
[[nodiscard]] tendon::Result<tendon::message::Classes> AskClasses(Context& context,
                                                                  const std::string& process);

}  // namespace console
