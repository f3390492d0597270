#pragma once

#include <tendon/base/result.h>

#include <string>

namespace tendon {

/// The address of a process for others, as far as it can know.
struct AdvertisedAddress {
  std::string address;  ///< what others are told
  std::string warning;  ///< who cannot reach it, and the remedy; or empty

  bool operator==(const AdvertisedAddress&) const = default;
};

/// How a process reaches its GCM. Both are empty without a GCM.
struct GcmRoute {
  std::string to;    ///< the GCM's address
  std::string from;  ///< the local host's address on the way there: os::AddressTowards()
};

/// `listens` is the address at which the process listens. `advertise` is the address that its user
/// wants others to be told: "host:port", a host alone to keep the port, or empty.
///
/// Without `advertise`, a process that listens at every address of its host (0.0.0.0, [::])
/// announces the one from which it reaches the GCM. A process that listens at one address announces
/// that, with a warning if a GCM on another host cannot reach it.
[[nodiscard]] AdvertisedAddress AdvertisedAddressOf(const std::string& listens,
                                                    const std::string& advertise,
                                                    const GcmRoute& way);

/// kInvalid if `advertise`, which is not empty, is neither an address nor a host, or means every
/// address of a host.
Result<void> CheckAdvertise(const std::string& advertise);

/// Whether an address "host:port" is valid within one host only: 127.0.0.0/8, [::1] or "localhost".
[[nodiscard]] bool IsOfOneHost(const std::string& address);

/// For a GCM: why this host cannot reach a process that announces `address` and whose link comes
/// from `peer`; empty if it probably can.
[[nodiscard]] std::string WhyOutOfReach(const std::string& address, const std::string& peer);

}  // namespace tendon
