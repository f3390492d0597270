#pragma once

#include <vector>

#include "core/parity/pair.h"

namespace tendon_test {

/// Pairs of two processes on every sort of network: each kind of client with a periodic server, and
/// each kind of server with a periodic client and with one that has no thread.
[[nodiscard]] std::vector<PlacedKinds> RemotePairs();

}  // namespace tendon_test
