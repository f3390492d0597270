#pragma once

#include <gcm_console/context.h>

namespace console {

/// So that the catalogue knows in what two types of one name differ, and says so of ends that do
/// not fit. Best effort: a process that does not answer is waited for as long as for any answer.
void LearnDisputedTypes(Context& context);

}  // namespace console
