#pragma once

#include <vector>

#include "core/parity/pair.h"

namespace tendon_test {

/// Every kind of client with every kind of server, in two processes on every kind of network. All
/// pairs of one network share one pair of processes.
[[nodiscard]] std::vector<PlacedKinds> RemotePairs();

}  // namespace tendon_test
