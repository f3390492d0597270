#include <tendon/process/membership/advertised_address.h>

#include <tendon/base/os/route.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/process.h>

#include <optional>
#include <utility>

namespace tendon {
namespace {

/// Splits an address into host and port. Returns nothing if the address of a middleware has another
/// form.
std::optional<HostPort> HostPortOf(const std::string& address) {
  auto place = ParseAddress(address, 0);
  return place ? std::optional(*std::move(place)) : std::nullopt;
}

bool IsEveryHost(const std::string& host) { return host == "0.0.0.0" || host == "::"; }

bool IsLoopbackHost(const std::string& host) {
  return CheckExposure(host, Exposure::kLoopbackOnly).ok();
}

bool IsHostAlone(const std::string& address) {
  return address.find(':') == std::string::npos || address.ends_with(']');
}

/// Returns the host with port 0, as the argument of --listen.
std::string AnyPortOf(const std::string& host) { return ToString(HostPort{host, 0}); }

std::string OutOfReach(const std::string& address, const std::string& host) {
  return "can be reached at " + address +
         " only from its own host, but the GCM is on another host; start this process with "
         "--listen " +
         AnyPortOf(host);
}

/// Returns the warning for a process that listens at every address and reaches its GCM through the
/// loopback address.
std::string ForThisHostOnly(const std::string& listens, const std::string& announced) {
  return "listens at " + listens +
         ", but uses the loopback address to reach its GCM, so it advertises " + announced +
         ", which other hosts cannot reach; if they must reach this process, start it with "
         "--advertise and an address of this host";
}

std::string OnAnotherNetwork(const std::string& listens, const std::string& from) {
  return "listens at " + listens + ", but reaches its GCM from " + from +
         ", which is on another network: hosts on the network of " + from +
         " may be unable to reach this process; start it with --listen " + AnyPortOf(from) +
         ", or with --listen " + AnyPortOf("0.0.0.0") + " to listen on all networks";
}

/// Returns the text in brackets: "Connection refused" for "nobody answers at 127.0.0.1:10705
/// (Connection refused)".
std::string Briefly(const std::string& reason) {
  const std::size_t open = reason.find(" (");
  if (!reason.starts_with("nobody ") || open == reason.npos || reason.back() != ')') return reason;
  return reason.substr(open + 2, reason.size() - open - 3);
}

}  // namespace

AdvertisedAddress AdvertisedAddressOf(const std::string& listens, const std::string& advertise,
                                      const GcmRoute& way) {
  const auto here = HostPortOf(listens);
  if (!advertise.empty() && here && IsHostAlone(advertise)) {
    return {advertise + ":" + std::to_string(here->port), {}};
  }
  if (!advertise.empty()) return {advertise, {}};
  const auto gcm = HostPortOf(way.to);
  if (!here || !gcm || way.from.empty()) return {listens, {}};
  const bool is_other_family = here->host == "0.0.0.0" && way.from.find(':') != std::string::npos;
  if (is_other_family) return {listens, {}};
  if (IsEveryHost(here->host)) {
    const std::string announced = ToString(HostPort{way.from, here->port});
    return {announced,
            IsLoopbackHost(way.from) ? ForThisHostOnly(listens, announced) : std::string()};
  }
  const bool is_gcm_here = IsLoopbackHost(way.from) || os::NumberOf(gcm->host) == way.from;
  const std::string host = os::NumberOf(here->host);
  if (is_gcm_here || host == way.from) return {listens, {}};
  return {listens, IsLoopbackHost(host) ? OutOfReach(listens, way.from)
                                        : OnAnotherNetwork(listens, way.from)};
}

Result<void> CheckAdvertise(const std::string& advertise) {
  const auto place = ParseAddress(IsHostAlone(advertise) ? advertise + ":1" : advertise, 1);
  if (!place) return place.error();
  if (!IsEveryHost(place->host)) return {};
  return Error{
      ErrorCode::kInvalid,
      "--advertise " + advertise +
          " is not an address that others can reach: give an address of this host. Without "
          "--advertise, this process advertises the address from which it reaches the GCM"};
}

bool IsOfOneHost(const std::string& address) {
  const auto place = HostPortOf(address);
  return place && IsLoopbackHost(place->host);
}

std::string WhyOutOfReach(const std::string& address, const std::string& peer) {
  const auto announced = HostPortOf(address);
  const auto from = HostPortOf(peer);
  if (!announced || !from) return {};
  if (!IsLoopbackHost(announced->host) && !IsEveryHost(announced->host)) return {};
  const bool is_here =
      IsLoopbackHost(from->host) || os::AddressTowards(from->host, from->port) == from->host;
  return is_here ? std::string() : OutOfReach(address, from->host);
}

std::string GcmWords(const std::string& address) {
  const bool is_usual = address == "127.0.0.1:" + std::to_string(kDefaultGcmPort);
  return is_usual ? "" : " --gcm " + address;
}

Error NoGcm(const std::string& address, const std::string& reason) {
  if (os::IsNoRouteError(reason)) {
    return {
        ErrorCode::kUnreachable,
        "no route to the GCM at " + address + ": " + reason +
            "; add a route on that host, or give an address of the GCM that this host can reach"};
  }
  return {ErrorCode::kUnreachable, "no GCM at " + address + " (" + Briefly(reason) +
                                       "); start one with: gcm serve" + GcmWords(address)};
}

}  // namespace tendon
