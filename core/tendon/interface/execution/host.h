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
struct GoneClient {
  ProvidedInterface* provided = nullptr;
  std::string name;              ///< "desk/teleoperation/Robot"
  std::uint64_t connection = 0;  ///< Mailbox::number() of its calls
};

/// The component behind interfaces, for the threads of others that call it or run its code.
///
/// Thread safety: its component sets the flags; any thread does the rest.
class Host {
 public:
  /// What the component hears; all but the first may be left out.
  struct Listeners {
    /// Hears the reason, in the thread in which the component's code has thrown.
    std::function<void(const std::string& reason)> on_exception;
    /// In the thread of a manager: the interface has another peer, or none.
    std::function<void(RequiredInterface&)> on_peer_changed{};
    /// Likewise: nothing that the client has sent is executed any more.
    std::function<void(GoneClient)> on_client_gone{};
  };

  explicit Host(Listeners listeners) : listeners_(std::move(listeners)) {}
  explicit Host(std::function<void(const std::string& reason)> on_exception)
      : Host(Listeners{.on_exception = std::move(on_exception)}) {}

  /// Whether the component is told of its peers and its clients.
  [[nodiscard]] bool hears_of_connections() const {
    return static_cast<bool>(listeners_.on_peer_changed);
  }
  void TellPeerChanged(RequiredInterface& required) const { listeners_.on_peer_changed(required); }
  void TellClientGone(GoneClient client) const { listeners_.on_client_gone(std::move(client)); }

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
      if (host != nullptr) host->listeners_.on_exception(ReasonOf(std::current_exception()));
      return Status::kFailed;
    }
  }

 private:
  Listeners listeners_;
  Flag faulted_;
  Flag accepting_;
};

}  // namespace tendon
