#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tendon::os {

/// Returns the reason why `address` ("10.9.1.2:10705") was not reached: "nobody answers at
/// 10.9.1.2:10705 (Connection refused)". `failure` is the errno of the attempt. If this host has no
/// route, the text names this host, because the peer is not at fault: "host 'desk-pc' has no route
/// to 10.9.1.2:10705 (Network is unreachable)".
[[nodiscard]] std::string WhyNotReached(const std::string& address, int failure);

/// True if `text`, from WhyNotReached(), says that a host has no route.
[[nodiscard]] bool IsNoRouteError(std::string_view text);

/// Returns the first numeric address to which this system resolves a host name. On many machines,
/// the machine's own name resolves to "127.0.1.1". Numeric addresses and unknown names are returned
/// unchanged.
[[nodiscard]] std::string NumberOf(const std::string& host);

/// Returns the local address that the kernel now chooses for traffic to `host`. If `host` is an
/// address of this machine, returns that address. Returns an empty text if there is no route. Sends
/// nothing.
[[nodiscard]] std::string AddressTowards(const std::string& host, std::uint16_t port);

}  // namespace tendon::os
