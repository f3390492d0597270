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
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tendon {

class Connection;

/// Represents a provided interface of another process, for one connection; a required interface of
/// this process connects to it as usual. Void and write commands are queued until the network
/// thread sends them, within the other end's credit. Reads send their request in the caller's
/// thread, unless they are mirrored. Commands with a waiting caller do so too, unless queued ones
/// must be sent first. Events are raised in the middleware's thread, or in a line of WorkerPool if
/// a handler runs in the raising thread.
class ProvidedInterfaceProxy final : public NetworkJob,
                                     public std::enable_shared_from_this<ProvidedInterfaceProxy> {
 public:
  /// The interface at the other end, opened for this proxy.
  struct Remote {
    std::shared_ptr<Channel> channel;
    message::OpenInterfaceReply opened;
    InterfaceName name{};  ///< its name, for the log
    /// Values of mirrored commands, by the command's name.
    std::map<std::string, std::shared_ptr<MirroredValue>> mirrored{};
    std::shared_ptr<SerialExecutor> line{};  ///< of its events; null unless one of their handlers
                                             ///< runs in the raising thread
  };
  /// Offers the part of the remote interface that `required` uses. Throws ConfigurationError if its
  /// description is invalid.
  ProvidedInterfaceProxy(std::shared_ptr<NetworkThread> thread, const Remote& remote,
                         const RequiredDescription& required,
                         std::chrono::milliseconds read_deadline);

  [[nodiscard]] ProvidedInterface& interface() { return interface_; }
  /// The number that the other end has issued.
  [[nodiscard]] std::uint32_t handle() const { return handle_; }
  /// The lane on which calls are sent.
  [[nodiscard]] Lane lane() const { return outbox_.lane(); }

  // In threads of the middleware, one at a time.

  /// `handler` is the index of the event handler in the required interface.
  void OnEvent(std::size_t handler, std::span<const std::byte> value);
  /// Adds the events that were lost at the other end to this end's counts of lost events.
  void OnEventsLost(const message::EventsLost& events);
  /// Returns true if the remote component has become faulted, or is not faulted any more.
  bool OnCredit(const message::Credit& credit);

  /// Any thread: waits until all events that have arrived are raised, at most until `deadline`.
  void DrainEvents(SteadyTime deadline) const;
  /// Any thread: why the remote component is faulted; otherwise empty.
  [[nodiscard]] std::string fault() const;
  /// Any thread: true if calls of `connection`, which leads to this proxy, are queued here or not
  /// known to be executed. False while the remote component is stopped.
  [[nodiscard]] bool HasCallsUnderWay(const Connection& connection);
  /// Call it after the network thread has stopped working for this proxy: sends the calls that it
  /// took and could not send, for at most `patience`.
  void SendRest(std::chrono::milliseconds patience) { outbox_.SendRest(patience); }
  /// Any thread: called when the peer is gone; later calls are refused with kNotConnected.
  void Sever();

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  void AddCommands(const Remote& remote, const RequiredDescription& required,
                   std::chrono::milliseconds read_deadline);
  void AddEvents(const ProvidedDescription& provided, const RequiredDescription& required);

  void Raise(std::size_t handler, std::span<const std::byte> value);
  void CountLostEvents();

  const std::shared_ptr<NetworkThread> thread_;
  const std::shared_ptr<SerialExecutor> line_;
  const std::uint32_t handle_;
  const std::map<std::string, std::shared_ptr<MirroredValue>> mirrored_;
  Outbox outbox_;
  LossReport loss_report_;
  std::vector<std::unique_ptr<EventProxy>> events_;  // by handler; null without an event
  ComponentAccess remote_component_{[](const auto& /*reason*/) {}};  // executes nothing here
  ProvidedInterface interface_;

  mutable std::mutex mutex_;
  std::string fault_;
};

}  // namespace tendon
