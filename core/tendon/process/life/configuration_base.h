#pragma once

#include <tendon/base/result.h>
#include <tendon/process/life/messages.h>

#include <string>

/// Of two who change the same configuration at once the second is told, for its change was made
/// from what is there no more.
namespace tendon {

/// What an order says of the configuration that it was made from: JSON as the catalogue has it,
/// empty where the component was told nothing. Never of zeros.
[[nodiscard]] Fingerprint BaseOf(const std::string& configuration);

/// Whether the order may replace `now`. kFailed says what to look at; `by` whose change it was, as
/// " by gcm set at 2025-11-21 15:40:03", or is empty.
Result<void> CheckBase(const message::LifeOrder& order, const std::string& now,
                       const std::string& by = "");

}  // namespace tendon
