#pragma once

#include <tendon/gcm/diagnosis.h>

#include <string>
#include <vector>

namespace tendon {

/// True if the process of the required interface still tries to make the inactive connection.
[[nodiscard]] bool IsKept(const Diagnosis& diagnosis);

/// What is left of an inactive connection, one line for each process that was asked: "left over:
/// nothing in robot", "kept: desk makes it as soon as it can". Also true if nobody has tried to
/// make the connection.
[[nodiscard]] std::vector<std::string> LeftoverTexts(const Diagnosis& diagnosis);

}  // namespace tendon
