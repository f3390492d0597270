#include <Ice/Ice.h>
#include <gtest/gtest.h>
#include <tendon.h>  // generated from tendon.ice
#include <tendon/ice/bounded_reader.h>
#include <tendon/ice/ice_middleware.h>

#include <atomic>

#include "conformance/recorder.h"

namespace tendon {
namespace {

using conformance::FrameOf;
using conformance::Host;
using conformance::kTestTimeout;
using conformance::Recorder;

Bytes Plain(const std::vector<Ice::Byte>& bytes) {
  const auto raw = std::as_bytes(std::span(bytes));
  return {raw.begin(), raw.end()};
}

std::vector<Ice::Byte> ForIce(const Bytes& bytes) {
  const auto* begin = reinterpret_cast<const Ice::Byte*>(bytes.data());
  return {begin, begin + bytes.size()};
}

/// An endpoint with the skeleton that Slice generates, as another language would have it.
class GeneratedEndpoint final : public Endpoint {
 public:
  void frame(FrameBytes frame, const Ice::Current& current) override {
    const std::scoped_lock lock(mutex_);
    frames_.push_back(Plain(frame));
    connection_ = current.con;
  }
  FrameBytes ask(FrameBytes frame, const Ice::Current& current) override {
    this->frame(std::move(frame), current);
    const std::scoped_lock lock(mutex_);
    return answer_;
  }
  /// Sets the reply to all later requests.
  void SetAnswer(const Bytes& answer) {
    const std::scoped_lock lock(mutex_);
    answer_ = ForIce(answer);
  }
  std::vector<Bytes> frames() const {
    const std::scoped_lock lock(mutex_);
    return frames_;
  }
  std::shared_ptr<Ice::Connection> connection() const {
    const std::scoped_lock lock(mutex_);
    return connection_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Bytes> frames_;
  FrameBytes answer_;
  std::shared_ptr<Ice::Connection> connection_;
};

/// While it is prompt, answers each frame with the same frame.
class Answerer final : public LinkHandler {
 public:
  void OnFrame(std::span<const std::byte> /*frame*/) override {}
  void OnDirectFrame(std::span<const std::byte> frame, ReplySlot& answer) override {
    if (!is_prompt) return;
    const auto room = answer.Begin(*ReadWholeFrame(frame));
    std::ranges::copy(frame.subspan(FrameHeader::kSize), room->begin());
    answer.End();
  }
  void OnClosed(const Error& /*reason*/) override {}

  std::atomic<bool> is_prompt{true};
};

/// Stores the parameters unchanged.
class Capture final : public Ice::BlobjectArray {
 public:
  bool ice_invoke(std::pair<const Ice::Byte*, const Ice::Byte*> parameters,
                  std::vector<Ice::Byte>& answer, const Ice::Current& /*current*/) override {
    bytes_ = Plain({parameters.first, parameters.second});
    answer = {6, 0, 0, 0, 1, 1};
    return true;
  }
  Bytes bytes_;
};

/// A program that uses only the .ice file, and no code of Tendon.
class Slice : public testing::Test {
 protected:
  std::shared_ptr<Ice::ObjectAdapter> Serve(const std::shared_ptr<Ice::Object>& servant,
                                            const std::string& endpoints) {
    auto adapter = endpoints.empty()
                       ? communicator_->createObjectAdapter("")
                       : communicator_->createObjectAdapterWithEndpoints("test", endpoints);
    adapter->add(servant, Ice::Identity{"tendon", ""});
    adapter->activate();
    return adapter;
  }

  static std::string AddressOf(const Ice::ObjectAdapter& adapter) {
    const auto info =
        std::dynamic_pointer_cast<Ice::TCPEndpointInfo>(adapter.getEndpoints().at(0)->getInfo());
    return "127.0.0.1:" + std::to_string(info->port);
  }

  std::shared_ptr<EndpointPrx> ProxyTo(const std::string& address) {
    const auto place = ParseAddress(address, 1);
    return Ice::uncheckedCast<EndpointPrx>(communicator_->stringToProxy(
        "tendon:tcp -h " + place->host + " -p " + std::to_string(place->port)));
  }

