#pragma once

#include <tendon/gcm/diagnosis.h>

#include <functional>

namespace tendon::gui {

/// Checks an existing or requested connection. Each function returns at once; a handler is called
/// in the GUI thread, at most once, and not after the end of the session.
class ConnectionChecks {
 public:
  using DiagnosisHandler = std::function<void(const Result<Diagnosis>&)>;

  ConnectionChecks() = default;
  ConnectionChecks(const ConnectionChecks&) = delete;
  ConnectionChecks& operator=(const ConnectionChecks&) = delete;
  virtual ~ConnectionChecks() = default;

  /// Makes the seven checks of `gcm explain`, up to the first failure. Asks the provider's process,
  /// which may take as long as any request. Errors of Diagnose().
  virtual void diagnose(const message::Wire& wire, DiagnosisHandler handler) = 0;
};

}  // namespace tendon::gui
