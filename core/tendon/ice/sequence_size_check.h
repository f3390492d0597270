#pragma once

#include <Ice/Ice.h>

namespace tendon::ice {

/// Whether Ice checks the size of a sequence against the remaining bytes. If not, a message of 45
/// bytes makes it allocate 64 GiB. See the source.
[[nodiscard]] bool RefusesImpossibleSizes(const std::shared_ptr<Ice::Communicator>& communicator);

}  // namespace tendon::ice
