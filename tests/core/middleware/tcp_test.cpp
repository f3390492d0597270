#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <tendon/base/log.h>
#include <tendon/base/os/process.h>
#include <tendon/base/os/socket.h>
#include <tendon/middleware/tcp.h>
#include <unistd.h>

#include "conformance/recorder.h"
#include "support/record.h"

namespace tendon {
namespace {

using conformance::FrameOf;
using conformance::Host;
using conformance::kTestTimeout;
using conformance::Recorder;
using testing::HasSubstr;

/// Returns the warnings of TCP since the first call.
std::vector<std::string> Warnings() {
  static test::Record<std::string> lines;
  static const bool listening = [] {
    AddLogSink([](LogLevel level, std::string_view source, std::string_view text) {
      if (source == "tcp" && level == LogLevel::kWarning) lines.Add(std::string(text));
    });
    return true;
  }();
  return listening ? lines.values() : std::vector<std::string>();
}

/// A listener with one plain socket connected to it.
struct Wire {
  Wire() {
    auto made = middleware->Listen("127.0.0.1:0", host.accept());
    EXPECT_TRUE(made);
    listener = *std::move(made);
    socket = Connect();
  }
  os::Socket Connect() {
    const auto place = ParseAddress(listener->address(), 1);
    auto connected = os::ConnectTo(place->host, place->port, kTestTimeout);
    EXPECT_TRUE(connected);
    return *std::move(connected);
  }

  const std::shared_ptr<Middleware> middleware = MakeTcpMiddleware(Exposure::kLoopbackOnly);
  Host host;
  std::unique_ptr<Listener> listener;
  os::Socket socket;
};

TEST(Tcp, FramesFollowEachOtherDirectly) {
  Wire wire;
  Bytes bytes;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Bytes frame = FrameOf(i, i * 5);
    bytes.insert(bytes.end(), frame.begin(), frame.end());
  }

  ASSERT_EQ(os::SendSome(wire.socket, bytes), bytes.size());

  const auto guest = wire.host.guest();
  ASSERT_TRUE(guest.recorder->WaitForFrames(3));
  EXPECT_EQ(guest.recorder->numbers(), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Tcp, AFrameMayComeByteByByte) {
  Wire wire;
  const Bytes frame = FrameOf(9, 50);

  for (const std::byte byte : frame) {
    ASSERT_EQ(os::SendSome(wire.socket, std::span(&byte, 1)), 1U);
    std::this_thread::yield();
  }

  const auto guest = wire.host.guest();
  ASSERT_TRUE(guest.recorder->WaitForFrames(1));
  EXPECT_EQ(guest.recorder->bytes(), frame.size());
}

TEST(Tcp, APortInUseNamesTheProgram) {
  Wire wire;

  const auto second = wire.middleware->Listen(wire.listener->address(), wire.host.accept());

  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message, wire.listener->address() + " is in use by pid " +
                                        std::to_string(os::ProcessId()) + " (middleware_test)");
}

TEST(Tcp, GarbageAfterAFrameClosesTheLink) {
  Wire wire;
  Bytes bytes = FrameOf(1);
  bytes.resize(bytes.size() + FrameHeader::kSize, std::byte{'x'});

  ASSERT_EQ(os::SendSome(wire.socket, bytes), bytes.size());

  const auto guest = wire.host.guest();
  ASSERT_TRUE(guest.recorder->WaitForClosed());
  EXPECT_EQ(guest.recorder->numbers(), std::vector<std::uint32_t>{1});
  EXPECT_EQ(guest.recorder->reason().code, ErrorCode::kInvalid);
}

TEST(Tcp, LimitsAnAdmittedPeerToOnePiece) {
  Wire wire;
  FrameHeader header;
  header.size = kMaxPieceSize - FrameHeader::kSize + 1;
  Bytes begun(FrameHeader::kSize);
  WriteHeader(header, std::span(begun).first<FrameHeader::kSize>());

  ASSERT_EQ(os::SendSome(wire.socket, begun), begun.size());

  const auto guest = wire.host.guest();
  ASSERT_TRUE(guest.recorder->WaitForClosed());
  EXPECT_EQ(guest.recorder->reason().code, ErrorCode::kInvalid);
}

TEST(Tcp, AFloodOfGarbageIsLoggedOnceWithoutDrowningTheLog) {
  Wire wire;
  const std::size_t before = Warnings().size();

  for (int i = 0; i < 50; ++i) {
    const os::Socket socket = wire.Connect();
    (void)os::SendSome(socket, Bytes(100, std::byte{'x'}));
    Bytes buffer(100);
    ASSERT_TRUE(EventuallyTrue([&] { return !os::ReceiveSome(socket, buffer); }));
  }

  EXPECT_EQ(Warnings().size(), before + 1);
}

TEST(Tcp, ListeningInsecurelyIsLogged) {
  const std::size_t before = Warnings().size();

  const auto middleware = MakeTcpMiddleware(Exposure::kInsecure);
  EXPECT_EQ(Warnings().size(), before);
  Host host;
  const auto listener = middleware->Listen("127.0.0.1:0", host.accept());

  ASSERT_EQ(Warnings().size(), before + 1);
  EXPECT_THAT(Warnings().back(), HasSubstr("--insecure"));
}

TEST(Tcp, OutOfDescriptorsOldLinksStayAndNewOnesWait) {
  Wire wire;
  const auto guest = wire.host.guest();
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const int lowest_free = dup(0);
  close(lowest_free);
  rlimit tight = before;
  // One free descriptor for the opener, and none for the acceptor.
  tight.rlim_cur = static_cast<rlim_t>(lowest_free + 1);
  setrlimit(RLIMIT_NOFILE, &tight);
  const os::Socket last = wire.Connect();

  EXPECT_EQ(os::SendSome(wire.socket, FrameOf(1)), FrameOf(1).size());
  EXPECT_TRUE(guest.recorder->WaitForFrames(1));
  EXPECT_EQ(wire.host.count(), 1U);
  setrlimit(RLIMIT_NOFILE, &before);

  EXPECT_TRUE(EventuallyTrue([&] { return wire.host.count() == 2; }));
}

}  // namespace
}  // namespace tendon
