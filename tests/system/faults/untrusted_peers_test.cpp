#include <sys/resource.h>
#include <tendon/base/os/socket.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/middleware/channel.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/ice/attacks.h"
#include "support/machine/sanitized.h"
#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/footprint.h"
#include "system/faults/harness/thread_limit.h"

namespace faults {
namespace {

using tendon::Bytes;
using tendon::Channel;
using tendon::ChannelHandler;
using testing::HasSubstr;
namespace os = tendon::os;

Bytes BytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// Returns the first bytes of other kinds of programs, and bytes that no program sends.
std::vector<Bytes> Hellos() {
  return {BytesOf("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUser-Agent: curl\r\n\r\n"),
          BytesOf("SSH-2.0-OpenSSH_9.2p1 Debian-2+deb12u3\r\n"),
          BytesOf(std::string_view("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03zzzzzzzzzzz", 22)),
          Bytes(4096, std::byte{0}), Bytes(4096, std::byte{0xff})};
}

/// Returns valid messages; the test damages them.
std::vector<Bytes> Messages() {
  tendon::FrameHeader header;
  header.request = 1;
  header.size = 64;
  Bytes frame;
  WriteFrame(header, Bytes(header.size, std::byte{3}), frame);
  Bytes request = tendon::ice::WithSequence(4).Finished();
  return {std::move(frame), std::move(request)};
}

/// Stores the refusal that it receives.
class RefusalListener final : public tendon::LinkHandler {
 public:
  void OnFrame(std::span<const std::byte> frame) override {
    const auto header = tendon::ReadWholeFrame(frame);
    if (!header || header->type != tendon::MessageType::kRefusal) return;
    const std::scoped_lock lock(mutex_);
    refusal_ = tendon::ReadRefusal(frame.subspan(tendon::FrameHeader::kSize), "the peer");
  }
  void OnClosed(const tendon::Error& /*reason*/) override {}

  [[nodiscard]] std::optional<tendon::Error> refusal() const {
    const std::scoped_lock lock(mutex_);
    return refusal_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<tendon::Error> refusal_;
};

class UntrustedPeers : public FaultTest {
 protected:
  static os::Socket Knock(const std::string& address) {
    const auto place = tendon::ParseAddress(address, 1);
    auto socket = os::ConnectTo(place->host, place->port, Timeout());
    EXPECT_TRUE(socket) << socket.error().message;
    return socket ? *std::move(socket) : os::Socket();
  }
  /// Returns the first frame of a program with this protocol version.
  static Bytes HelloOfVersion(std::uint16_t version) {
    constexpr std::uint32_t kSize = 64;
    Bytes frame;
    tendon::WriteFrame(
        {.version = version, .type = tendon::MessageType::kHello, .request = 1, .size = kSize},
        Bytes(kSize, std::byte{3}), frame);
    return frame;
  }
  static void Say(const std::string& address, const Bytes& bytes) {
    (void)os::SendSome(Knock(address), bytes);
  }
  static bool IsTurnedAway(const os::Socket& socket) {
    Bytes buffer(4096);
    return Eventually([&] { return !os::ReceiveSome(socket, buffer); });
  }

  /// Starts the system. Finds the addresses of both listening programs.
  void Begin() {
    ASSERT_NO_FATAL_FAILURE(StartSystem());
    ports_ = {gcm_address_, AddressOf("robot")};
    before_ = {FootprintOf(gcm_->pid()), FootprintOf(robot_->pid())};
  }
  void ExpectNobodyDisturbed() {
    std::vector<Footprint> now;
    EXPECT_TRUE(Eventually([&] {
      now = {FootprintOf(gcm_->pid()), FootprintOf(robot_->pid())};
      return IsFlat(before_[0], now[0]) && IsFlat(before_[1], now[1]);
    })) << "GCM: "
        << before_[0] << "; now " << now[0] << "\nrobot: " << before_[1] << "; now " << now[1];
    EXPECT_EQ(Gcm({"ls"}).exit_code, 0) << "the next is served";
    for (const char* name : {"robot", "desk"}) ExpectNeverLost(name);
    ASSERT_TRUE(Flows());
    ExpectNoRowLost();
    ExpectHonestCommands();
  }

