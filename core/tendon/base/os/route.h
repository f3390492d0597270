#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tendon::os {

/// The reason why `address`, "10.9.1.2:10705", was not reached; `failure` is the errno of the
/// attempt: "nobody answers at 10.9.1.2:10705 (Connection refused)". If this host itself has no
/// route, the fault is not the peer's, and the text names this host: "host 'desk-pc' has no route
/// to 10.9.1.2:10705 (Network is unreachable)".
[[nodiscard]] std::string WhyNotReached(const std::string& address, int failure);

/// True if `text`, from WhyNotReached(), says that a host has no route.
[[nodiscard]] bool IsNoRouteError(std::string_view text);

/// The first numeric address of a host, as this system resolves it: "127.0.1.1" for its own name on
/// many machines. Numeric addresses and unknown names are returned unchanged.
[[nodiscard]] std::string NumberOf(const std::string& host);

/// The local address that the kernel now chooses for traffic to `host`; if `host` is an address of
/// this host, that address. Empty if there is no route. Nothing is sent.
[[nodiscard]] std::string AddressTowards(const std::string& host, std::uint16_t port);

}  // namespace tendon::os
