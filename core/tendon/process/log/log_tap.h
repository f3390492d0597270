#pragma once

#include <tendon/base/log.h>

namespace tendon {

/// A sink with an end: hears what the program logs while it lives, where AddLogSink() keeps its
/// sinks for ever. The sink must not log, nor make or end a tap.
class LogTap {
 public:
  explicit LogTap(LogSink sink);
  LogTap(const LogTap&) = delete;
  LogTap& operator=(const LogTap&) = delete;
  /// Waits for the call that is under way; the sink hears nothing any more.
  ~LogTap();
};

}  // namespace tendon
