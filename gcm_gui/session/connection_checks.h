#pragma once

#include <tendon/gcm/diagnosis.h>

#include <functional>

namespace tendon::gui {

/// What can be asked about a connection, standing or wished for. Each function returns at once; a
/// handler is called in the GUI thread, at most once, and not after the session has ended.
class ConnectionChecks {
 public:
  using DiagnosisHandler = std::function<void(const Result<Diagnosis>&)>;

  ConnectionChecks() = default;
  ConnectionChecks(const ConnectionChecks&) = delete;
  ConnectionChecks& operator=(const ConnectionChecks&) = delete;
  virtual ~ConnectionChecks() = default;

  /// All seven steps, as `gcm explain` takes them, and what is left where one is bad. The
  /// provider's process is asked, and may take as long as any request. Errors of Diagnose().
  virtual void diagnose(const message::Wire& wire, DiagnosisHandler handler) = 0;
};

}  // namespace tendon::gui
