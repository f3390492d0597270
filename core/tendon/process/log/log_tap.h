#pragma once

#include <tendon/base/log.h>

namespace tendon {

/// A log sink that can be removed, unlike those of AddLogSink(): it hears what the program logs
/// while the tap lives. The sink must not log, and must not create or destroy a tap.
class LogTap {
 public:
  explicit LogTap(LogSink sink);
  LogTap(const LogTap&) = delete;
  LogTap& operator=(const LogTap&) = delete;
  /// Waits for a call under way; the sink is not called afterwards.
  ~LogTap();
};

}  // namespace tendon
