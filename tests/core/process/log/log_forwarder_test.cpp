#include <gtest/gtest.h>
#include <tendon/base/os/process.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/log/log_forwarder.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "support/wait.h"

namespace {

using tendon::Channel;
using tendon::FrameHeader;
using tendon::Log;
using tendon::LogForwarder;
using tendon::LogLevel;
using tendon::LogQueue;
using tendon::MessageType;
using tendon::message::LogRecord;
using tendon::message::LogRecords;

tendon::Hello HelloOf(const std::string& name) {
  return {
      .instance = tendon::os::RandomNumber(), .name = name, .cookie = *tendon::LoopbackCookie()};
}

/// Receives log records like a GCM.
class Taker final : public tendon::ChannelHandler {
 public:
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    if (header.type != tendon::message::kLogRecords) {
      is_stuck = true;
      const std::scoped_lock held(gate);
      return;
    }
    const auto batch = tendon::DecodeBody<LogRecords>(body);
    ASSERT_TRUE(batch.ok());
    const std::scoped_lock lock(mutex_);
    if (batch->before != records_.size()) has_hole_ = true;
    records_.insert(records_.end(), batch->records.begin(), batch->records.end());
    largest_ = std::max(largest_, body.size());
  }

  /// Returns the records of one source. Other parts of this program also log.
  [[nodiscard]] std::vector<std::string> Of(const std::string& source) const {
    const std::scoped_lock lock(mutex_);
    std::vector<std::string> texts;
    for (const LogRecord& record : records_) {
      if (record.source == source) texts.push_back(record.text);
    }
    return texts;
  }
  [[nodiscard]] bool has_hole() const {
    const std::scoped_lock lock(mutex_);
    return has_hole_;
  }
  [[nodiscard]] std::size_t largest() const {
    const std::scoped_lock lock(mutex_);
    return largest_;
  }

  std::mutex gate;  ///< while this is locked, nothing is processed after the next message
  std::atomic<bool> is_stuck{false};

 private:
  mutable std::mutex mutex_;
  std::vector<LogRecord> records_;
  bool has_hole_ = false;
  std::size_t largest_ = 0;
};

class LogForwarderTest : public testing::Test {
 protected:
  LogForwarderTest() {
    auto listener = there.Listen("127.0.0.1:0", Channel::Acceptor(HelloOf("gcm"), [this] {
                                   return std::static_pointer_cast<tendon::ChannelHandler>(taker);
                                 }));
    listener_ = *std::move(listener);
  }

  [[nodiscard]] std::shared_ptr<Channel> Open() {
    const auto opened =
        Channel::Open(here, listener_->address(), HelloOf("robot"),
                      std::make_shared<tendon::ChannelHandler>(), std::chrono::seconds(20));
    EXPECT_TRUE(opened.ok()) << opened.error().message;
    return *opened;
  }

  const std::shared_ptr<tendon::LoopbackNetwork> loopback =
      std::make_shared<tendon::LoopbackNetwork>();
  tendon::LoopbackMiddleware there{loopback};
  tendon::LoopbackMiddleware here{loopback};
  const std::shared_ptr<Taker> taker = std::make_shared<Taker>();
  std::unique_ptr<tendon::Listener> listener_;
  LogForwarder forwarder{std::make_shared<tendon::NetworkThread>()};
};

using Texts = std::vector<std::string>;

TEST_F(LogForwarderTest, SendsRecordsSoonAndInOrder) {
  forwarder.SetChannel(Open());
  for (int i = 0; i < 100; ++i) Log(LogLevel::kInfo, "arm", std::to_string(i));

  ASSERT_TRUE(EventuallyTrue([&] { return taker->Of("arm").size() == 100; }));

  const Texts texts = taker->Of("arm");
  for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(texts[i], std::to_string(i));
  Log(LogLevel::kInfo, "arm", "and again after all was sent");
  EXPECT_TRUE(EventuallyTrue([&] { return taker->Of("arm").size() == 101; }));
  EXPECT_FALSE(taker->has_hole());
}

TEST_F(LogForwarderTest, DropsRecordsBelowTheLogLevel) {
  forwarder.SetChannel(Open());
  Log(LogLevel::kDebug, "arm", "nobody hears it");
  Log(LogLevel::kInfo, "arm", "everybody hears it");

  ASSERT_TRUE(EventuallyTrue([&] { return !taker->Of("arm").empty(); }));

  EXPECT_EQ(taker->Of("arm"), Texts{"everybody hears it"});
}

