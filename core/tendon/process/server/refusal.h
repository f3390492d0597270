#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>
#include <tendon/proxy/messages.h>

#include <memory>

namespace tendon {

/// Refuses a connection to `provided`, which does not fit, and names what differs first. Types that
/// only the opener knows are asked for there; it is refused without them when it does not answer.
/// `timer` sees to that. `why` is what can be said without asking.
void RefuseMisfit(Worker& timer, const std::shared_ptr<Channel>& channel,
                  const message::OpenInterface& open, const ProvidedDescription& provided,
                  const Error& why, const std::shared_ptr<Responder>& responder);

}  // namespace tendon
