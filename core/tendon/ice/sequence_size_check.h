#pragma once

#include <Ice/Ice.h>

namespace tendon::ice {

/// True if Ice checks the size of a sequence against the remaining bytes. If not, a message of 45
/// bytes makes Ice allocate 64 GiB. See the source.
[[nodiscard]] bool RefusesImpossibleSizes(const std::shared_ptr<Ice::Communicator>& communicator);

}  // namespace tendon::ice
