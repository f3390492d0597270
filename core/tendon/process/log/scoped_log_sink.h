#pragma once

#include <tendon/base/log.h>

namespace tendon {

/// A log sink that can be removed, unlike those of AddLogSink(): it hears what the program logs
/// while the tap lives. The sink must not log, and must not create or destroy a tap.
class ScopedLogSink {
 public:
  explicit ScopedLogSink(LogSink sink);
  ScopedLogSink(const ScopedLogSink&) = delete;
  ScopedLogSink& operator=(const ScopedLogSink&) = delete;
  /// Waits for a call under way; the sink is not called afterwards.
  ~ScopedLogSink();
};

}  // namespace tendon
