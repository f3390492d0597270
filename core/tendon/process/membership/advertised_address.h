#pragma once

#include <tendon/base/error.h>
#include <tendon/base/result.h>

#include <string>

namespace tendon {

/// The address that a process announces.
struct AdvertisedAddress {
  std::string address;  ///< the announced address
  std::string warning;  ///< names the hosts that cannot reach it, and the remedy; may be empty

  bool operator==(const AdvertisedAddress&) const = default;
};

/// The route from a process to its GCM. Both addresses are empty without a GCM.
struct GcmRoute {
  std::string to;    ///< the GCM's address
  std::string from;  ///< the local address of the route: os::AddressTowards()
};

/// Returns the address that a process announces. `listens` is the address at which the process
/// listens. `advertise` is the address that the user wants to announce: "host:port", only a host to
/// keep the port, or empty.
///
/// Without `advertise`, a process that listens at every address of its host (0.0.0.0, [::])
/// announces the address from which it reaches the GCM. A process that listens at one address
/// announces this address, with a warning if a GCM on another host cannot reach it.
[[nodiscard]] AdvertisedAddress AdvertisedAddressOf(const std::string& listens,
                                                    const std::string& advertise,
                                                    const GcmRoute& way);

/// Returns kInvalid if `advertise` is neither an address nor a host, or means all addresses of a
/// host. `advertise` must not be empty.
Result<void> CheckAdvertise(const std::string& advertise);

/// True if an address "host:port" is valid only within one host: 127.0.0.0/8, [::1] or "localhost".
[[nodiscard]] bool IsOfOneHost(const std::string& address);

/// For a GCM: returns the reason why this host cannot reach a process. The process announces
/// `address`, and its link comes from `peer`. Empty if the process is probably reachable.
[[nodiscard]] std::string WhyOutOfReach(const std::string& address, const std::string& peer);

/// Returns " --gcm 10.0.0.1:10705", to append to a command. Empty for the default GCM.
[[nodiscard]] std::string GcmWords(const std::string& address);

/// Returns an error with code kUnreachable: "no GCM at 127.0.0.1:10705 (connection refused); start
/// one with: gcm serve". `reason` says why the GCM cannot be reached, and may repeat the address.
[[nodiscard]] Error NoGcm(const std::string& address, const std::string& reason);

}  // namespace tendon
