#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>
#include <tendon/gcm/event_sink.h>

#include <string>
#include <vector>

namespace console {

/// The events that fit any of `patterns`, which name interfaces or events, with `*` and `**`: by
/// interface, in the catalogue's order.
std::vector<tendon::EventSubscription> EventsThatFit(const tendon::Catalog& catalog,
                                                     const std::vector<std::string>& patterns);

/// Whether each of them names something to listen to. kNotFound says what is near, and kInvalid
/// what it names instead.
tendon::Result<void> CheckEventPatterns(const tendon::Catalog& catalog,
                                        const std::vector<std::string>& patterns);

}  // namespace console
