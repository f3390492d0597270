#include <tendon/base/os/socket.h>

#include <cstring>
#include <random>

#include "conformance/contract.h"
#include "conformance/resources.h"

namespace tendon::conformance {
namespace {

Bytes BytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

Bytes RandomBytes(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  Bytes bytes(size);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
  return bytes;
}

/// Returns bytes that other kinds of programs send to an open port.
std::vector<Bytes> Garbage() {
  std::vector<Bytes> garbage{
      BytesOf("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUser-Agent: curl\r\n\r\n"),
      BytesOf("SSH-2.0-OpenSSH_9.2p1 Debian-2+deb12u3\r\n"),
      BytesOf(std::string_view("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03zzzzzzzzzzzzzzz", 26)),
      Bytes(4096, std::byte{0}), Bytes(4096, std::byte{0xff})};
  for (unsigned seed = 1; seed <= 20; ++seed) garbage.push_back(RandomBytes(seed * 37 + 24, seed));
  return garbage;
}

/// A program that connects but never authenticates.
class UnauthenticatedPeer {
 public:
  explicit UnauthenticatedPeer(const std::string& address) {
    const auto place = ParseAddress(address, 1);
    auto socket = os::ConnectTo(place->host, place->port, kTestTimeout);
    EXPECT_TRUE(socket);
    if (socket) socket_ = *std::move(socket);
  }

  void Say(const Bytes& bytes) { (void)os::SendSome(socket_, bytes); }

  /// Returns true if the other end closes the connection.
  bool IsTurnedAway() {
    Bytes buffer(4096);
    return EventuallyTrue([&] { return !os::ReceiveSome(socket_, buffer); });
  }
  /// Sends `end` byte by byte. Returns true if the other end closes the connection before the last
  /// byte.
  bool IsTurnedAwayBefore(const Bytes& end) {
    Bytes buffer(4096);
    std::size_t said = 0;
    return EventuallyTrue([&] {
             if (said < end.size()) Say({end[said++]});
             return said == end.size() || !os::ReceiveSome(socket_, buffer);
           }) &&
           said < end.size();
  }

 private:
  os::Socket socket_;
};

TEST_P(PortContract, GarbageIsRejectedWithoutDisturbingOthers) {
  Host host;
  Start(host.accept());
  const auto recorder = std::make_shared<Recorder>();
  const auto link = Open(recorder);
  ASSERT_TRUE(link);
  const auto guest = host.guest();
  const std::size_t memory = MemoryInUse();

  for (const Bytes& garbage : Garbage()) {
    UnauthenticatedPeer peer(listener_->address());
    peer.Say(garbage);
    ASSERT_TRUE(peer.IsTurnedAway());
  }

  constexpr std::size_t kFlat = std::size_t{16} << 20U;
  EXPECT_TRUE(EventuallyTrue([&] { return MemoryInUse() < memory + kFlat; }));
  EXPECT_EQ((*link)->Send(FrameOf(3)), Status::kQueued);
  EXPECT_TRUE(guest.recorder->WaitForFrames(1));
  EXPECT_EQ(recorder->closed(), 0);
  EXPECT_TRUE(Open(std::make_shared<Recorder>()));
}

TEST_P(PortContract, RejectsImpossibleSizes) {
  Host host;
  Start(host.accept());
  for (const std::uint32_t size : {0x7fffffffU, 0xffffffffU, std::uint32_t{kMaxFrameSize}}) {
    Bytes frame = FrameOf(1);
    std::memcpy(frame.data() + offsetof(FrameHeader, size), &size, sizeof(size));
    UnauthenticatedPeer peer(listener_->address());

    peer.Say(frame);

    EXPECT_TRUE(peer.IsTurnedAway()) << size;
  }
  EXPECT_TRUE(Open(std::make_shared<Recorder>()));
}

/// Returns the largest frame that an unauthenticated peer may send, plus `more` bytes.
Bytes LargestFrame(std::uint32_t number, std::size_t more) {
  return FrameOf(number, kMaxUnauthenticatedFrameSize - FrameHeader::kSize + more);
}

TEST_P(LifetimeContract, AnUnadmittedOpenerMaySendOnlySmallFrames) {
  for (const std::size_t more : {std::size_t{1}, kMaxPieceSize - kMaxUnauthenticatedFrameSize}) {
    Host host(Host::Guests::kUnauthenticated);
    Start(host.accept());
    const auto recorder = std::make_shared<Recorder>();
    const auto link = Open(recorder);
    ASSERT_TRUE(link);
    ASSERT_EQ((*link)->Send(LargestFrame(1, 0)), Status::kQueued);
    const auto guest = host.guest();
    ASSERT_TRUE(guest.recorder->WaitForFrames(1));

    ASSERT_EQ((*link)->Send(LargestFrame(2, more)), Status::kQueued);

    EXPECT_TRUE(guest.recorder->WaitForClosed());
    EXPECT_TRUE(recorder->WaitForClosed());
    EXPECT_EQ(guest.recorder->numbers(), std::vector<std::uint32_t>{1});
    listener_.reset();
  }
}

TEST_P(LifetimeContract, AnUnadmittedAcceptorMaySendOnlySmallFrames) {
  Host host;
  Start(host.accept());
  const auto recorder = std::make_shared<Recorder>();
  const auto link = OpenUnauthenticated(recorder);
  ASSERT_TRUE(link);
  ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);
  const auto guest = host.guest();
  ASSERT_TRUE(guest.recorder->WaitForFrames(1));

