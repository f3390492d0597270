#include <atomic>

#include "conformance/contract.h"
#include "conformance/resources.h"
#include "support/machine/sanitized.h"

namespace tendon::conformance {
namespace {

TEST_P(LifetimeContract, AThousandLinksLeakNothing) {
  Host host;
  Start(host.accept());
  const std::size_t count = test::IsSanitized() ? 200 : 1000;
  const auto once = [&] {
    const auto recorder = std::make_shared<Recorder>();
    const auto link = Open(recorder);
    ASSERT_TRUE(link) << link.error().message;
    ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);
    (*link)->Close();
    ASSERT_TRUE(recorder->WaitForClosed());
    ASSERT_TRUE(EventuallyTrue([&] { return recorder.use_count() == 1; })) << "still held";
  };
  for (int i = 0; i < 10; ++i) ASSERT_NO_FATAL_FAILURE(once());
  const std::size_t descriptors = OpenDescriptors();
  const std::size_t threads = Threads();

  for (std::size_t i = 0; i < count; ++i) ASSERT_NO_FATAL_FAILURE(once());

  EXPECT_TRUE(EventuallyTrue([&] { return OpenDescriptors() <= descriptors; }))
      << OpenDescriptors() << " descriptors, " << descriptors << " before";
  EXPECT_TRUE(EventuallyTrue([&] { return Threads() <= threads + 4; }))
      << Threads() << " threads, " << threads << " before";
  EXPECT_TRUE(EventuallyTrue([&] { return host.count() == count + 10; })) << host.count();
}

TEST_P(LifetimeContract, AMiddlewareLeaksNothing) {
  { const Pair warm_up = GetParam().make(Exposure::kLoopbackOnly); }
  const std::size_t descriptors = OpenDescriptors();
  const std::size_t threads = Threads();

  for (int i = 0; i < 10; ++i) {
    Host host;
    Start(host.accept());
    const auto link = Open(std::make_shared<Recorder>());
    ASSERT_TRUE(link);
    listener_.reset();
    pair_ = {};
  }

  EXPECT_EQ(OpenDescriptors(), descriptors);
  EXPECT_TRUE(EventuallyTrue([&] { return Threads() <= threads; }))
      << Threads() << " > " << threads;
}

TEST_P(LifetimeContract, AListenerClosesItsLinksAndNoEventFollows) {
  std::atomic<bool> is_gone = false;
  std::atomic<int> heard_late = 0;
  Host host([&](const std::shared_ptr<Link>& /*link*/) {
    return std::make_shared<Recorder>([&](std::span<const std::byte> /*frame*/) {
      if (is_gone) ++heard_late;
    });
  });
  Start(host.accept());
  const auto recorder = std::make_shared<Recorder>();
  const auto link = Open(recorder);
  ASSERT_TRUE(link);
  ASSERT_NE(host.guest().link, nullptr);
  std::thread sender(
      [&] { EventuallyTrue([&] { return (*link)->Send(FrameOf(1)) == Status::kNotConnected; }); });
  EXPECT_TRUE(host.guest().recorder->WaitForFrames(1));

  listener_.reset();
  is_gone = true;

  EXPECT_EQ(host.guest().recorder->closed(), 1);
  EXPECT_TRUE(recorder->WaitForClosed());
  sender.join();
  EXPECT_EQ(heard_late, 0);
  EXPECT_EQ(host.count(), 1U);
}

TEST_P(LifetimeContract, AMiddlewareClosesItsLinksAndNoEventFollows) {
  Host host;
  Start(host.accept());
  const auto recorder = std::make_shared<Recorder>();
  const auto link = Open(recorder);
  ASSERT_TRUE(link);
  const auto guest = host.guest();
  ASSERT_NE(guest.link, nullptr);

  pair_.client.reset();

  EXPECT_EQ(recorder->closed(), 1);
  EXPECT_EQ((*link)->Send(FrameOf(1)), Status::kNotConnected);
  (*link)->Close();
  EXPECT_TRUE(guest.recorder->WaitForClosed());
  EXPECT_EQ(recorder->closed(), 1);
}

TEST_P(LifetimeContract, AListenerMayOutliveItsMiddleware) {
  Host host;
  Start(host.accept());
  const std::string address = listener_->address();

  pair_.server.reset();
  const auto link = Open(std::make_shared<Recorder>());
  listener_.reset();

  EXPECT_FALSE(link);
}

TEST_P(LifetimeContract, ARejectedLinkIsClosed) {
  Start([](const std::shared_ptr<Link>& /*link*/) { return nullptr; });
  const auto recorder = std::make_shared<Recorder>();

  const auto link = Open(recorder);

  if (link) {
    EXPECT_TRUE(recorder->WaitForClosed());
  } else {
    EXPECT_EQ(link.error().code, ErrorCode::kUnreachable);
  }
}

TEST_P(LifetimeContract, OpeningDuringListenerShutdownAlwaysEnds) {
  for (int i = 0; i < 20; ++i) {
    Host host;
    Start(host.accept());
    const auto recorder = std::make_shared<Recorder>();
    Result<std::shared_ptr<Link>> link = Error{};
    std::thread opener([&, address = listener_->address()] {
      link = pair_.client->Open(address, recorder, kTestTimeout);
    });

    listener_.reset();
    opener.join();

    if (link) {
      // If a handshake of the kernel ends too late, the kernel may leave the connection half open.
      // The connection ends when data is sent on it. A real opener always sends a Hello.
      Bytes frame;
      WriteFrame({}, {}, frame);
      (void)(*link)->Send(frame);
      EXPECT_TRUE(recorder->WaitForClosed());
    }
  }
}

}  // namespace
}  // namespace tendon::conformance
