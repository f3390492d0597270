#pragma once

#include <Ice/Ice.h>

#include <memory>

namespace tendon::ice {

/// Returns true if Ice checks the size of a sequence against the number of remaining bytes. Without
/// this check, a message of 45 bytes can make Ice allocate 64 GiB. The source file explains why.
[[nodiscard]] bool RefusesImpossibleSizes(const std::shared_ptr<Ice::Communicator>& communicator);

}  // namespace tendon::ice
