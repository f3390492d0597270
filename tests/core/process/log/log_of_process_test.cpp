#include <gmock/gmock.h>
#include <tendon/base/log.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#include "support/log/log_keeper.h"
#include "support/network_test.h"

namespace {

using std::chrono::seconds;
using tendon::ErrorCode;
using tendon::GcmClient;
using tendon::Log;
using tendon::LogLevel;
using tendon::message::LogRecord;
using tendon::test::LogKeeper;
using testing::HasSubstr;

/// A viewer of the log. All processes of a test are in one program, so each process forwards the
/// whole log of the program under its own name.
class LogOfProcess : public NetworkTest {
 protected:
  LogOfProcess() {
    EXPECT_TRUE(client.WaitUntilWatching().ok());
    client.WatchLog();
  }

  tendon::Result<void> SetLevel(const std::string& process, LogLevel level) {
    return tendon::Wait<void>(seconds(20),
                              [&](auto handler) { client.SetLogLevel(process, level, handler); });
  }
  bool EventuallyHears(const std::string& process, const std::string& source,
                       const std::string& text) const {
    return EventuallyTrue([&] {
      const auto records = keeper->Of(process, source);
      return std::any_of(records.begin(), records.end(),
                         [&](const LogRecord& record) { return record.text == text; });
    });
  }
  /// Returns how many records of the source have arrived or were reported as suppressed.
  [[nodiscard]] std::uint64_t Accounted(const std::string& source) const {
    const std::string word = "suppressed ";
    std::uint64_t accounted = 0;
    for (const LogRecord& record : keeper->Of("robot", source)) {
      const bool stands_for_many = record.text.starts_with(word);
      accounted +=
          stands_for_many ? std::strtoull(record.text.c_str() + word.size(), nullptr, 10) : 1;
    }
    return accounted;
  }

  const std::shared_ptr<LogKeeper> keeper = std::make_shared<LogKeeper>();
  GcmClient client{NewMiddleware(),
                   {.name = "test", .address = gcm().address(), .timeout = seconds(20)},
                   keeper};
};

TEST_P(LogOfProcess, ReachesAViewerWithAllFieldsOfARecord) {
  const auto robot = Start("robot");

  Log(LogLevel::kWarning, "arm", "is warm");

  ASSERT_TRUE(EventuallyHears("robot", "arm", "is warm"));
  EXPECT_EQ(keeper->Of("robot", "arm").front().level, LogLevel::kWarning);
  EXPECT_TRUE(EventuallyHears("gcm", "gcm", "process 'robot' is available"));
}

/// For example, a window that hosts a GCM is both the GCM and a process.
TEST_P(LogOfProcess, IsSentOnceIfTheGcmIsInTheSameProgram) {
  auto own = Start("gcm");

  Log(LogLevel::kInfo, "arm", "once");
  own.reset();  // the process has sent all its records

  ASSERT_TRUE(EventuallyHears("gcm", "gcm", "process 'gcm' has left: deregistered"));
  EXPECT_EQ(keeper->Of("gcm", "arm").size(), 1U);
}

TEST_P(LogOfProcess, SurvivesTheLossOfTheGcm) {
  const auto robot = Start("robot");
  Log(LogLevel::kInfo, "arm", "before");
  ASSERT_TRUE(EventuallyHears("robot", "arm", "before"));

  KillGcm();
  ASSERT_TRUE(EventuallyTrue([&] { return !robot->is_joined(); }));
  Log(LogLevel::kInfo, "arm", "without");
  StartGcm();

  ASSERT_TRUE(EventuallyHears("robot", "arm", "without"));
  Log(LogLevel::kInfo, "arm", "after");
  EXPECT_TRUE(EventuallyHears("robot", "arm", "after"));
  EXPECT_EQ(keeper->Of("robot", "arm").size(), 3U);
}

TEST_P(LogOfProcess, SendsItsLastRecordsAndSuppressedCounts) {
  constexpr std::uint64_t kStorm = 1000;
  auto robot = Start("robot");

  for (std::uint64_t i = 0; i < kStorm; ++i) Log(LogLevel::kInfo, "raving", "good-bye");
  robot.reset();

  EXPECT_TRUE(EventuallyTrue([&] { return Accounted("raving") == kStorm; })) << Accounted("raving");
}

TEST_P(LogOfProcess, AFloodDoesNotAffectOtherSources) {
  const auto robot = Start("robot");
  constexpr std::uint64_t kStorm = 5000;
  std::thread raving([] {
    for (std::uint64_t i = 0; i < kStorm; ++i) Log(LogLevel::kInfo, "raving", "help");
  });
  for (int i = 0; i < 50; ++i) Log(LogLevel::kInfo, "calm", std::to_string(i));
  raving.join();

  ASSERT_TRUE(EventuallyHears("robot", "calm", "49"));
  EXPECT_EQ(keeper->Of("robot", "calm").size(), 50U);
  EXPECT_TRUE(EventuallyTrue([&] { return Accounted("raving") == kStorm; })) << Accounted("raving");
  EXPECT_LT(keeper->Of("robot", "raving").size(), kStorm);
  EXPECT_EQ(keeper->lost(), 0U);
}

TEST_P(LogOfProcess, HasTheLevelThatAViewerSets) {
  const auto robot = Start("robot");
  ASSERT_FALSE(tendon::IsLogged(LogLevel::kDebug));

  const auto lower = SetLevel("robot", LogLevel::kDebug);
  EXPECT_TRUE(lower.ok()) << lower.error().message;
  EXPECT_TRUE(tendon::IsLogged(LogLevel::kDebug));
  EXPECT_TRUE(
      EventuallyHears("gcm", "gcm", "test has set the log level of process 'robot' to debug"));

  const auto back = SetLevel("robot", LogLevel::kInfo);
  EXPECT_TRUE(back.ok()) << back.error().message;
  EXPECT_FALSE(tendon::IsLogged(LogLevel::kDebug));
}

TEST_P(LogOfProcess, OfAnAbsentProcessHasNoLevelToSet) {
  auto robot = Start("robot");

  const auto misspelt = SetLevel("robt", LogLevel::kDebug);
  ASSERT_FALSE(misspelt.ok());
  EXPECT_EQ(misspelt.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(misspelt.error().message, HasSubstr("did you mean 'robot'?"));

  robot.reset();
  const auto gone = SetLevel("robot", LogLevel::kDebug);
  ASSERT_FALSE(gone.ok());
  EXPECT_EQ(gone.error().code, ErrorCode::kFailed);
  EXPECT_THAT(gone.error().message, HasSubstr("process 'robot' has left"));
}

INSTANTIATE_TEST_SUITE_P(Over, LogOfProcess, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
