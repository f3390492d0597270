#pragma once

#include <tendon/base/error.h>
#include <tendon/base/status.h>
#include <tendon/lockfree/flag.h>

#include <exception>
#include <functional>
#include <string>
#include <utility>

namespace tendon {

/// The component behind interfaces, for the threads of others that call it or run its code.
///
/// Thread safety: its component sets the flags; any thread does the rest.
class Host {
 public:
  /// `on_exception` hears the reason, in the thread in which the component's code has thrown.
  explicit Host(std::function<void(const std::string& reason)> on_exception)
      : on_exception_(std::move(on_exception)) {}

  /// While it is faulted its peers get kNotActive, even for reads: nobody keeps its values up to
  /// date.
  void SetFaulted(bool faulted) noexcept { faulted_.Set(faulted); }
  [[nodiscard]] bool is_faulted() const noexcept { return faulted_.Get(); }

  /// Whether calls run that have no thread of the component to wait for.
  void SetAccepting(bool accepting) noexcept { accepting_.Set(accepting); }
  [[nodiscard]] bool accepting() const noexcept { return accepting_.Get(); }

  /// `body() -> Status`; kFailed where it throws, which the component hears of. Without a host
  /// nobody does.
  template <typename Body>
  static Status Contain(const Host* host, Body body) {
    try {
      return body();
    } catch (...) {
      if (host != nullptr) host->on_exception_(ReasonOf(std::current_exception()));
      return Status::kFailed;
    }
  }

 private:
  std::function<void(const std::string& reason)> on_exception_;
  Flag faulted_;
  Flag accepting_;
};

}  // namespace tendon