  const Ice::CommunicatorHolder holder_{Ice::initialize(Ice::InitializationData())};
  const std::shared_ptr<Ice::Communicator> communicator_ = holder_.communicator();
};

TEST_F(Slice, GeneratedCodeWritesTheSameBytes) {
  const auto capture = std::make_shared<Capture>();
  const auto adapter = Serve(capture, "tcp -h 127.0.0.1");
  const auto proxy = ProxyTo(AddressOf(*adapter));
  for (const std::size_t size : {0U, 1U, 24U, 253U, 254U, 255U, 256U, 70000U}) {
    const Bytes frame(size, std::byte{9});
    Bytes ours;

    ice::WriteOnlyParameter(frame, ours);
    proxy->frame(ForIce(frame));

    EXPECT_EQ(capture->bytes_, ours) << size;
  }
}

TEST_F(Slice, AGeneratedClientWorksWithOurServer) {
  const auto server = MakeIceMiddleware(Exposure::kLoopbackOnly);
  Host host;
  const auto listener = server->Listen("127.0.0.1:0", host.accept());
  ASSERT_TRUE(listener);
  const auto endpoint = std::make_shared<GeneratedEndpoint>();
  const auto adapter = Serve(endpoint, "");
  const auto proxy = Ice::checkedCast<EndpointPrx>(ProxyTo((*listener)->address()));
  ASSERT_NE(proxy, nullptr);
  proxy->ice_getConnection()->setAdapter(adapter);

  proxy->ice_oneway()->frame(ForIce(FrameOf(5)));
  const auto guest = host.guest();
  ASSERT_NE(guest.link, nullptr);
  ASSERT_EQ(guest.link->Send(FrameOf(6)), Status::kQueued);

  ASSERT_TRUE(guest.recorder->WaitForFrames(1));
  EXPECT_EQ(guest.recorder->numbers(), std::vector<std::uint32_t>{5});
  ASSERT_TRUE(EventuallyTrue([&] { return endpoint->frames().size() == 1; }));
  EXPECT_EQ(endpoint->frames()[0], FrameOf(6));
}

TEST_F(Slice, OurClientWorksWithAGeneratedServer) {
  const auto endpoint = std::make_shared<GeneratedEndpoint>();
  const auto adapter = Serve(endpoint, "tcp -h 127.0.0.1");
  const auto client = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const auto recorder = std::make_shared<Recorder>();
  const auto link = client->Open(AddressOf(*adapter), recorder, kTestTimeout);
  ASSERT_TRUE(link) << link.error().message;

  ASSERT_EQ((*link)->Send(FrameOf(5)), Status::kQueued);
  ASSERT_TRUE(EventuallyTrue([&] { return endpoint->frames().size() == 1; }));
  const auto back = Ice::uncheckedCast<EndpointPrx>(
      endpoint->connection()->createProxy(Ice::Identity{"tendon", ""}));
  back->ice_oneway()->frame(ForIce(FrameOf(6)));

  EXPECT_EQ(endpoint->frames()[0], FrameOf(5));
  ASSERT_TRUE(recorder->WaitForFrames(1));
  EXPECT_EQ(recorder->numbers(), std::vector<std::uint32_t>{6});
}

TEST_F(Slice, AGeneratedClientSendsRequestsToOurServer) {
  const auto server = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const auto handler = std::make_shared<Answerer>();
  const auto listener =
      server->Listen("127.0.0.1:0", [&](const auto& /*link*/) { return handler; });
  ASSERT_TRUE(listener);
  const auto proxy = ProxyTo((*listener)->address());

  EXPECT_EQ(Plain(proxy->ask(ForIce(FrameOf(5)))), FrameOf(5));
  handler->is_prompt = false;
  EXPECT_EQ(Plain(proxy->ask(ForIce(FrameOf(5)))), Bytes());
  EXPECT_THROW(proxy->ask(ForIce(Bytes(30))), Ice::Exception);
}

TEST_F(Slice, OurClientSendsRequestsToAGeneratedServer) {
  const auto endpoint = std::make_shared<GeneratedEndpoint>();
  const auto adapter = Serve(endpoint, "tcp -h 127.0.0.1");
  const auto client = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const auto recorder = std::make_shared<Recorder>();
  const auto link = client->Open(AddressOf(*adapter), recorder, kTestTimeout);
  ASSERT_TRUE(link) << link.error().message;

  // The server does not answer yet.
  ASSERT_EQ((*link)->Send(FrameOf(5), Delivery::kDirect), Status::kQueued);
  ASSERT_TRUE(EventuallyTrue([&] { return endpoint->frames().size() == 1; }));
  endpoint->SetAnswer(FrameOf(7, 1000));
  ASSERT_EQ((*link)->Send(FrameOf(6), Delivery::kDirect), Status::kQueued);

  ASSERT_TRUE(recorder->WaitForFrames(1));
  EXPECT_EQ(endpoint->frames(), (std::vector{FrameOf(5), FrameOf(6)}));
  EXPECT_EQ(recorder->numbers(), std::vector<std::uint32_t>{7});
}

TEST_F(Slice, AReplyThatIsNotAFrameClosesTheLink) {
  const auto endpoint = std::make_shared<GeneratedEndpoint>();
  const auto adapter = Serve(endpoint, "tcp -h 127.0.0.1");
  const auto client = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const auto recorder = std::make_shared<Recorder>();
  const auto link = client->Open(AddressOf(*adapter), recorder, kTestTimeout);
  ASSERT_TRUE(link) << link.error().message;
  endpoint->SetAnswer(Bytes(30));

  ASSERT_EQ((*link)->Send(FrameOf(5), Delivery::kDirect), Status::kQueued);

  ASSERT_TRUE(recorder->WaitForClosed());
  EXPECT_TRUE(recorder->numbers().empty());
  EXPECT_EQ((*link)->Send(FrameOf(6), Delivery::kDirect), Status::kNotConnected);
}

TEST_F(Slice, AnswersUnknownNamesLikeIce) {
  const auto server = MakeIceMiddleware(Exposure::kLoopbackOnly);
  Host host;
  const auto listener = server->Listen("127.0.0.1:0", host.accept());
  ASSERT_TRUE(listener);
  const auto proxy = ProxyTo((*listener)->address());
  std::vector<Ice::Byte> ignored;

  EXPECT_THROW(proxy->ice_invoke("shutdown", Ice::OperationMode::Normal, ignored, ignored),
               Ice::OperationNotExistException);
  EXPECT_THROW(proxy->ice_identity({"admin", ""})->ice_ping(), Ice::ObjectNotExistException);
  EXPECT_THROW(proxy->ice_facet("Process")->ice_ping(), Ice::FacetNotExistException);
  EXPECT_FALSE(proxy->ice_isA("::Ice::Process"));
  EXPECT_NO_THROW(proxy->ice_ping());
}

}  // namespace
}  // namespace tendon
