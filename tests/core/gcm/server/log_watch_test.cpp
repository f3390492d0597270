#include <gmock/gmock.h>
#include <tendon/base/log.h>
#include <tests/core/gcm/gcm_fixture.h>
#include <tests/support/log/log_keeper.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace tendon {
namespace {

using message::LogRecord;
using test::LogKeeper;
using testing::ElementsAre;

using Texts = std::vector<std::string>;

Texts TextsOf(const LogKeeper& keeper, const std::string& process) {
  Texts texts;
  for (const LogRecord& record : keeper.Of(process)) texts.push_back(record.text);
  return texts;
}

LogRecord Record(const std::string& text) {
  return {.time = 1234, .level = LogLevel::kWarning, .process = {}, .source = "arm", .text = text};
}

class LogWatching : public test::GcmFixture {
 protected:
  std::unique_ptr<GcmClient> Read(const std::shared_ptr<LogKeeper>& reader) {
    auto client = Watch(reader);
    client->WatchLog();
    return client;
  }
  static bool EventuallyReads(const LogKeeper& reader, const Texts& texts) {
    return EventuallyTrue([&] { return TextsOf(reader, "robot") == texts; });
  }
};

INSTANTIATE_TEST_SUITE_P(Over, LogWatching, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(LogWatching, EveryViewerReadsWhatAProcessLogs) {
  const auto one = std::make_shared<LogKeeper>();
  const auto two = std::make_shared<LogKeeper>();
  const auto first = Read(one);
  const auto second = Read(two);
  const auto robot = Join("robot", {});

  ASSERT_TRUE(robot->SendLog({0, {Record("a"), Record("b")}}));

  EXPECT_TRUE(EventuallyReads(*one, {"a", "b"}));
  EXPECT_TRUE(EventuallyReads(*two, {"a", "b"}));
  EXPECT_EQ(one->Of("robot")[0], (LogRecord{1234, LogLevel::kWarning, "robot", "arm", "a"}));
}

TEST_P(LogWatching, ANewViewerReadsEarlierRecords) {
  const auto robot = Join("robot", {});
  ASSERT_TRUE(robot->SendLog({0, {Record("a"), Record("b")}}));
  ASSERT_TRUE(robot->Leave());  // the reply comes after the records were taken

  const auto reader = std::make_shared<LogKeeper>();
  const auto client = Read(reader);

  ASSERT_TRUE(EventuallyTrue([&] { return reader->is_current(); }));
  EXPECT_THAT(TextsOf(*reader, "robot"), ElementsAre("a", "b"));
}

TEST_P(LogWatching, ReportsRecordsLostOnABrokenLink) {
  const auto reader = std::make_shared<LogKeeper>();
  const auto client = Read(reader);
  const auto robot = Join("robot", {});
  ASSERT_TRUE(robot->SendLog({0, {Record("a")}}));
  ASSERT_TRUE(EventuallyReads(*reader, {"a"}));
  robot->BreakLink();
  ASSERT_TRUE(robot->Join(address_));

  ASSERT_TRUE(robot->SendLog({6, {Record("g")}}));

  ASSERT_TRUE(EventuallyReads(*reader, {"a", "5 records were lost on the way to the GCM", "g"}));
  EXPECT_EQ(reader->Of("robot")[1].source, "log");
}

TEST_P(LogWatching, ARestartedProcessLosesNoRecords) {
  const auto reader = std::make_shared<LogKeeper>();
  const auto client = Read(reader);
  auto robot = Join("robot", {});
  ASSERT_TRUE(robot->SendLog({0, {Record("a")}}));
  ASSERT_TRUE(EventuallyReads(*reader, {"a"}));
  robot.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return StateOf("robot") == ProcessState::kLost; }));

  robot = Join("robot", {});
  ASSERT_TRUE(robot->SendLog({7, {Record("h")}}));

  EXPECT_TRUE(EventuallyReads(*reader, {"a", "h"}));
}

TEST_P(LogWatching, EscapesTextFromOtherProcesses) {
  const auto reader = std::make_shared<LogKeeper>();
  const auto client = Read(reader);
  const auto robot = Join("robot", {});
  LogRecord record = Record("red \x1b[31m alert");
  record.process = "somebody else";
  record.source = "a\nb" + std::string(100000, 'x');

  ASSERT_TRUE(robot->SendLog({0, {record, Record(std::string(100000, 'x'))}}));

  ASSERT_TRUE(EventuallyTrue([&] { return reader->Of("robot").size() == 2; }));
  const auto records = reader->Of("robot");
  EXPECT_EQ(records[0].text, "red \\x1b[31m alert");
  EXPECT_THAT(records[0].source, testing::StartsWith("a\\x0abxxx"));
  EXPECT_LT(records[0].source.size(), 300U);
  EXPECT_LT(records[1].text.size(), 5000U);
}

TEST_P(LogWatching, IgnoresAnInvalidBatch) {
  const auto reader = std::make_shared<LogKeeper>();
  const auto client = Read(reader);
  const auto robot = Join("robot", {});
  LogRecord record = Record("a");
  record.level = LogLevel{17};
  ASSERT_TRUE(robot->SendLog({0, {record}}));
  ASSERT_TRUE(robot->SendLog({0, {Record(std::string(message::kLargestLogBatch, 'x'))}}));

  ASSERT_TRUE(robot->SendLog({0, {Record("b")}}));

  EXPECT_TRUE(EventuallyReads(*reader, {"b"}));
}

TEST_P(LogWatching, IgnoresRecordsOfAProcessThatLeft) {
  const auto reader = std::make_shared<LogKeeper>();
  const auto client = Read(reader);
  const auto robot = Join("robot", {});
  ASSERT_TRUE(robot->Leave());
  ASSERT_TRUE(robot->SendLog({0, {Record("a")}}));
  ASSERT_TRUE(robot->Renew());  // the reply comes after the record was processed

  const auto again = Join("robot", {});
  ASSERT_TRUE(again->SendLog({0, {Record("b")}}));

  EXPECT_TRUE(EventuallyReads(*reader, {"b"}));
}

TEST_P(LogWatching, IncludesTheLogOfTheGcm) {
  const auto reader = std::make_shared<LogKeeper>();
  const auto client = Read(reader);

  Log(LogLevel::kInfo, "gcm", "I am here");

  EXPECT_TRUE(EventuallyTrue([&] {
    const Texts texts = TextsOf(*reader, "gcm");  // includes the records of the GCM itself
    return std::ranges::find(texts, "I am here") != texts.end();
  }));
}

}  // namespace
}  // namespace tendon
