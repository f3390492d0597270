#pragma once

#include <tendon/gcm/diagnosis.h>

#include <string>
#include <vector>

namespace tendon {

/// Whether the process of the required interface still tries to make the connection, which does not
/// stand.
[[nodiscard]] bool IsKept(const Diagnosis& diagnosis);

/// What is left of a connection that does not stand, a line for each process that was asked:
/// "rolled back: nothing of it is left in robot", "kept: desk makes it as soon as it can".
[[nodiscard]] std::vector<std::string> LeftoverTexts(const Diagnosis& diagnosis);

}  // namespace tendon
