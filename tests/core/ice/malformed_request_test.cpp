#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/ice/sequence_size_check.h>

#include "conformance/resources.h"
#include "core/ice/attacks.h"

namespace tendon::ice {
namespace {

using conformance::FrameOf;
using conformance::Host;
using conformance::kTestTimeout;
using conformance::Recorder;

constexpr std::size_t kValidateSize = 14;
constexpr std::size_t kReplyStatusAt = 18;

bool IsAnsweredOrEnded(const os::Socket& socket) {
  Bytes buffer(1);
  return EventuallyTrue([&] {
    const auto some = os::ReceiveSome(socket, buffer);
    return !some || !some->empty();
  });
}

class MalformedRequest : public testing::Test {
 protected:
  void SetUp() override {
    auto made = server_->Listen("127.0.0.1:0", host_.accept());
    ASSERT_TRUE(made) << made.error().message;
    listener_ = *std::move(made);
  }

  /// An open link, and the recorders of both ends.
  struct Standing {
    std::shared_ptr<Recorder> recorder;
    std::shared_ptr<Link> link;
    Host::Guest guest;
  };
  void Open(Standing& standing) {
    standing.recorder = std::make_shared<Recorder>();
    auto link = client_->Open(listener_->address(), standing.recorder, kTestTimeout);
    ASSERT_TRUE(link) << link.error().message;
    standing.link = *std::move(link);
    ASSERT_EQ(standing.link->Send(FrameOf(1)), Status::kQueued);
    standing.guest = host_.guest();
    ASSERT_TRUE(standing.guest.recorder->WaitForFrames(1));
  }
  static void ExpectLinkStaysOpen(const Standing& standing) {
    EXPECT_EQ(standing.recorder->closed(), 0);
    EXPECT_EQ(standing.guest.link->Send(FrameOf(2)), Status::kQueued);
    EXPECT_TRUE(standing.recorder->WaitForFrames(1));
  }

  /// Opens a connection. The server has confirmed the connection by its first message.
  os::Socket Connect() {
    const auto place = ParseAddress(listener_->address(), 1);
    auto socket = os::ConnectTo(place->host, place->port, kTestTimeout);
    EXPECT_TRUE(socket);
    EXPECT_EQ(ReceiveAll(*socket, kValidateSize).size(), kValidateSize);
    return *std::move(socket);
  }

  /// Opens a connection from another address of this machine, and from the port of `local`.
  os::Socket ConnectFrom(const std::string& host, const std::string& local) {
    const auto to = ParseAddress(listener_->address(), 1);
    os::Socket socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const auto address_of = [](const std::string& number, std::uint16_t port) {
      sockaddr_in address{.sin_family = AF_INET, .sin_port = htons(port)};
      EXPECT_EQ(inet_pton(AF_INET, number.c_str(), &address.sin_addr), 1);
      return address;
    };
    const sockaddr_in from = address_of(host, ParseAddress(local, 1)->port);
    const sockaddr_in door = address_of(to->host, to->port);
    const auto* const raw_from = reinterpret_cast<const sockaddr*>(&from);
    EXPECT_EQ(bind(socket.descriptor(), raw_from, sizeof(from)), 0);
    const auto* const raw_door = reinterpret_cast<const sockaddr*>(&door);
    EXPECT_EQ(connect(socket.descriptor(), raw_door, sizeof(door)), 0);
    EXPECT_EQ(fcntl(socket.descriptor(), F_SETFL, O_NONBLOCK), 0);
    return socket;
  }

  void ExpectThatTheNextIsServed() {
    const auto link =
        client_->Open(listener_->address(), std::make_shared<Recorder>(), kTestTimeout);
    ASSERT_TRUE(link) << link.error().message;
    const auto guest = host_.guest(host_.count() - 1);
    ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);
    ASSERT_TRUE(guest.recorder->WaitForFrames(1));
    (*link)->Close();
  }

  const std::shared_ptr<Middleware> server_ = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const std::shared_ptr<Middleware> client_ = MakeIceMiddleware(Exposure::kLoopbackOnly);
  Host host_;
  std::unique_ptr<Listener> listener_;
};

TEST(SequenceSizeCheck, ReplacesTheCheckOfIce) {
  const Ice::CommunicatorHolder holder(Ice::initialize(Ice::InitializationData()));

  EXPECT_TRUE(RefusesImpossibleSizes(holder.communicator()))
      << "in this build of Ice one message can exhaust the memory";
}

TEST_F(MalformedRequest, TheServerRepliesOrClosesAndServesTheNext) {
  ASSERT_NO_FATAL_FAILURE(ExpectThatTheNextIsServed());
  const std::size_t memory = conformance::MemoryInUse();

  for (const auto& [name, attack] : Attacks()) {
    SCOPED_TRACE(name);
    const os::Socket socket = Connect();
    SendAll(socket, attack);
    EXPECT_TRUE(IsAnsweredOrEnded(socket));
    ASSERT_NO_FATAL_FAILURE(ExpectThatTheNextIsServed());
  }

  EXPECT_LT(conformance::MemoryInUse(), memory + (std::size_t{16} << 20U));
}

/// Returns the longest valid request that an unauthenticated peer may send.
Bytes LongRequest() {
  const Bytes frame = FrameOf(1, kMaxUnauthenticatedFrameSize - FrameHeader::kSize);
  const std::string_view text(reinterpret_cast<const char*>(frame.data()), frame.size());
  const auto size = static_cast<std::int64_t>(frame.size());
  return Request("frame", 0).Int(size + 11).Byte(1).Byte(1).Size(size).Text(text).Finished();
}

/// Sends a request byte by byte, which would take a minute. Expects that the server closes the
/// connection first.
void ExpectTurnedAwayWhileSlow(const os::Socket& socket) {
  const Bytes request = LongRequest();
  auto said = request.begin();
  Bytes buffer(4096);
  EXPECT_TRUE(EventuallyTrue([&] {
    if (said != request.end()) (void)os::SendSome(socket, std::span(said++, 1));
    return said == request.end() || !os::ReceiveSome(socket, buffer);
  }));
  EXPECT_LT(said - request.begin(), std::ssize(request));
}

TEST_F(MalformedRequest, SingleBytesDoNotExtendTheTimeout) {
  Standing standing;
  ASSERT_NO_FATAL_FAILURE(Open(standing));

  ExpectTurnedAwayWhileSlow(Connect());

  ExpectLinkStaysOpen(standing);
}

TEST_F(MalformedRequest, APeerWithTheSamePortDoesNotDisturbALink) {
  Standing standing;
  ASSERT_NO_FATAL_FAILURE(Open(standing));

  ExpectTurnedAwayWhileSlow(ConnectFrom("127.0.0.2", standing.link->local()));

  ExpectLinkStaysOpen(standing);
}

TEST_F(MalformedRequest, AHugeSequenceIsAnsweredWithAnError) {
  const os::Socket socket = Connect();

  SendAll(socket, WithSequence(kHugeSize).Finished());

  const Bytes reply = ReceiveAll(socket, 4096);
  ASSERT_GT(reply.size(), kReplyStatusAt);
  EXPECT_EQ(reply[8], std::byte{RawMessage::kReply});
  const std::string text(reinterpret_cast<const char*>(reply.data()), reply.size());
  EXPECT_NE(text.find("the parameters of 'frame' are malformed"), std::string::npos) << text;
}

}  // namespace
}  // namespace tendon::ice
