#pragma once

#include <tendon/process/clock_offset.h>
#include <tendon/process/telemetry/row_subscription.h>
#include <tendon/process/telemetry_client.h>
#include <tendon/process/viewer_messages.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace tendon {

/// Reads the kept rows of one table page by page, for TelemetryClient::ReadPast().
///
/// Thread safety: any thread, one call at a time. Only End() may be called beside another call.
class PastRowsReading {
 public:
  using Done = std::function<void(const PastRows&)>;

  PastRowsReading(TableSubscription table, std::chrono::nanoseconds last,
                  std::shared_ptr<RowSink> sink, Done done);

  [[nodiscard]] const std::string& process() const { return subscription_.wanted().process; }
  [[nodiscard]] const message::ReadRows& NextRequest() const { return next_; }
  /// Passes the rows of a page to the sink. Returns true if another page must be requested, and
  /// false after End().
  /// Before it returns false, it calls `done`.
  [[nodiscard]] bool Take(const message::ReadRowsReply& page, const ClockOffset& clock);
  void Fail(const Error& reason);
  /// After this function has returned, neither the sink nor `done` is called.
  void End();

 private:
  /// Like Take(), but returns an error if the reply is invalid. The reply of a process is
  /// untrusted.
  [[nodiscard]] Result<void> TryTake(const message::ReadRowsReply& page, const ClockOffset& clock);

  /// Calls `done`, unless the reading was ended.
  void Finish();
  [[nodiscard]] bool has_ended();

  RowSubscription subscription_;
  std::mutex mutex_;
  Done done_;  // guarded by mutex_; empty after End()
  message::ReadRows next_;
  PastRows read_;
  std::uint64_t beginning_ = 0;
  std::uint64_t end_tick_ = 0;  // rows from this tick on are not read
};

}  // namespace tendon
