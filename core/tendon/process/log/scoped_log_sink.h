#pragma once

#include <tendon/base/log.h>

namespace tendon {

/// A log sink that is removed by its destructor, unlike those of AddLogSink(). The sink must not
/// log, and must not create or destroy a ScopedLogSink.
class ScopedLogSink {
 public:
  explicit ScopedLogSink(LogSink sink);
  ScopedLogSink(const ScopedLogSink&) = delete;
  ScopedLogSink& operator=(const ScopedLogSink&) = delete;
  /// Waits for a running call of the sink; afterwards the sink is not called any more.
  ~ScopedLogSink();
};

}  // namespace tendon
