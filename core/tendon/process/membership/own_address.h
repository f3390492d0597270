#pragma once

#include <tendon/base/result.h>

#include <string>

namespace tendon {

/// Where others reach a process, as far as it can know.
struct OwnAddress {
  std::string address;  ///< that is told to others
  std::string warning;  ///< who does not reach it there, and what mends that; empty where all do

  bool operator==(const OwnAddress&) const = default;
};

/// How a process reaches its GCM. Both are empty where it joins none.
struct WayToGcm {
  std::string to;    ///< the address of the GCM
  std::string from;  ///< the host's address from which it is reached: os::AddressTowards()
};

/// `listens` is where the process listens; `advertise` what its user wants to be told to others,
/// "host:port", or a host alone for the port at which it listens, or nothing.
///
/// Without `advertise`, a process that listens at every address of its host (0.0.0.0, [::]) tells
/// the one from which it reaches the GCM. One that listens at one address tells that, and is warned
/// where it leads nowhere for a GCM on another host.
[[nodiscard]] OwnAddress OwnAddressOf(const std::string& listens, const std::string& advertise,
                                      const WayToGcm& way);

/// kInvalid where `advertise`, which is not empty, leads to no process: no address and no host, or
/// every address of a host.
Result<void> CheckAdvertise(const std::string& advertise);

/// Whether an address, "host:port", is one that a host keeps for itself: 127.0.0.0/8, [::1] or
/// "localhost".
[[nodiscard]] bool IsOfOneHost(const std::string& address);

/// For a GCM: why a process that says it is reached at `address`, and whose link comes from `peer`,
/// is not reached from this host; empty where it may well be.
[[nodiscard]] std::string WhyOutOfReach(const std::string& address, const std::string& peer);

}  // namespace tendon
