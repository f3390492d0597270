#include <gtest/gtest.h>
#include <tendon/process/log/log_queue.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace {

using tendon::LogLevel;
using tendon::LogLimiter;
using tendon::LogQueue;
using tendon::SteadyTime;
using tendon::message::LogRecord;

constexpr std::size_t kAll = 2 * LogQueue::kCapacity;

/// Returns the number of missing records in a message such as "suppressed 12 records" or "12 older
/// records".
std::uint64_t MissingIn(const LogRecord& record) {
  const std::string suppressed = "suppressed ";
  if (record.text.starts_with(suppressed)) {
    return std::strtoull(record.text.c_str() + suppressed.size(), nullptr, 10);
  }
  return record.source == "log" ? std::strtoull(record.text.c_str(), nullptr, 10) : 0;
}

class LogQueueTest : public testing::Test {
 protected:
  std::vector<LogRecord> TakeAll() { return queue.Take(kAll, clock.Now()); }

  tendon::ManualClock clock;
  LogQueue queue{clock};
};

TEST_F(LogQueueTest, ReturnsRecordsWithTheirTimeInOrder) {
  const auto before = std::chrono::system_clock::now().time_since_epoch();
  queue.Add(LogLevel::kInfo, "arm", "one");
  queue.Add(LogLevel::kError, "arm", "two");
  const auto after = std::chrono::system_clock::now().time_since_epoch();

  const auto records = TakeAll();

  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].text, "one");
  EXPECT_EQ(records[0].level, LogLevel::kInfo);
  EXPECT_EQ(records[0].source, "arm");
  EXPECT_EQ(records[0].process, "");
  EXPECT_EQ(records[1].text, "two");
  EXPECT_EQ(records[1].level, LogLevel::kError);
  EXPECT_GE(records[0].time, std::chrono::nanoseconds(before).count());
  EXPECT_LE(records[1].time, std::chrono::nanoseconds(after).count());
}

TEST_F(LogQueueTest, AddReturnsTrueIfTheReaderNeedsAWakeUp) {
  EXPECT_FALSE(queue.has_news());
  EXPECT_TRUE(queue.Add(LogLevel::kInfo, "arm", "one"));
  EXPECT_FALSE(queue.Add(LogLevel::kInfo, "arm", "two"));
  EXPECT_TRUE(queue.has_news());

  ASSERT_EQ(TakeAll().size(), 2U);

  EXPECT_FALSE(queue.has_news());
  EXPECT_TRUE(queue.Add(LogLevel::kInfo, "arm", "three"));
}

TEST_F(LogQueueTest, TakesNoMoreThanRequested) {
  for (int i = 0; i < 10; ++i) queue.Add(LogLevel::kInfo, "arm", std::to_string(i));

  EXPECT_EQ(queue.Take(4, clock.Now()).size(), 4U);
  EXPECT_TRUE(queue.has_news());
  EXPECT_EQ(queue.Take(kAll, clock.Now()).front().text, "4");
}

TEST_F(LogQueueTest, SummarisesAFloodInOneRecord) {
  constexpr std::uint64_t kStorm = 100000;
  for (std::uint64_t i = 0; i < kStorm; ++i) {
    queue.Add(i == 500 ? LogLevel::kError : LogLevel::kDebug, "arm", "help");
  }
  queue.Add(LogLevel::kInfo, "gripper", "calm");
  const auto records = TakeAll();
  ASSERT_FALSE(records.empty());
  EXPECT_EQ(records.back().text, "calm");
  EXPECT_TRUE(queue.has_news());

  clock.Advance(LogLimiter::kUntilReport);
  const auto later = TakeAll();

  ASSERT_EQ(later.size(), 1U);
  EXPECT_EQ(later[0].source, "arm");
  EXPECT_EQ(later[0].level, LogLevel::kError);
  EXPECT_EQ(MissingIn(later[0]) + records.size() - 1, kStorm) << later[0].text;
  EXPECT_FALSE(queue.has_news());
}

TEST_F(LogQueueTest, KeepsTheNewestWhenFullAndCountsTheLost) {
  constexpr std::size_t kLost = 76;
  for (std::size_t i = 0; i < LogQueue::kCapacity + kLost; ++i) {
    queue.Add(LogLevel::kInfo, "source " + std::to_string(i % 100), std::to_string(i));
  }

  const auto records = TakeAll();

  ASSERT_EQ(records.size(), 1 + LogQueue::kCapacity);
  EXPECT_EQ(MissingIn(records[0]), kLost) << records[0].text;
  EXPECT_EQ(records[0].level, LogLevel::kWarning);
  EXPECT_EQ(records[1].text, std::to_string(kLost));
  EXPECT_EQ(records.back().text, std::to_string(LogQueue::kCapacity + kLost - 1));
}

TEST_F(LogQueueTest, CountsSuppressedRecordsOfALostSummary) {
  constexpr std::uint64_t kStorm = 5000;
  for (std::uint64_t i = 0; i < kStorm; ++i) queue.Add(LogLevel::kInfo, "arm", "help");
  ASSERT_TRUE(queue.Take(0, SteadyTime::max()).empty());  // this record waits behind the first one
  for (std::size_t i = 0; i < LogQueue::kCapacity; ++i) {
    queue.Add(LogLevel::kInfo, "source " + std::to_string(i % 100), "x");
  }

  const auto records = TakeAll();

  ASSERT_EQ(records.size(), 1 + LogQueue::kCapacity);
  EXPECT_EQ(MissingIn(records[0]), kStorm) << records[0].text;
}

TEST_F(LogQueueTest, KeepsTextsShortAndPrintable) {
  queue.Add(LogLevel::kInfo, "a\x1b[2Jrm", std::string(1 << 20, 'x'));
  queue.Add(LogLevel::kInfo, std::string(1 << 20, 's'), "two\nlines");

  const auto records = TakeAll();

  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].source, "a\\x1b[2Jrm");
  EXPECT_EQ(records[0].text, std::string(LogQueue::kLongestText, 'x') + "...");
  EXPECT_EQ(records[1].source, std::string(LogLimiter::kLongestSource, 's') + "...");
  EXPECT_EQ(records[1].text, "two\\x0alines");
}

TEST_F(LogQueueTest, AccountsForEveryRecordOfManyThreads) {
  constexpr int kThreads = 4;
  constexpr std::uint64_t kEach = 3000;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < kThreads; ++thread) {
    threads.emplace_back([this, thread] {
      for (std::uint64_t i = 0; i < kEach; ++i) {
        queue.Add(LogLevel::kInfo, "thread " + std::to_string(thread) + std::to_string(i % 10),
                  "x");
      }
    });
  }
  std::uint64_t accounted = 0;
  const auto count = [&](const std::vector<LogRecord>& records) {
    for (const LogRecord& record : records) {
      const std::uint64_t missing = MissingIn(record);
      accounted += missing > 0 ? missing : 1;
    }
  };
  for (int i = 0; i < 50; ++i) count(queue.Take(20, clock.Now()));
  for (std::thread& thread : threads) thread.join();
  // Reports of suppressed records may displace other records. A displaced report counts as one
  // record.
  count(queue.Take(kAll, SteadyTime::max()));

  EXPECT_EQ(accounted, kThreads * kEach);
  EXPECT_FALSE(queue.has_news());
}

}  // namespace
