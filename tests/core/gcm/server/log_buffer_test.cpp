#include <gtest/gtest.h>
#include <tendon/base/os/process.h>
#include <tendon/gcm/server/log_buffer.h>
#include <tendon/middleware/loopback.h>
#include <tests/support/wait.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon {
namespace {

using message::LogRecord;
using message::LogRecords;
using server::LogBuffer;

constexpr std::uint64_t kInstance = 17;

Hello Greeting(const std::string& name) {
  return {.instance = os::RandomNumber(), .name = name, .cookie = *LoopbackCookie()};
}

/// Receives batches like a viewer.
class Viewer final : public ChannelHandler {
 public:
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    if (header.type != message::kLogRecords) {
      is_stuck = true;
      const std::scoped_lock held(gate);
      return;
    }
    const auto batch = DecodeBody<LogRecords>(body);
    ASSERT_TRUE(batch);
    const std::scoped_lock lock(mutex_);
    if (count_ == 0) first_ = batch->before;
    if (batch->before > next_ && count_ > 0) missed_ += batch->before - next_;
    next_ = batch->before + batch->records.size();
    count_ += batch->records.size();
    newest_ = batch->records.back();
  }

  [[nodiscard]] std::uint64_t first() const { return Locked(first_); }
  [[nodiscard]] std::uint64_t next() const { return Locked(next_); }
  [[nodiscard]] std::uint64_t count() const { return Locked(count_); }
  [[nodiscard]] std::uint64_t missed() const { return Locked(missed_); }
  [[nodiscard]] LogRecord newest() const { return Locked(newest_); }

  std::mutex gate;  ///< while this is locked, the viewer reads nothing after its next message
  std::atomic<bool> is_stuck{false};

 private:
  template <typename T>
  [[nodiscard]] T Locked(const T& value) const {
    const std::scoped_lock lock(mutex_);
    return value;
  }

  mutable std::mutex mutex_;
  std::uint64_t first_ = 0;
  std::uint64_t next_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t missed_ = 0;
  LogRecord newest_;
};

class LogBufferTest : public testing::Test {
 protected:
  /// Returns the GCM's channel to a viewer with its own middleware.
  [[nodiscard]] std::shared_ptr<Channel> ChannelTo(const std::shared_ptr<Viewer>& viewer) {
    viewers_.push_back(std::make_unique<LoopbackMiddleware>(network_));
    auto listener = viewers_.back()->Listen(
        "127.0.0.1:0", Channel::Acceptor(Greeting("viewer"), [viewer] { return viewer; }));
    listeners_.push_back(*std::move(listener));
    auto channel = Channel::Open(middleware_, listeners_.back()->address(), Greeting("gcm"),
                                 std::make_shared<ChannelHandler>(), std::chrono::seconds(20));
    EXPECT_TRUE(channel) << channel.error().message;
    return *channel;
  }
  /// Adds `count` records of the robot.
  void Write(std::size_t count) {
    book.Add("robot", kInstance, {written_, std::vector(count, LogRecord{.text = "x"})});
    written_ += count;
  }

  LogBuffer book;

 private:
  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware middleware_{network_};
  std::vector<std::unique_ptr<LoopbackMiddleware>> viewers_;
  std::vector<std::unique_ptr<Listener>> listeners_;
  std::uint64_t written_ = 0;
};

TEST_F(LogBufferTest, KeepsTheNewestForLaterViewers) {
  Write(LogBuffer::kKept + 100);
  const auto viewer = std::make_shared<Viewer>();

  const auto watched = book.Watch(ChannelTo(viewer), 0);
  book.Pump();

  EXPECT_EQ(watched.begin, 100U);
  EXPECT_EQ(watched.end, LogBuffer::kKept + 100);
  ASSERT_TRUE(EventuallyTrue([&] { return viewer->count() == LogBuffer::kKept; }));
  EXPECT_EQ(viewer->first(), 100U);
}