  std::vector<std::string> ports_;
  std::vector<Footprint> before_;
};

INSTANTIATE_TEST_SUITE_P(Over, UntrustedPeers, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(UntrustedPeers, OtherProtocolsAreDisconnected) {
  ASSERT_NO_FATAL_FAILURE(Begin());

  std::vector<os::Socket> peers;
  for (const std::string& port : ports_) {
    for (const Bytes& hello : Hellos()) {
      peers.push_back(Knock(port));
      (void)os::SendSome(peers.back(), hello);
    }
  }

  for (const os::Socket& peer : peers) EXPECT_TRUE(IsTurnedAway(peer));
  peers.clear();
  ExpectNobodyDisturbed();
}

TEST_P(UntrustedPeers, DamagedMessagesDoNotDisturbTheSystem) {
  ASSERT_NO_FATAL_FAILURE(Begin());
  const std::vector<Bytes> messages = Messages();
  std::mt19937 random(4711);
  const int count = Size(400, 100'000);

  for (int i = 0; i < count; ++i) {
    Bytes damaged = messages[random() % messages.size()];
    for (unsigned change = 0; change <= random() % 4U; ++change) {
      damaged[random() % damaged.size()] = static_cast<std::byte>(random());
    }
    Say(ports_[random() % ports_.size()], damaged);
  }

  Tell(std::to_string(count) + " damaged messages");
  ExpectNobodyDisturbed();
  for (const auto* program : {gcm_.get(), robot_.get()}) {
    const std::string said = program->err();
    EXPECT_LT(std::count(said.begin(), said.end(), '\n'), 50) << said;
  }
}

TEST_P(UntrustedPeers, AllProgramsSurviveMalformedIceMessages) {
  ASSERT_NO_FATAL_FAILURE(Begin());

  for (const std::string& port : ports_) {
    for (const auto& [name, attack] : tendon::ice::Attacks()) {
      SCOPED_TRACE(name);
      Say(port, attack);
    }
  }

  ExpectNobodyDisturbed();
}

TEST_P(UntrustedPeers, AnotherProtocolVersionIsRefusedWithAReason) {
  ASSERT_NO_FATAL_FAILURE(Begin());
  const auto middleware = NewMiddleware();
  constexpr int kOurs = tendon::FrameHeader::kProtocolVersion;

  for (const std::string& port : ports_) {
    for (const int version : {kOurs + 1, kOurs - 1}) {
      const auto listener = std::make_shared<RefusalListener>();
      const auto link = middleware->Open(port, listener, Timeout());
      ASSERT_TRUE(link) << link.error().message;
      EXPECT_TRUE((*link)->Send(HelloOfVersion(static_cast<std::uint16_t>(version))));
      EXPECT_TRUE(Eventually([&] { return listener->refusal().has_value(); }));
      const tendon::Error refusal = listener->refusal().value_or(tendon::Error{});
      EXPECT_EQ(refusal.code, tendon::ErrorCode::kIncompatible);
      EXPECT_THAT(refusal.message, HasSubstr("speaks protocol version " + std::to_string(kOurs) +
                                             ", but this program speaks version " +
                                             std::to_string(version) + ": update "));
      (*link)->Close();
    }
  }

  ExpectNobodyDisturbed();
}

TEST_P(UntrustedPeers, AConnectionFloodIsServedAndIdleOnesAreClosed) {
  ASSERT_NO_FATAL_FAILURE(Begin());
  const int count = Size(60, 500);
  std::vector<os::Socket> idle;
  for (int i = 0; i < count; ++i) {
    idle.push_back(Knock(gcm_address_));
    idle.push_back(Knock(gcm_address_));
    (void)os::SendSome(idle.back(), Bytes(11, std::byte{0x54}));  // half of a header
  }

  const Stopwatch since_storm;
  {
    constexpr int kThreads = 8;
    const auto middleware = NewMiddleware();
    const tendon::Hello hello{.instance = 1, .name = "storm", .cookie = *tendon::LoopbackCookie()};
    std::atomic<int> left = count;
    std::atomic<int> served = 0;
    std::vector<std::jthread> threads;
    for (int i = 0; i < kThreads; ++i) {
      threads.emplace_back([&] {
        while (left-- > 0) {
          const auto channel = Channel::Open(*middleware, gcm_address_, hello,
                                             std::make_shared<ChannelHandler>(), Timeout());
          if (channel) ++served;
        }
      });
    }
    threads.clear();
    Tell(std::to_string(count) + " clients were served within " +
         std::to_string(since_storm.milliseconds()) + " ms, beside " + std::to_string(idle.size()) +
         " idle ones");
    EXPECT_EQ(served, count);
  }

  for (const os::Socket& socket : idle) EXPECT_TRUE(IsTurnedAway(socket));
  idle.clear();
  ExpectNobodyDisturbed();
}

TEST_P(UntrustedPeers, OutOfDescriptorsKeepsOldConnectionsAndDelaysNewOnes) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const int used = static_cast<int>(FootprintOf(gcm_->pid()).descriptors);
  rlimit limit{};
  ASSERT_EQ(prlimit(gcm_->pid(), RLIMIT_NOFILE, nullptr, &limit), 0);
  const rlim_t usual = std::exchange(limit.rlim_cur, static_cast<rlim_t>(used + 8));
  ASSERT_EQ(prlimit(gcm_->pid(), RLIMIT_NOFILE, &limit, nullptr), 0);

  std::vector<os::Socket> crowd;
  const auto place = tendon::ParseAddress(gcm_address_, 1);
  // They wait or are refused, because Ice stops listening for a second.
  for (int i = 0; i < 30; ++i) {
    if (auto one = os::ConnectTo(place->host, place->port, Timeout())) {
      crowd.push_back(*std::move(one));
    }
  }
  EXPECT_TRUE(Eventually([&] {
    return gcm_->err().find("oo many open files") != std::string::npos;
  })) << gcm_->err();
  ASSERT_TRUE(Flows());
  ExpectNeverLost("robot");

  crowd.clear();
  EXPECT_TRUE(Eventually([&] { return Gcm({"ls"}).exit_code == 0; })) << "there is room again";
  limit.rlim_cur = usual;
  prlimit(gcm_->pid(), RLIMIT_NOFILE, &limit, nullptr);
  ExpectNoRowLost();
  ExpectHonestCommands();
}

TEST_P(UntrustedPeers, OutOfThreadsKeepsConnectionsAndRefusesACommand) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  {
    const ThreadLimit of_gcm(gcm_->pid());
    const ThreadLimit of_robot(robot_->pid());
    if (!of_gcm.holds() || !of_robot.holds()) {
      GTEST_SKIP() << "this machine offers no way to limit the threads of a process";
    }

    const Outcome order = Gcm({"classes", "robot"});

    EXPECT_EQ(order.exit_code, 1);
    EXPECT_THAT(order.err, HasSubstr("process 'robot' cannot create more threads (ulimit -u)"));
    EXPECT_EQ(Gcm({"ls"}).exit_code, 0) << "who needs no thread is served";
    ASSERT_TRUE(Flows());
  }

  const Outcome order = Gcm({"classes", "robot"});
  EXPECT_EQ(order.exit_code, 0) << "there is room again: " << order.err;
  for (const char* name : {"robot", "desk"}) ExpectNeverLost(name);
  ExpectNoRowLost();
  ExpectHonestCommands();
}

TEST_P(UntrustedPeers, OutOfMemoryKeepsConnectionsAndRefusesALargeMessage) {
  if (tendon::test::IsSanitized()) {
    GTEST_SKIP() << "a sanitizer ends the process instead of throwing";
  }
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const auto middleware = NewMiddleware();
  const tendon::Hello hello{.instance = 1, .name = "giant", .cookie = *tendon::LoopbackCookie()};
  const auto ask = [&]() -> tendon::Error {
    const auto channel = Channel::Open(*middleware, gcm_address_, hello,
                                       std::make_shared<ChannelHandler>(), Timeout());
    if (!channel) return channel.error();
    return (*channel)
        ->Call(tendon::message::kJoin, 0, Bytes(tendon::kMaxPayload), Timeout())
        .error();
  };
  rlimit limit{};
  ASSERT_EQ(prlimit(gcm_->pid(), RLIMIT_AS, nullptr, &limit), 0);
  const rlim_t room = AddressSpaceOf(gcm_->pid()) + (std::size_t{16} << 20U);
  const rlim_t usual = std::exchange(limit.rlim_cur, room);
  ASSERT_EQ(prlimit(gcm_->pid(), RLIMIT_AS, &limit, nullptr), 0);

  EXPECT_EQ(ask().code, tendon::ErrorCode::kUnreachable);

  EXPECT_TRUE(Eventually([&] { return gcm_->err().find("ulimit -v") != std::string::npos; }))
      << gcm_->err();
  EXPECT_EQ(Gcm({"ls"}).exit_code, 0) << "small ones are served";
  ASSERT_TRUE(Flows());
  ExpectNeverLost("robot");

  limit.rlim_cur = usual;
  ASSERT_EQ(prlimit(gcm_->pid(), RLIMIT_AS, &limit, nullptr), 0);
  EXPECT_EQ(ask().code, tendon::ErrorCode::kInvalid) << "there is room again, and it is no Join";
  ExpectNoRowLost();
  ExpectHonestCommands();
}

}  // namespace
}  // namespace faults
