#pragma once

#include <tendon/interface/provided_interface.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/proxy/event_proxy.h>
#include <tendon/proxy/mirrored_read.h>
#include <tendon/proxy/network_thread.h>
#include <tendon/proxy/outbox.h>
#include <tendon/proxy/proxy_reports.h>
#include <tendon/proxy/worker_pool.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tendon {

class Connection;

/// Represents a provided interface of another process, for one connection. A required interface of
/// this process is connected to the proxy as to any provided interface.
///
/// Void and write commands are queued until the network thread sends them, within the credit of the
/// other end. The caller's thread sends the request of a read, unless the read is mirrored. It also
/// sends a command whose caller waits, unless queued commands must be sent first.
///
/// The middleware's thread raises the events. However, if a handler runs in the raising thread, a
/// SerialExecutor of WorkerPool raises them.
class ProvidedInterfaceProxy final : public NetworkJob,
                                     public std::enable_shared_from_this<ProvidedInterfaceProxy> {
 public:
  /// The interface in the other process, which was opened for this proxy.
  struct Remote {
    std::shared_ptr<Channel> channel;
    message::OpenInterfaceReply opened;
    InterfaceName name{};  ///< name of the interface, for log messages
    /// The values of mirrored commands, by name of the command.
    std::map<std::string, std::shared_ptr<MirroredValue>> mirrored{};
    /// Raises the events; null unless one of their handlers runs in the raising thread.
    std::shared_ptr<SerialExecutor> executor{};
  };
  /// Offers those members of the remote interface that `required` uses. Throws ConfigurationError
  /// if the description of the remote interface is invalid.
  ProvidedInterfaceProxy(std::shared_ptr<NetworkThread> thread, const Remote& remote,
                         const RequiredDescription& required,
                         std::chrono::milliseconds read_deadline);

  [[nodiscard]] ProvidedInterface& interface() { return interface_; }
  /// The number that the other end has issued.
  [[nodiscard]] std::uint32_t handle() const { return handle_; }
  /// The lane on which calls are sent.
  [[nodiscard]] Lane lane() const { return outbox_.lane(); }

  // Called in threads of the middleware, one call at a time.

  /// `handler` is the index of the event handler in the required interface.
  void OnEvent(std::size_t handler, std::span<const std::byte> value);
  /// Adds the events that were lost at the other end to this end's counts of lost events.
  void OnEventsLost(const message::EventsLost& events);
  /// Handles a report of the other end. Returns true if fault() has changed.
  bool OnCredit(const message::Credit& credit);

  /// Waits until all events that have arrived are raised, at most until `deadline`. Any thread.
  void DrainEvents(SteadyTime deadline) const;
  /// Returns why the remote component is faulted; empty if it is not faulted. Any thread.
  [[nodiscard]] std::string fault() const;
  /// Returns true if calls of `connection`, which leads to this proxy, are queued here or may not
  /// be executed yet. Returns false while the remote component is stopped. Any thread.
  [[nodiscard]] bool HasCallsUnderWay(const Connection& connection);
  /// Sends the calls that the network thread took from the queue but could not send. Tries for at
  /// most `timeout`. Must be called after the network thread has stopped using this proxy.
  void SendRest(std::chrono::milliseconds timeout) { outbox_.SendRest(timeout); }
  /// Called when the connection to the other process has ended. Later calls are refused with
  /// kNotConnected. Any thread.
  void Sever();

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  void AddCommands(const Remote& remote, const RequiredDescription& required,
                   std::chrono::milliseconds read_deadline);
  void AddEvents(const ProvidedDescription& provided, const RequiredDescription& required);

  void Raise(std::size_t handler, std::span<const std::byte> value);
  void CountLostEvents();

  const std::shared_ptr<NetworkThread> thread_;
  const std::shared_ptr<SerialExecutor> executor_;
  const std::uint32_t handle_;
  const std::map<std::string, std::shared_ptr<MirroredValue>> mirrored_;
  Outbox outbox_;
  LossReport loss_report_;
  // The proxy of each event handler; null if the remote interface has no such event.
  std::vector<std::unique_ptr<EventProxy>> events_;
  ComponentAccess remote_component_{[](const auto& /*reason*/) {}};  // only reports faults
  ProvidedInterface interface_;

  mutable std::mutex mutex_;
  std::string fault_;
};

}  // namespace tendon
