#pragma once

#include <vector>

#include "core/parity/pair.h"

namespace tendon_test {

/// Every kind of client with every kind of server, in two processes on every sort of network: one
/// pair of processes for all pairs of a network.
[[nodiscard]] std::vector<PlacedKinds> RemotePairs();

}  // namespace tendon_test
