#pragma once

#include <gcm_console/context.h>

namespace console {

/// Asks the processes for types that differ under the same name, so that the catalogue can name the
/// difference between two ends. Best effort: waits for each reply as long as for any answer.
void LearnDisputedTypes(Context& context);

}  // namespace console
