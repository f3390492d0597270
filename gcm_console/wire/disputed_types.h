#pragma once

#include <gcm_console/context.h>

namespace console {

/// Asks the processes for types that differ under the same name, so that errors can name the
/// difference between two ends. Waits for each reply up to the usual time-out, and ignores
/// failures.
void LearnDisputedTypes(Context& context);

}  // namespace console
