#include "support/network_kinds.h"

std::vector<NetworkKind> NetworkKinds() { return PlainNetworkKinds(); }
