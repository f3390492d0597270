#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/task/cycle_log.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/task/scripted.h"
#include "support/allocation_guard.h"
#include "support/wait.h"

namespace {

using tendon::CycleLog;
using tendon::LogLevel;
using testing::ElementsAre;
using namespace std::chrono_literals;

/// Records the log of this process, by source.
class Records {
 public:
  static Records& All() {
    static Records all;
    return all;
  }
  [[nodiscard]] std::vector<std::string> Of(const std::string& source) const {
    const std::scoped_lock lock(mutex_);
    std::vector<std::string> texts;
    for (const auto& [from, text] : records_) {
      if (from == source) texts.push_back(text);
    }
    return texts;
  }
  /// Returns the number of records that the log reports as lost.
  [[nodiscard]] std::uint64_t lost() const {
    std::uint64_t sum = 0;
    for (const std::string& text : Of("log")) sum += std::stoull(text);
    return sum;
  }
  /// While this is locked, no record is written.
  std::mutex gate;

 private:
  Records() {
    tendon::AddLogSink([this](LogLevel, std::string_view source, std::string_view text) {
      const std::scoped_lock waiting(gate);
      const std::scoped_lock lock(mutex_);
      records_.emplace_back(source, text);
    });
  }

  mutable std::mutex mutex_;
  std::vector<std::pair<std::string, std::string>> records_;
};

TEST(CycleLog, WritesDeferredRecordsCompletelyInOrder) {
  const Records& records = Records::All();
  {
    CycleLog log;
    const tendon::LogDeferralScope deferral_scope(log);
    for (int i = 0; i < 100; ++i) tendon::Log(LogLevel::kInfo, "in order", std::to_string(i));
  }

  const auto texts = records.Of("in order");
  ASSERT_EQ(texts.size(), 100U);
  for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(texts[i], std::to_string(i));
}

TEST(CycleLog, WritesSoonByItself) {
  const Records& records = Records::All();
  CycleLog log;
  {
    const tendon::LogDeferralScope deferral_scope(log);
    tendon::Log(LogLevel::kWarning, "soon", "hot");
  }

  EXPECT_TRUE(EventuallyTrue([&] { return !records.Of("soon").empty(); }));
}

TEST(CycleLog, AllocatesNothing) {
  CycleLog log;
  const tendon::LogDeferralScope deferral_scope(log);

  const tendon::AllocationGuard guard;
  tendon::Log(LogLevel::kInfo, "frugal", "a text that is longer than what a small string holds");
}

TEST(CycleLog, TruncatesLongTexts) {
  const Records& records = Records::All();
  const std::string longest(CycleLog::kLongest, 'a');
  {
    CycleLog log;
    const tendon::LogDeferralScope deferral_scope(log);
    tendon::Log(LogLevel::kInfo, "cut", longest);
    tendon::Log(LogLevel::kInfo, "cut", longest + "b");
  }

  EXPECT_THAT(records.Of("cut"), ElementsAre(longest, longest.substr(3) + "..."));
}

TEST(CycleLog, CountsAndReportsLostRecords) {
  Records& records = Records::All();
  constexpr std::uint64_t kTooMany = 100;
  const std::uint64_t lost_before = records.lost();
  std::uint64_t lost = 0;
  {
    CycleLog log;
    const tendon::LogDeferralScope deferral_scope(log);
    const std::scoped_lock nothing_is_written(records.gate);
    // The writer of the log waits at the gate with this record.
    tendon::Log(LogLevel::kInfo, "flood", "0");
    for (std::uint64_t i = 0; i < CycleLog::kCapacity + kTooMany; ++i) {
      tendon::Log(LogLevel::kInfo, "flood", "more");
    }
    lost = log.lost();
  }

  EXPECT_GE(lost, kTooMany);
  EXPECT_EQ(records.Of("flood").size(), CycleLog::kCapacity + kTooMany + 1 - lost);
  EXPECT_EQ(records.lost(), lost_before + lost);  // reported in one or two records
}

TEST(CycleLog, AFloodLeavesRoomForOthers) {
  Records& records = Records::All();
  {
    CycleLog log;
    const tendon::LogDeferralScope deferral_scope(log);
    const std::scoped_lock nothing_is_written(records.gate);
    for (const char* source : {"a raving task", "another one"}) {
      for (std::size_t i = 0; i < 10 * CycleLog::kCapacity; ++i) {
        tendon::Log(LogLevel::kInfo, source, "more");
      }
    }
    for (int i = 0; i < 50; ++i) tendon::Log(LogLevel::kInfo, "a calm task", "news");
  }

  EXPECT_EQ(records.Of("a calm task").size(), 50U);
  EXPECT_GE(records.Of("a raving task").size(), CycleLog::kCapacity / 2);
  EXPECT_GE(records.Of("another one").size(), CycleLog::kCapacity / 5);
}

TEST(CycleLog, TakesRecordsOfManyThreads) {
  const Records& records = Records::All();
  constexpr std::size_t kThreads = 3;
  constexpr std::size_t kRecords = 100;
  std::uint64_t lost = 0;
  {
    CycleLog log;
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < kThreads; ++i) {
        threads.emplace_back([&log] {
          const tendon::LogDeferralScope deferral_scope(log);
          for (std::size_t n = 0; n < kRecords; ++n) {
            tendon::Log(LogLevel::kInfo, "many", std::string(40, 'x'));
          }
        });
      }
    }
    lost = log.lost();
  }

  const auto texts = records.Of("many");
  EXPECT_EQ(texts.size(), kThreads * kRecords - lost);
  EXPECT_THAT(texts, testing::Each(std::string(40, 'x')));
}

TEST(CycleLog, DropsRecordsBelowTheLogLevel) {
  const Records& records = Records::All();
  EXPECT_FALSE(tendon::IsLogged(LogLevel::kDebug));
  {
    CycleLog log;
    const tendon::LogDeferralScope deferral_scope(log);
    tendon::Log(LogLevel::kDebug, "quiet", "nobody asked");
  }

  EXPECT_TRUE(records.Of("quiet").empty());
}

TEST(Task, WritesItsLogFromAnotherThread) {
  static std::mutex mutex;
  static std::thread::id writer;
  tendon::AddLogSink([](LogLevel, std::string_view source, std::string_view) {
    const std::scoped_lock lock(mutex);
    if (source == "talker") writer = std::this_thread::get_id();
  });
  tendon::LocalManager manager;
  auto& task = manager.Add<tendon_test::Periodic>("arm", 1ms);
  std::atomic<bool> has_talked = false;
  task.on_run = [&] {
    if (!has_talked.exchange(true)) tendon::Log(LogLevel::kInfo, "talker", "hello");
  };
  ASSERT_TRUE(manager.Start("arm").ok());

  EXPECT_TRUE(EventuallyTrue([&] {
    const std::scoped_lock lock(mutex);
    return writer != std::thread::id();
  }));

  EXPECT_NE(writer, task.thread.load());
}

}  // namespace
