#include <future>
#include <thread>

#include "conformance/contract.h"
#include "conformance/resources.h"

namespace tendon::conformance {
namespace {

std::vector<std::uint32_t> UpTo(std::uint32_t count) {
  std::vector<std::uint32_t> numbers(count);
  for (std::uint32_t i = 0; i < count; ++i) numbers[i] = i;
  return numbers;
}

/// Sends a frame. While the window is full, tries again.
Status SendPatiently(Link& link, const Bytes& frame) {
  Status status = Status::kQueueFull;
  EventuallyTrue([&] { return (status = link.Send(frame)) != Status::kQueueFull; });
  return status;
}

TEST_P(LinkContract, FramesArriveInOrder) {
  Connect();
  constexpr std::uint32_t kCount = 20000;

  for (std::uint32_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(SendPatiently(*client_, FrameOf(i)), Status::kQueued);
  }

  ASSERT_TRUE(server_recorder_->WaitForFrames(kCount));
  EXPECT_EQ(server_recorder_->numbers(), UpTo(kCount));
  EXPECT_TRUE(server_recorder_->intact());
}

TEST_P(LinkContract, BothEndsSendAtOnce) {
  Connect();
  constexpr std::uint32_t kCount = 5000;

  std::thread server([&] {
    for (std::uint32_t i = 0; i < kCount; ++i) (void)SendPatiently(*server_, FrameOf(i, 100));
  });
  for (std::uint32_t i = 0; i < kCount; ++i) (void)SendPatiently(*client_, FrameOf(i, 1000));
  server.join();

  ASSERT_TRUE(server_recorder_->WaitForFrames(kCount));
  ASSERT_TRUE(client_recorder_->WaitForFrames(kCount));
  EXPECT_EQ(server_recorder_->numbers(), UpTo(kCount));
  EXPECT_EQ(client_recorder_->numbers(), UpTo(kCount));
}

TEST_P(LinkContract, FramesOfSeveralThreadsStayWhole) {
  Connect();
  constexpr std::uint32_t kCount = 2000;

  std::vector<std::thread> threads;
  for (std::uint32_t thread = 0; thread < 3; ++thread) {
    threads.emplace_back([&, thread] {
      for (std::uint32_t i = 0; i < kCount; ++i) {
        (void)SendPatiently(*client_, FrameOf(thread << 16U | i, 500));
      }
    });
  }
  for (auto& thread : threads) thread.join();

  ASSERT_TRUE(server_recorder_->WaitForFrames(3 * kCount));
  EXPECT_TRUE(server_recorder_->intact());
  std::array<std::uint32_t, 3> next{};
  for (const std::uint32_t number : server_recorder_->numbers()) {
    ASSERT_EQ(number & 0xffffU, next.at(number >> 16U)++);
  }
}

TEST_P(LinkContract, TheLargestFrameArrivesWhole) {
  Bytes received;
  Connect([&](std::span<const std::byte> frame) { received.assign(frame.begin(), frame.end()); });
  const Bytes frame = FrameOf(7, kMaxPieceSize - FrameHeader::kSize);

  ASSERT_EQ(client_->Send(frame), Status::kQueued);

  ASSERT_TRUE(server_recorder_->WaitForFrames(1));
  EXPECT_EQ(received, frame);
}

TEST_P(LinkContract, RefusesAFrameOverTheLimitAndStaysOpen) {
  const Bytes frame = FrameOf(7, kMaxPieceSize - FrameHeader::kSize + 1);
  Connect();

  EXPECT_EQ(client_->Send(frame), Status::kInvalid);

  EXPECT_EQ(client_->Send(FrameOf(8)), Status::kQueued);
  ASSERT_TRUE(server_recorder_->WaitForFrames(1));
  EXPECT_EQ(server_recorder_->numbers(), std::vector<std::uint32_t>{8});
}

TEST_P(LinkContract, RefusesBytesThatAreNotAFrame) {
  Connect();
  Bytes frame = FrameOf(7);
  frame.pop_back();

  EXPECT_EQ(client_->Send(frame), Status::kInvalid);
}

TEST_P(LinkContract, AStoppedReceiverMakesTheSenderRefuseAndNotGrow) {
  std::promise<void> go_on;
  const auto gone_on = go_on.get_future().share();
  Connect([gone_on](std::span<const std::byte> /*frame*/) { gone_on.wait(); });
  constexpr std::size_t kSize = 64000;
  constexpr int kMoreAttempts = 2000;

  std::uint32_t sent = 0;
  const bool was_refused = EventuallyTrue([&] {
    const Status status = client_->Send(FrameOf(sent, kSize));
    if (status) ++sent;
    return status == Status::kQueueFull;
  });
  const std::size_t memory = MemoryInUse();
  for (int i = 0; i < kMoreAttempts; ++i) {
    if (client_->Send(FrameOf(sent, kSize))) ++sent;
  }
  const std::size_t now = MemoryInUse();
  const std::size_t grown = now - std::min(memory, now);
  go_on.set_value();

  EXPECT_TRUE(was_refused);
  EXPECT_LT(sent * kSize, std::size_t{32} << 20U) << "the window and what the sockets hold";
  EXPECT_LT(grown, std::size_t{4} << 20U);
  ASSERT_TRUE(server_recorder_->WaitForFrames(sent));
  EXPECT_EQ(server_recorder_->numbers(), UpTo(sent));
  EXPECT_EQ(SendPatiently(*client_, FrameOf(sent)), Status::kQueued);
  EXPECT_TRUE(server_recorder_->WaitForFrames(sent + 1));
}

TEST_P(LinkContract, BothEndsAreNotifiedIfTheOpenerCloses) {
  Connect();

  client_->Close();
  client_->Close();

  ASSERT_TRUE(server_recorder_->WaitForClosed());
  ASSERT_TRUE(client_recorder_->WaitForClosed());
  EXPECT_EQ(client_->Send(FrameOf(1)), Status::kNotConnected);
  EXPECT_EQ(server_->Send(FrameOf(1)), Status::kNotConnected);
  server_->Close();
  pair_ = {};
  EXPECT_EQ(server_recorder_->closed(), 1);
  EXPECT_EQ(client_recorder_->closed(), 1);
}

TEST_P(LinkContract, BothEndsAreNotifiedIfTheAcceptorCloses) {
  Connect();

  server_->Close();

  ASSERT_TRUE(client_recorder_->WaitForClosed());
  ASSERT_TRUE(server_recorder_->WaitForClosed());
  EXPECT_EQ(client_recorder_->reason().code, ErrorCode::kUnreachable);
  EXPECT_FALSE(client_recorder_->reason().message.empty());
  client_->Close();
  pair_ = {};
  EXPECT_EQ(server_recorder_->closed(), 1);
  EXPECT_EQ(client_recorder_->closed(), 1);
}

TEST_P(LinkContract, BothMayCloseAtOnce) {
  Connect();

  std::thread server([&] { server_->Close(); });
  client_->Close();
  server.join();

  ASSERT_TRUE(client_recorder_->WaitForClosed());
  ASSERT_TRUE(server_recorder_->WaitForClosed());
  pair_ = {};
  EXPECT_EQ(server_recorder_->closed(), 1);
  EXPECT_EQ(client_recorder_->closed(), 1);
}

TEST_P(LinkContract, FramesSentBeforeTheCloseStillArrive) {
  Connect();
  constexpr std::uint32_t kCount = 100;

  for (std::uint32_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(client_->Send(FrameOf(i, 50000)), Status::kQueued);
  }
  client_->Close();

  ASSERT_TRUE(server_recorder_->WaitForClosed());
  EXPECT_EQ(server_recorder_->numbers(), UpTo(kCount));
  EXPECT_TRUE(server_recorder_->intact());
}

TEST_P(LinkContract, DeliversNoFrameAfterALocalClose) {
  std::promise<void> closed;
  Connect(nullptr, [&](std::span<const std::byte> /*frame*/) {
    client_->Close();
    closed.set_value();  // set_value() throws if a second frame arrives
  });

  for (std::uint32_t i = 0; i < 100; ++i) (void)server_->Send(FrameOf(i));

  ASSERT_EQ(closed.get_future().wait_for(kTestTimeout), std::future_status::ready);
  ASSERT_TRUE(client_recorder_->WaitForClosed());
  EXPECT_EQ(client_recorder_->numbers().size(), 1U);
}

TEST_P(LinkContract, AHandlerMayAnswerAtOnce) {
  Connect([&](std::span<const std::byte> frame) { (void)server_->Send(frame); });

  (void)client_->Send(FrameOf(5));

  ASSERT_TRUE(client_recorder_->WaitForFrames(1));
  EXPECT_EQ(client_recorder_->numbers(), std::vector<std::uint32_t>{5});
}

TEST_P(LinkContract, TwoLinksBetweenTheSameProcessesAreIndependent) {
  Connect();
  const auto second_recorder = std::make_shared<Recorder>();
  const auto second = Open(second_recorder);
  ASSERT_TRUE(second);
  const auto guest = host_->guest(1);
  ASSERT_NE(guest.link, nullptr);

  ASSERT_EQ((*second)->Send(FrameOf(2)), Status::kQueued);
  ASSERT_TRUE(guest.recorder->WaitForFrames(1));
  client_->Close();
  ASSERT_TRUE(server_recorder_->WaitForClosed());

  EXPECT_EQ(server_recorder_->numbers(), std::vector<std::uint32_t>{});
  EXPECT_EQ(second_recorder->closed(), 0);
  ASSERT_EQ(guest.link->Send(FrameOf(3)), Status::kQueued);
  EXPECT_TRUE(second_recorder->WaitForFrames(1));
}

TEST_P(LinkContract, EachEndNamesTheOther) {
  Connect();

  EXPECT_EQ(client_->peer(), listener_->address());
  EXPECT_EQ(server_->local(), listener_->address());
  EXPECT_EQ(client_->local(), server_->peer());
  EXPECT_TRUE(ParseAddress(server_->peer(), 1)) << server_->peer();
}

}  // namespace
}  // namespace tendon::conformance