  ASSERT_EQ(guest.link->Send(LargestFrame(2, 1)), Status::kQueued);

  EXPECT_TRUE(recorder->WaitForClosed());
  EXPECT_TRUE(recorder->numbers().empty());
}

TEST_P(LifetimeContract, AnAdmittedPeerMaySendLargeFrames) {
  Host host(Host::Guests::kUnauthenticated);
  Start(host.accept());
  const auto link = Open(std::make_shared<Recorder>());
  ASSERT_TRUE(link);
  ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);
  const auto guest = host.guest();
  ASSERT_TRUE(guest.recorder->WaitForFrames(1));

  guest.link->Admit();
  ASSERT_EQ((*link)->Send(FrameOf(2, kMaxPieceSize - FrameHeader::kSize)), Status::kQueued);

  EXPECT_TRUE(guest.recorder->WaitForFrames(2));
  EXPECT_EQ(guest.recorder->closed(), 0);
}

TEST_P(PortContract, AnUnadmittedPeerIsDisconnectedInTime) {
  Host host(Host::Guests::kUnauthenticated);
  Start(host.accept());
  const auto recorder = std::make_shared<Recorder>();
  const auto link = Open(recorder);
  ASSERT_TRUE(link);

  ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);

  EXPECT_TRUE(recorder->WaitForClosed());
  EXPECT_TRUE(host.guest().recorder->WaitForClosed());
}

TEST_P(PortContract, SilentNewcomersTimeOutButIdleLinksDoNot) {
  Host host(Host::Guests::kUnauthenticated);
  const auto recorder = std::make_shared<Recorder>();
  ASSERT_NO_FATAL_FAILURE(Meet(host, recorder));
  guest_.link->Admit();
  UnauthenticatedPeer silent(listener_->address());
  UnauthenticatedPeer half(listener_->address());

  half.Say(Bytes(11, std::byte{0x54}));

  EXPECT_TRUE(silent.IsTurnedAway());
  EXPECT_TRUE(half.IsTurnedAway());
  EXPECT_EQ(recorder->closed(), 0);
  EXPECT_EQ(guest_.recorder->closed(), 0);
  EXPECT_EQ(guest_.link->Send(FrameOf(1)), Status::kQueued);
  EXPECT_TRUE(recorder->WaitForFrames(1));
  EXPECT_TRUE(Open(std::make_shared<Recorder>()));
}

TEST_P(UnfinishedContract, SingleBytesDoNotExtendTheTimeout) {
  Host host(Host::Guests::kUnauthenticated);
  const auto recorder = std::make_shared<Recorder>();
  ASSERT_NO_FATAL_FAILURE(Meet(host, recorder));
  guest_.link->Admit();

  // Sending all bytes would take a minute.
  EXPECT_TRUE(UnauthenticatedPeer(listener_->address()).IsTurnedAwayBefore(LargestFrame(1, 0)));

  EXPECT_EQ(recorder->closed(), 0);
  EXPECT_EQ(guest_.link->Send(FrameOf(1)), Status::kQueued);
  EXPECT_TRUE(recorder->WaitForFrames(1));
}

}  // namespace
}  // namespace tendon::conformance
