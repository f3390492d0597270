#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tendon::os {

/// Why nobody was reached at `address`, "10.9.1.2:10705"; `failure` is the errno of the attempt:
/// "nobody answers at 10.9.1.2:10705 (Connection refused)". Where this host itself has no way
/// there, the fault is not the peer's, and the host is named: "host 'desk-pc' has no route to
/// 10.9.1.2:10705 (Network is unreachable)".
[[nodiscard]] std::string WhyNotReached(const std::string& address, int failure);

/// Whether a text says, in the words of WhyNotReached(), that a host has no route.
[[nodiscard]] bool TellsOfNoRoute(std::string_view text);

/// The first number of a host's name, as the system resolves it here: "127.0.1.1" for the own name
/// on many machines. A number, and a name that nobody knows, is returned as it is.
[[nodiscard]] std::string NumberOf(const std::string& host);

/// From which of its addresses this host reaches another one, as the kernel chooses it now: a host
/// reaches an address of its own from that. Empty where there is no way. Nothing is sent.
[[nodiscard]] std::string AddressTowards(const std::string& host, std::uint16_t port);

}  // namespace tendon::os
