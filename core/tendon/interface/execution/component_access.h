#pragma once

#include <tendon/base/error.h>
#include <tendon/base/status.h>
#include <tendon/lockfree/flag.h>

#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <utility>

namespace tendon {

class ProvidedInterface;
class RequiredInterface;

/// A client whose connection has ended.
struct DisconnectedClient {
  ProvidedInterface* provided = nullptr;
  std::string name;              ///< "desk/teleoperation/Robot"
  std::uint64_t connection = 0;  ///< Mailbox::number() of its calls
};

/// Connects interfaces and commands with their component. It stores whether the component accepts
/// calls and whether it is faulted, and reports exceptions and changes of peers to the component.
///
/// Thread safety: the component sets the flags; any thread may call the other functions.
class ComponentAccess {
 public:
  /// Callbacks of the component; all but the first are optional.
  struct Listeners {
    /// Called with the reason, in the thread in which the component's code threw.
    std::function<void(const std::string& reason)> on_exception;
    /// Called in a manager's thread when the interface has a new peer or has lost its peer.
    std::function<void(RequiredInterface&)> on_peer_changed{};
    /// Called in a manager's thread when all calls of the client that will be executed have ended.
    std::function<void(DisconnectedClient)> on_client_gone{};
  };

  explicit ComponentAccess(Listeners listeners) : listeners_(std::move(listeners)) {}
  explicit ComponentAccess(std::function<void(const std::string& reason)> on_exception)
      : ComponentAccess(Listeners{.on_exception = std::move(on_exception)}) {}

  /// True if the component has callbacks for its peers and clients.
  [[nodiscard]] bool is_notified_of_connections() const {
    return static_cast<bool>(listeners_.on_peer_changed);
  }
  void ReportPeerChanged(RequiredInterface& required) const {
    listeners_.on_peer_changed(required);
  }
  void ReportClientGone(DisconnectedClient client) const {
    listeners_.on_client_gone(std::move(client));
  }

  /// Sets whether the component is faulted. Peers of a faulted component get kNotActive, even for
  /// reads, because its values are no longer updated.
  void SetFaulted(bool faulted) noexcept { faulted_.Set(faulted); }
  [[nodiscard]] bool is_faulted() const noexcept { return faulted_.Get(); }

  /// Sets whether the component executes calls that are not queued for its thread.
  void SetAccepting(bool accepting) noexcept { accepting_.Set(accepting); }
  [[nodiscard]] bool accepting() const noexcept { return accepting_.Get(); }

  /// Runs `body() -> Status`. If it throws, returns kFailed and reports the exception to
  /// `component`, unless it is null.
  template <typename Body>
  static Status CatchExceptions(const ComponentAccess* component, Body body) {
    try {
      return body();
    } catch (...) {
      if (component != nullptr)
        component->listeners_.on_exception(ReasonOf(std::current_exception()));
      return Status::kFailed;
    }
  }

 private:
  Listeners listeners_;
  Flag faulted_;
  Flag accepting_;
};

}  // namespace tendon
