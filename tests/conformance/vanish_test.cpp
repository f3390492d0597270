#include <arpa/inet.h>
#include <linux/filter.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <future>

#include "conformance/contract.h"
#include "conformance/resources.h"
#include "support/wait.h"

namespace tendon::conformance {
namespace {

/// Returns the port; 0 if there is none.
template <typename Query>
std::uint16_t PortOf(int descriptor, Query query) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  if (query(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  return address.sin_family == AF_INET ? ntohs(address.sin_port) : std::uint16_t{0};
}

enum class Ends { kBoth, kOpeners };

/// Makes the kernel drop all data that arrives for this program's connections to `port`,
/// before it acknowledges the data, as if the cable were cut. Returns the number of affected ends.
int CutCable(std::uint16_t port, Ends which = Ends::kBoth) {
  constexpr int kDescriptors = 1024;
  sock_filter drop{BPF_RET | BPF_K, 0, 0, 0};
  const sock_fprog program{1, &drop};
  int ends = 0;
  for (int descriptor = 0; descriptor < kDescriptors; ++descriptor) {
    const std::uint16_t local = PortOf(descriptor, getsockname);
    const std::uint16_t peer = PortOf(descriptor, getpeername);
    if (peer == 0 || (local != port && peer != port)) continue;
    if (which == Ends::kOpeners && local == port) continue;
    ends += setsockopt(descriptor, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0;
  }
  return ends;
}

/// Returns true if the kernel repeatedly sends the data of an opener to `port`.
bool IsRepeated(std::uint16_t port) {
  constexpr int kDescriptors = 1024;
  for (int descriptor = 0; descriptor < kDescriptors; ++descriptor) {
    tcp_info info{};
    socklen_t size = sizeof info;
    if (PortOf(descriptor, getpeername) != port) continue;
    if (getsockopt(descriptor, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) continue;
    if (info.tcpi_unacked > 0 && info.tcpi_retransmits > 1) return true;
  }
  return false;
}

TEST_P(PortContract, SendingDetectsAVanishedOpener) {
  Host host;
  ASSERT_NO_FATAL_FAILURE(Meet(host));
  ASSERT_EQ(CutCable(ParseAddress(listener_->address(), 1)->port), 2);

  ASSERT_EQ(guest_.link->Send(FrameOf(2)), Status::kQueued);

  EXPECT_TRUE(guest_.recorder->WaitForClosed());
}

TEST_P(PortContract, DetectsAVanishedOpenerOnAnIdleLink) {
  Host host;
  ASSERT_NO_FATAL_FAILURE(Meet(host));

  ASSERT_EQ(CutCable(ParseAddress(listener_->address(), 1)->port), 2);

  EXPECT_TRUE(guest_.recorder->WaitForClosed());
}

TEST_P(PortContract, DetectsAVanishedOpenerThatAwaitsAReply) {
  std::promise<std::shared_ptr<Keeper>> asked;
  Start([&](const std::shared_ptr<Link>& link) {
    auto handler = std::make_shared<Keeper>(link);
    asked.set_value(handler);
    return handler;
  });
  const auto link = Open(std::make_shared<Recorder>());
  ASSERT_TRUE(link) << link.error().message;
  const auto keeper = asked.get_future().get();
  ASSERT_EQ((*link)->Send(FrameOf(1), Delivery::kDirect), Status::kQueued);
  const auto reply = keeper->Take();

  ASSERT_EQ(CutCable(ParseAddress(listener_->address(), 1)->port), 2);

  EXPECT_TRUE(keeper->WaitForClosed());
}

TEST_P(PortContract, ClosingACutLinkEndsTheOtherEndAtOnce) {
  Host host;
  ASSERT_NO_FATAL_FAILURE(Meet(host));
  ASSERT_EQ(CutCable(ParseAddress(listener_->address(), 1)->port, Ends::kOpeners), 1);
  ASSERT_TRUE(EventuallyTrue([&] {
    (void)link_->Send(FrameOf(2));
    return IsRepeated(ParseAddress(listener_->address(), 1)->port);
  }));
  (void)link_->Send(FrameOf(3));  // this frame waits behind the repeated data

  link_->Close();

  EXPECT_TRUE(guest_.recorder->WaitForClosed());
}

}  // namespace
}  // namespace tendon::conformance
