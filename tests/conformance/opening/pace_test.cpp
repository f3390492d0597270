#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "conformance/contract.h"

namespace tendon::conformance {
namespace {

std::uint16_t PortOf(int descriptor) {
  sockaddr_in address{};
  socklen_t size = sizeof(address);
  if (getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  return ntohs(address.sin_port);  // the port is at the same position for IPv6
}

/// Returns the congestion control of this program's connections from a port: "bbr".
std::vector<std::string> CongestionControlsAt(const std::string& local) {
  std::vector<std::string> found;
  for (const auto& one : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int descriptor = std::atoi(one.path().filename().c_str());
    sockaddr_storage peer{};
    socklen_t peer_size = sizeof(peer);
    std::array<char, 16> name{};
    socklen_t size = name.size();
    if (PortOf(descriptor) == ParseAddress(local, 1)->port &&
        getpeername(descriptor, reinterpret_cast<sockaddr*>(&peer), &peer_size) == 0 &&
        getsockopt(descriptor, IPPROTO_TCP, TCP_CONGESTION, name.data(), &size) == 0) {
      found.emplace_back(name.data());
    }
  }
  return found;
}

TEST_P(PortContract, LocalLinksUseNoPacing) {
  Host host;
  Meet(host);

  const std::vector<std::string> without_pace{"reno"};
  EXPECT_EQ(CongestionControlsAt(link_->local()), without_pace);
  EXPECT_EQ(CongestionControlsAt(guest_.link->local()), without_pace);
}

}  // namespace
}  // namespace tendon::conformance
