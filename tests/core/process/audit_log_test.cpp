#include <gtest/gtest.h>
#include <tendon/base/log.h>
#include <tendon/process/audit_log.h>

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace {

using tendon::LogLevel;

/// Records the audit log of this program.
class AuditRecords {
 public:
  using Record = std::pair<LogLevel, std::string>;

  static std::vector<Record> All() {
    const std::scoped_lock lock(The().mutex_);
    return The().records_;
  }

 private:
  AuditRecords() {
    tendon::AddLogSink([this](LogLevel level, std::string_view source, std::string_view text) {
      const std::scoped_lock lock(mutex_);
      if (source == "audit") records_.emplace_back(level, text);
    });
  }
  static AuditRecords& The() {
    // Never destroyed, because a log sink lives as long as the process.
    static AuditRecords& records = *new AuditRecords;
    return records;
  }

  std::mutex mutex_;
  std::vector<Record> records_;
};

TEST(AuditLog, IsWrittenRegardlessOfTheLogLevel) {
  const std::size_t before = AuditRecords::All().size();
  testing::internal::CaptureStderr();
  tendon::SetLogLevel(LogLevel::kError);
  {
    tendon::AuditLog audit;
    audit.Write("looker", LogLevel::kInfo, "looker: connect: allowed");
    audit.Write("looker", LogLevel::kWarning, "looker: stop: refused");
  }
  tendon::SetLogLevel(LogLevel::kInfo);
  const std::string said = testing::internal::GetCapturedStderr();

  auto records = AuditRecords::All();
  records.erase(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(before));
  const std::vector<AuditRecords::Record> wanted = {{LogLevel::kInfo, "looker: connect: allowed"},
                                                    {LogLevel::kWarning, "looker: stop: refused"}};
  EXPECT_EQ(records, wanted);
  EXPECT_NE(said.find("info    audit: looker: connect: allowed"), std::string::npos) << said;
}

}  // namespace
