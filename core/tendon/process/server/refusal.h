#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>
#include <tendon/proxy/connection_messages.h>

#include <memory>

namespace tendon {

/// Refuses a connection to the incompatible interface `provided`, and names the first difference.
/// Asks the opener for types that only the opener knows. If there is no answer in time, for which
/// `timer` is needed, refuses with `why`.
void RefuseMisfit(Worker& timer, const std::shared_ptr<Channel>& channel,
                  const message::OpenInterface& open, const ProvidedDescription& provided,
                  const Error& why, const std::shared_ptr<Responder>& responder);

}  // namespace tendon
