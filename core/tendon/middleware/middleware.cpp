#include <tendon/middleware/middleware.h>

#include <tendon/base/log.h>

#include <charconv>
#include <optional>
#include <utility>

namespace tendon {
namespace {

std::optional<unsigned> ParseNumber(std::string_view text, unsigned lowest, unsigned highest) {
  unsigned number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, number);
  if (text.empty() || failure != std::errc{} || rest != end) return std::nullopt;
  if (number < lowest || number > highest) return std::nullopt;
  return number;
}

/// Returns true if the text has only characters of host names and addresses, so that it can be
/// printed without quotes.
bool IsHost(std::string_view host) {
  constexpr std::string_view kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_:%";
  return !host.empty() && host.front() != '-' && host.find_first_not_of(kLetters) == host.npos;
}

/// Returns true for four decimal numbers that begin with 127. Parses the whole text, because
/// "127.0.0.1.example" is the name of another host.
bool IsLoopbackNumber(std::string_view host) {
  for (int part = 0; part < 4; ++part) {
    const auto dot = host.find('.');
    if ((part < 3) == (dot == host.npos)) return false;
    const auto number =
        ParseNumber(host.substr(0, dot), part == 0 ? 127 : 0, part == 0 ? 127 : 255);
    if (!number) return false;
    host.remove_prefix(dot == host.npos ? host.size() : dot + 1);
  }
  return true;
}

class PlainListener final : public Listener {
 public:
  PlainListener(std::string address, std::function<void()> close)
      : address_(std::move(address)), close_(std::move(close)) {}
  ~PlainListener() override { close_(); }
  [[nodiscard]] std::string address() const override { return address_; }

 private:
  const std::string address_;
  const std::function<void()> close_;
};

}  // namespace

Error NotAdmitted(const std::string& peer) {
  return {ErrorCode::kTimeout, peer + " connected but did not authenticate within " +
                                   std::to_string(kAdmissionTime.count()) + " s"};
}

void LinkHandler::OnLentFrame(std::span<const std::byte> frame,
                              std::shared_ptr<const void> /*owner*/) {
  OnFrame(frame);
}

void LinkHandler::OnDirectFrame(std::span<const std::byte> frame, ReplySlot& /*slot*/) {
  OnFrame(frame);
}

Error NoFrame(const std::string& peer) {
  return {ErrorCode::kInvalid, peer +
                                   " sent data that is not a valid frame, or a frame that is too "
                                   "large before authentication"};
}

std::unique_ptr<Listener> MakeListener(std::string address, std::function<void()> close) {
  return std::make_unique<PlainListener>(std::move(address), std::move(close));
}

Result<HostPort> ParseAddress(const std::string& address, std::uint16_t lowest_port) {
  const auto colon = address.rfind(':');
  if (colon == address.npos) {
    return Error{ErrorCode::kInvalid,
                 "address '" + address + "': expected host:port, such as 127.0.0.1:10705"};
  }
  std::string host = address.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
    host = host.substr(1, host.size() - 2);
  } else if (host.find(':') != host.npos) {
    return Error{ErrorCode::kInvalid,
                 "address '" + address + "': put an IPv6 host in brackets, such as [::1]:10705"};
  }
  if (!IsHost(host)) {
    return Error{ErrorCode::kInvalid, "address '" + address + "': expected a host before the ':'"};
  }
  const std::string port = address.substr(colon + 1);
  const auto number = ParseNumber(port, lowest_port, 65535);
  if (!number) {
    return Error{ErrorCode::kInvalid,
                 "port '" + port + "': expected " + std::to_string(lowest_port) + "..65535"};
  }
  if (host == "localhost") host = "127.0.0.1";
  return HostPort{host, static_cast<std::uint16_t>(*number)};
}

std::string ToString(const HostPort& address) {
  const bool is_ipv6 = address.host.find(':') != std::string::npos;
  return (is_ipv6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

Result<void> CheckExposure(const std::string& host, Exposure exposure) {
  if (exposure != Exposure::kLoopbackOnly || host == "localhost" || host == "::1" ||
      IsLoopbackNumber(host)) {
    return {};
  }
  return Error{
      ErrorCode::kDenied,
      "host '" + host +
          "' is on another machine and the connection is not encrypted: use 127.0.0.1, encrypt the "
          "connection with --certificate, or allow unencrypted connections with --insecure"};
}

Result<HostPort> ParseAllowedAddress(const std::string& address, std::uint16_t lowest_port,
                                     Exposure exposure) {
  auto place = ParseAddress(address, lowest_port);
  if (!place) return place;
  const auto allowed = CheckExposure(place->host, exposure);
  if (!allowed) return allowed.error();
  return place;
}

void WarnOfExposure(Exposure exposure, std::string_view middleware) {
  if (exposure != Exposure::kInsecure) return;
  Log(LogLevel::kWarning, middleware,
      "--insecure: everybody who can reach the ports of this machine can read and command all "
      "components of this program");
}

}  // namespace tendon