TEST_F(LogBufferTest, ResumesWhereAViewerStopped) {
  Write(100);
  const auto viewer = std::make_shared<Viewer>();

  const auto watched = book.Watch(ChannelTo(viewer), 70);
  book.Pump();

  EXPECT_EQ(watched.begin, 70U);
  ASSERT_TRUE(EventuallyTrue([&] { return viewer->count() == 30; }));
  EXPECT_EQ(viewer->first(), 70U);
}

TEST_F(LogBufferTest, IgnoresAViewerPositionInTheFuture) {
  Write(100);
  const auto viewer = std::make_shared<Viewer>();

  EXPECT_EQ(book.Watch(ChannelTo(viewer), 1000).begin, 100U);
  Write(1);
  book.Pump();

  EXPECT_TRUE(EventuallyTrue([&] { return viewer->count() == 1; }));
}

TEST_F(LogBufferTest, ASlowViewerDelaysNobodyAndSeesItsLosses) {
  const auto stuck = std::make_shared<Viewer>();
  const auto quick = std::make_shared<Viewer>();
  const auto full = ChannelTo(stuck);
  book.Watch(full, 0);
  book.Watch(ChannelTo(quick), 0);
  Write(1);
  book.Pump();
  ASSERT_TRUE(EventuallyTrue([&] { return stuck->count() == 1; }));
  std::unique_lock held(stuck->gate);
  ASSERT_TRUE(full->Notify(MessageType{0xffff}, 0, Bytes(1)));
  ASSERT_TRUE(EventuallyTrue([&] { return stuck->is_stuck.load(); }));
  for (std::size_t size = std::size_t{1} << 20U; size > 0; size /= 2) {
    while (full->Notify(MessageType{0xffff}, 0, Bytes(size))) {
    }
  }
  constexpr std::uint64_t kTwice = 2 * LogBuffer::kKept;
  for (std::uint64_t i = 0; i < kTwice / 64; ++i) {
    Write(64);
    book.Pump();
  }
  ASSERT_TRUE(EventuallyTrue([&] { return quick->count() == kTwice + 1; }));
  EXPECT_EQ(quick->missed(), 0U);

  held.unlock();

  EXPECT_TRUE(EventuallyTrue([&] {
    book.PumpAll();  // the GCM does this all the time
    return stuck->next() == kTwice + 1;
  }));
  EXPECT_EQ(stuck->count(), 1 + LogBuffer::kKept);
  EXPECT_EQ(stuck->missed(), kTwice - LogBuffer::kKept);
}

TEST_F(LogBufferTest, ReportsRecordsLostOnTheirWay) {
  const auto viewer = std::make_shared<Viewer>();
  book.Watch(ChannelTo(viewer), 0);
  book.Add("robot", kInstance, {0, {LogRecord{.text = "a"}}});
  book.Add("robot", kInstance, {5, {}});
  book.Pump();

  ASSERT_TRUE(EventuallyTrue([&] { return viewer->count() == 2; }));
  EXPECT_EQ(viewer->newest().text, "4 records were lost on the way to the GCM");
  EXPECT_EQ(viewer->newest().process, "robot");

  book.Forget("robot");
  book.Add("robot", kInstance, {500, {LogRecord{.text = "b"}}});
  book.Pump();
  ASSERT_TRUE(EventuallyTrue([&] { return viewer->newest().text == "b"; }));
  EXPECT_EQ(viewer->count(), 3U);
}

TEST_F(LogBufferTest, SendsNothingToARemovedViewer) {
  const auto viewer = std::make_shared<Viewer>();
  const auto other = std::make_shared<Viewer>();
  const auto channel = ChannelTo(viewer);
  book.Watch(channel, 0);
  book.Watch(ChannelTo(other), 0);
  book.Remove(channel.get());

  Write(1);
  book.Pump();

  ASSERT_TRUE(EventuallyTrue([&] { return other->count() == 1; }));
  EXPECT_EQ(viewer->count(), 0U);
}

}  // namespace
}  // namespace tendon
