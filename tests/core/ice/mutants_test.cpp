#include "core/ice/mutants.h"

#include <poll.h>

#include "conformance/resources.h"
#include "core/ice/tls_client.h"
#include "core/ice/tls_fixture.h"

namespace tendon::ice {
namespace {

using conformance::kTestTimeout;

constexpr std::size_t kMaxGrowth = std::size_t{1} << 20U;

/// A connection without TLS.
class PlainConnection {
 public:
  explicit PlainConnection(const HostPort& place) {
    auto socket = os::ConnectTo(place.host, place.port, kTestTimeout);
    EXPECT_TRUE(socket.ok()) << (socket.ok() ? "" : socket.error().message);
    if (socket.ok()) socket_ = *std::move(socket);
  }

  bool Send(const Bytes& bytes) const { return os::SendSome(socket_, bytes) == bytes.size(); }
  [[nodiscard]] Bytes Receive() const {
    Bytes buffer(4096);
    while (true) {
      pollfd one{.fd = socket_.descriptor(), .events = POLLIN, .revents = 0};
      const auto timeout = std::chrono::duration_cast<std::chrono::milliseconds>(kTestTimeout);
      EXPECT_EQ(poll(&one, 1, static_cast<int>(timeout.count())), 1) << "no reply, no end";
      const auto some = os::ReceiveSome(socket_, buffer);
      if (!some || !one.revents) return {};
      if (!some->empty()) return {some->begin(), some->end()};
    }
  }

 private:
  os::Socket socket_;
};

/// A server that counts the links whose messages it reads, and keeps the first link.
class MutantsTest : public TlsTest {
 protected:
  /// Returns the address at which the server listens.
  HostPort Serve(Middleware& middleware) {
    auto listener = middleware.Listen(
        "127.0.0.1:0", [this](const std::shared_ptr<Link>& link) { return Accept(link); });
    EXPECT_TRUE(listener.ok());
    listener_ = *std::move(listener);
    return *ParseAddress(listener_->address(), 1);
  }

  /// Sends all attacks and then `count` mutants; memory is measured after the first mutants.
  /// Expects that a client with an open link is still served afterwards, and that a new client is
  /// served.
  template <typename Connect>
  void ExpectSurvives(Middleware& good, int count, Connect connect) {
    const auto recorder = std::make_shared<conformance::Recorder>();
    const auto standing = good.Open(listener_->address(), recorder, kTestTimeout);
    ASSERT_TRUE(standing.ok()) << standing.error().message;
    for (const auto& [name, attack] : Attacks()) {
      SCOPED_TRACE(name);
      Conversation(connect()).Bears(attack);
    }
    Mutants mutants;
    SayMutants(mutants, count / 4, connect);
    const std::size_t memory = conformance::MemoryInUse();

    const int connections = SayMutants(mutants, count, connect);

    EXPECT_TRUE(EventuallyTrue([&] { return conformance::MemoryInUse() < memory + kMaxGrowth; }))
        << count << " mutants over " << connections
        << " connections: " << (conformance::MemoryInUse() - memory) / 1024
        << " KiB more than after the warm-up";
    EXPECT_EQ(recorder->closed(), 0);
    ASSERT_EQ((*standing)->Send(conformance::FrameOf(1)), Status::kQueued);
    EXPECT_TRUE(first_->WaitForFrames(1));
    EXPECT_TRUE(good.Open(listener_->address(), recorder, kTestTimeout).ok());
  }

  /// Returns the number of links from which a message was read.
  int heard() const {
    const std::scoped_lock lock(mutex_);
    return heard_;
  }

 private:
  std::shared_ptr<LinkHandler> Accept(const std::shared_ptr<Link>& link) {
    const std::scoped_lock lock(mutex_);
    if (++heard_ > 1) return std::make_shared<conformance::Recorder>();
    link->Admit();
    return first_;
  }

  const std::shared_ptr<conformance::Recorder> first_ = std::make_shared<conformance::Recorder>();
  mutable std::mutex mutex_;
  int heard_ = 0;
  std::unique_ptr<Listener> listener_;
};

TEST_F(MutantsTest, AServerWithoutTlsSurvivesThem) {
  const auto server = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const auto client = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const HostPort place = Serve(*server);

  ExpectSurvives(*client, MutantsWithoutTls(), [&] { return PlainConnection(place); });
}

TEST_F(MutantsTest, AServerSurvivesThemFromInsideTls) {
  const HostPort place = Serve(*robot_);
  const TlsClient insider(Issue({.name = "eve"}).certificate_file);

  ExpectSurvives(*As({.name = "anna"}), MutantsInTls(), [&] { return insider.ConnectTo(place); });
}

TEST_F(MutantsTest, UnencryptedMessagesAreNotRead) {
  const HostPort place = Serve(*robot_);

  ExpectSurvives(*As({.name = "anna"}), MutantsWithoutTls(),
                 [&] { return PlainConnection(place); });

  EXPECT_EQ(heard(), 2);
}

TEST_F(MutantsTest, MessagesWithoutACertificateAreNotRead) {
  const HostPort place = Serve(*robot_);
  const TlsClient peer(std::nullopt);
  const int count = MutantsWithoutTls() / 20;  // each mutant needs a handshake

  ExpectSurvives(*As({.name = "anna"}), count, [&] { return peer.ConnectTo(place); });

  EXPECT_EQ(heard(), 2);
}

}  // namespace
}  // namespace tendon::ice
