#pragma once

#include <tendon/interface/description.h>

#include <string>

namespace tendon::gui {

/// The read command of the interface that says what `command` would set: it answers the type that
/// the command takes. Of several the one that is named likewise, GetGains for SetGains. Empty where
/// there is none.
[[nodiscard]] std::string MatchingRead(const ProvidedDescription& of,
                                       const MemberDescription& command);

}  // namespace tendon::gui
