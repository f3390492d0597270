#include <gtest/gtest.h>
#include <tendon/ice/ice_middleware.h>

#include <future>
#include <map>
#include <thread>
#include <vector>

#include "core/ice/raw_ice.h"

namespace tendon::ice {
namespace {

using conformance::Host;
using conformance::kTestTimeout;
using conformance::Recorder;

constexpr std::int64_t kHuge = 0x7fffffff;

/// Returns a reply to one request of a connection; by default, to the first one.
RawMessage Reply(unsigned status, int request = 1) {
  return RawMessage(RawMessage::kReply).Int(request).Byte(status);
}

std::map<std::string, Bytes> Replies() {
  std::map<std::string, Bytes> replies;
  for (const std::int64_t size : {kHuge, std::int64_t{-5}, std::int64_t{0}, std::int64_t{100000}}) {
    const std::string text = std::to_string(size);
    replies["encapsulation of " + text] = Reply(0).Int(size).Byte(1).Byte(1).Finished();
    replies["sequence of " + text] = Reply(0).Int(11).Byte(1).Byte(1).Size(size).Finished();
    replies["exception of " + text] = Reply(1).Int(11).Byte(1).Byte(1).Size(size).Finished();
    replies["no such name of " + text] = Reply(2).Size(size).Text("x").Finished();
    replies["no such facets: " + text] = Reply(3).String("a").String("b").Size(size).Finished();
    replies["unknown failure of " + text] = Reply(5).Size(size).Text("x").Finished();
    replies["message of " + text] = Reply(0).Int(6).Byte(1).Byte(1).Claiming(size);
    replies["compressed from " + text] =
        RawMessage(RawMessage::kReply, 2).Int(size).Text("BZh91AY&SYjunk").Finished();
  }
  replies["unknown status"] = Reply(200).Finished();
  replies["nothing at all"] = RawMessage(RawMessage::kReply).Finished();
  replies["somebody else's"] = RawMessage(RawMessage::kReply).Int(99).Byte(0).Finished();
  replies["garbage"] = Bytes(100, std::byte{0x5a});
  return replies;
}

/// Returns when a request with this operation has arrived. Heartbeats may come before.
void AwaitOperation(const os::Socket& socket, const std::string& name) {
  const std::string wanted = static_cast<char>(name.size()) + name;
  std::string last(wanted.size(), '\0');
  while (last != wanted) {
    const Bytes one = ReceiveAll(socket, 1);
    if (one.empty()) return;  // the client has closed the connection
    last = last.substr(1) + static_cast<char>(one[0]);
  }
}

/// Accepts one connection as a server of Ice, waits for the first request, and sends the given
/// reply. If `ask` is given, it is the reply to the first request.
class LyingServer {
 public:
  explicit LyingServer(Bytes reply, Bytes next = {})
      : thread_([this, reply = std::move(reply), next = std::move(next)] { Serve(reply, next); }) {}
  LyingServer(const LyingServer&) = delete;
  LyingServer& operator=(const LyingServer&) = delete;
  ~LyingServer() { thread_.join(); }

  [[nodiscard]] std::string address() const { return os::LocalAddress(listening_); }

 private:
  void Serve(const Bytes& reply, const Bytes& next) {
    os::Socket socket;
    EventuallyTrue([&] { return os::Accept(listening_, socket) == os::AcceptResult::kOne; });
    SendAll(socket, RawMessage(RawMessage::kValidate).Finished());
    (void)ReceiveAll(socket, 40);  // at least most of the ping
    SendAll(socket, reply);
    if (!next.empty()) {
      AwaitOperation(socket, "ask");
      SendAll(socket, next);
    }
    (void)ReceiveAll(socket, std::size_t{1} << 20U);  // until the client hangs up
  }

  const os::Socket listening_ = *os::ListenAt("127.0.0.1", 0);
  std::thread thread_;
};

TEST(MalformedReply, TheClientSurvivesWithAnErrorOrALink) {
  const auto client = MakeIceMiddleware(Exposure::kLoopbackOnly);
  // All at once, because some calls wait until their time-out.
  std::vector<std::future<void>> opened;
  for (const auto& [name, reply] : Replies()) {
    opened.push_back(std::async(std::launch::async, [&client, name = name, reply = reply] {
      LyingServer liar(reply);

      const auto link =
          client->Open(liar.address(), std::make_shared<Recorder>(), std::chrono::seconds(1));

      if (link) {
        (*link)->Close();
      } else {
        EXPECT_FALSE(link.error().message.empty()) << name;
      }
    }));
  }
  for (auto& one : opened) one.get();

  const auto server = MakeIceMiddleware(Exposure::kLoopbackOnly);
  Host host;
  const auto listener = server->Listen("127.0.0.1:0", host.accept());
  ASSERT_TRUE(listener);
  EXPECT_TRUE(client->Open((*listener)->address(), std::make_shared<Recorder>(), kTestTimeout));
}

TEST(MalformedReply, AFailureOfThePeerIsARefusalAtOnce) {
  const auto client = MakeIceMiddleware(Exposure::kLoopbackOnly);
  for (const Bytes& failure :
       {Reply(7, 2).String("std::bad_alloc").Finished(),
        Reply(2, 2).String("tendon").String("").Byte(0).String("ask").Finished()}) {
    LyingServer liar(Reply(0).Int(6).Byte(1).Byte(1).Finished(), failure);
    std::promise<FrameHeader> heard;
    const auto recorder = std::make_shared<Recorder>(
        [&](std::span<const std::byte> frame) { heard.set_value(*ReadWholeFrame(frame)); });
    const auto link = client->Open(liar.address(), recorder, kTestTimeout);
    ASSERT_TRUE(link) << link.error().message;
    FrameHeader question;
    question.request = 4711;
    Bytes frame;
    WriteFrame(question, {}, frame);

    ASSERT_EQ((*link)->Send(frame, Delivery::kDirect), Status(Status::kQueued));

    auto refusal = heard.get_future();
    ASSERT_EQ(refusal.wait_for(kTestTimeout), std::future_status::ready);
    const FrameHeader header = refusal.get();
    EXPECT_EQ(header.type, MessageType::kRefusal);
    EXPECT_EQ(header.request, 4711U);
    (*link)->Close();
    EXPECT_TRUE(recorder->WaitForClosed());
  }
}

TEST(MalformedReply, AnUnansweredPingTimesOut) {
  const auto client = MakeIceMiddleware(Exposure::kLoopbackOnly);
  LyingServer liar({});

  const auto link =
      client->Open(liar.address(), std::make_shared<Recorder>(), std::chrono::seconds(2));

  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().code, ErrorCode::kTimeout);
  EXPECT_EQ(link.error().message,
            "no reply from " + liar.address() +
                " within 2000 ms: the program at this address hangs, or requires a --certificate");
}

}  // namespace
}  // namespace tendon::ice
