#pragma once

#include <Ice/Ice.h>

namespace tendon::ice {

/// Whether the size of a sequence is compared with what is left before Ice believes it; where it is
/// not, a message of 45 bytes makes it allocate 64 GiB. See the source.
[[nodiscard]] bool RefusesImpossibleSizes(const std::shared_ptr<Ice::Communicator>& communicator);

}  // namespace tendon::ice