TEST_F(LogForwarderTest, KeepsTheNewestRecordsWithoutAGcm) {
  constexpr std::size_t kBeyond = 100;
  for (std::size_t i = 0; i < LogQueue::kCapacity + kBeyond; ++i) {
    Log(LogLevel::kInfo, "source " + std::to_string(i % 10), std::to_string(i));
  }

  forwarder.SetChannel(Open());

  const auto arrived = [&] {
    std::size_t count = 0;
    for (int i = 0; i < 10; ++i) count += taker->Of("source " + std::to_string(i)).size();
    return count;
  };
  ASSERT_TRUE(EventuallyTrue([&] { return arrived() == LogQueue::kCapacity; })) << arrived();
  const Texts lost = taker->Of("log");
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(std::strtoull(lost[0].c_str(), nullptr, 10), kBeyond) << lost[0];
  EXPECT_LT(taker->largest(), tendon::message::kLargestLogBatch);
}

TEST_F(LogForwarderTest, ResumesWhenALostGcmReturns) {
  const auto first = Open();
  forwarder.SetChannel(first);
  Log(LogLevel::kInfo, "arm", "before");
  ASSERT_TRUE(EventuallyTrue([&] { return taker->Of("arm").size() == 1; }));
  first->Close();
  Log(LogLevel::kInfo, "arm", "between");
  forwarder.SetChannel(nullptr);
  Log(LogLevel::kInfo, "arm", "without");

  forwarder.SetChannel(Open());

  ASSERT_TRUE(EventuallyTrue([&] { return taker->Of("arm").size() == 3; }));
  EXPECT_EQ(taker->Of("arm"), (Texts{"before", "between", "without"}));
  EXPECT_FALSE(taker->has_hole());
}

TEST_F(LogForwarderTest, KeepsRecordsForAFullLinkAndSendsThemOnce) {
  const auto channel = Open();
  std::unique_lock held(taker->gate);
  ASSERT_TRUE(channel->Notify(MessageType{0xffff}, 0, tendon::Bytes(1)));
  ASSERT_TRUE(EventuallyTrue([&] { return taker->is_stuck.load(); }));
  for (std::size_t size = std::size_t{1} << 20U; size > 0; size /= 2) {
    while (channel->Notify(MessageType{0xffff}, 0, tendon::Bytes(size))) {
    }
  }
  forwarder.SetChannel(channel);
  Log(LogLevel::kInfo, "arm", "patience");
  forwarder.Finish();  // makes an attempt in this thread
  forwarder.SetChannel(channel);

  held.unlock();

  ASSERT_TRUE(EventuallyTrue([&] { return !taker->Of("arm").empty(); }));
  Log(LogLevel::kInfo, "arm", "thanks");
  ASSERT_TRUE(EventuallyTrue([&] { return taker->Of("arm").size() == 2; }));
  EXPECT_EQ(taker->Of("arm"), (Texts{"patience", "thanks"}));
  EXPECT_FALSE(taker->has_hole());
}

TEST_F(LogForwarderTest, FinishSendsAllIncludingSuppressedCounts) {
  forwarder.SetChannel(Open());
  for (int i = 0; i < 1000; ++i) Log(LogLevel::kInfo, "storm", "help");

  forwarder.Finish();

  const auto told = [&] {
    const std::string word = "suppressed ";
    std::size_t sum = 0;
    for (const std::string& text : taker->Of("storm")) {
      const bool is_count = text.starts_with(word);
      sum += is_count ? std::strtoull(text.c_str() + word.size(), nullptr, 10) : 1;
    }
    return sum;
  };
  EXPECT_TRUE(EventuallyTrue([&] { return told() == 1000U; })) << told();
}

TEST_F(LogForwarderTest, SendsNothingAfterItsDestruction) {
  const auto channel = Open();
  {
    LogForwarder short_lived(std::make_shared<tendon::NetworkThread>());
    short_lived.SetChannel(channel);
    Log(LogLevel::kInfo, "arm", "once");
    short_lived.Finish();
  }

  Log(LogLevel::kInfo, "arm", "never");

  ASSERT_TRUE(EventuallyTrue([&] { return !taker->Of("arm").empty(); }));
  EXPECT_EQ(taker->Of("arm"), Texts{"once"});
}

}  // namespace
