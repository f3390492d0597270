#pragma once

#include <tendon/base/log.h>

namespace tendon {

/// A log sink that its destructor removes; a sink of AddLogSink() is never removed. The sink must
/// not log, and must not create or destroy a ScopedLogSink.
class ScopedLogSink {
 public:
  explicit ScopedLogSink(LogSink sink);
  ScopedLogSink(const ScopedLogSink&) = delete;
  ScopedLogSink& operator=(const ScopedLogSink&) = delete;
  /// Waits for a running call of the sink. After this, the sink is not called any more.
  ~ScopedLogSink();
};

}  // namespace tendon
