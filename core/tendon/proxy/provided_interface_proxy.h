#pragma once

#include <tendon/interface/provided_interface.h>
#include <tendon/proxy/event_proxy.h>
#include <tendon/proxy/messages.h>
#include <tendon/proxy/mirror/mirrored_value.h>
#include <tendon/proxy/network_thread.h>
#include <tendon/proxy/outbox.h>
#include <tendon/proxy/reports/loss_report.h>
#include <tendon/proxy/threads/call_threads.h>

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tendon {

class Connection;

/// Stands in for a provided interface of another process, for one connection: a required interface
/// here is connected to it as to any other. Void and write commands wait here until the network
/// thread sends them, as many as the other end has room for. Reads ask in the caller's thread,
/// unless they are mirrored, and so do commands that are waited for, unless others must be sent
/// before them. Events that arrive are raised in the middleware's thread, or, where handlers run in
/// the thread that raises them, in a line of CallThreads.
class ProvidedInterfaceProxy final : public NetworkJob,
                                     public std::enable_shared_from_this<ProvidedInterfaceProxy> {
 public:
  /// The interface at the other end, opened for this proxy.
  struct Remote {
    std::shared_ptr<Channel> channel;
    message::InterfaceOpened opened;
    InterfaceName name{};  ///< for the log
    /// What is read from copies here, by the command's name.
    std::map<std::string, std::shared_ptr<MirroredValue>> mirrored{};
    std::vector<std::string> latest_only{};  ///< commands that keep the latest call only
    std::shared_ptr<CallLine> line{};  ///< of its events; null where none of their handlers runs
                                       ///< in the thread that raises it
  };
  /// Offers what `required` can use of the remote interface. ConfigurationError where its
  /// description makes no sense.
  ProvidedInterfaceProxy(std::shared_ptr<NetworkThread> thread, const Remote& remote,
                         const RequiredDescription& required,
                         std::chrono::milliseconds read_deadline);

  [[nodiscard]] ProvidedInterface& interface() { return interface_; }
  /// Of the other end.
  [[nodiscard]] std::uint32_t handle() const { return handle_; }
  /// In which calls are sent.
  [[nodiscard]] Lane lane() const { return outbox_.lane(); }

  // In threads of the middleware, one at a time.

  /// `handler` is the event handler's place in the required interface.
  void OnEvent(std::size_t handler, std::span<const std::byte> value);
  /// Those that were lost over there are lost here, too.
  void OnEventsLost(const message::EventsLost& events);
  /// Whether the component over there has faulted, or is no longer.
  bool OnCredit(const message::Credit& credit);

  /// Any thread: waits until those that have arrived are raised, at most until then.
  void DrainEvents(SteadyTime deadline) const;
  /// Any thread: why the component over there is faulted, or empty.
  [[nodiscard]] std::string fault() const;
  /// Any thread: whether calls of `connection`, which is the one to this proxy, wait here or are
  /// not executed over there yet, as far as that has told; none are while the component there
  /// rests.
  [[nodiscard]] bool HasCallsUnderWay(const Connection& connection);
  /// Once the network thread works for it no more: sends what that has taken and could not send,
  /// for at most `patience`.
  void SendRest(std::chrono::milliseconds patience) { outbox_.SendRest(patience); }
  /// Any thread: the peer is gone; calls are refused with kNotConnected from now on.
  void Sever();

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  void AddCommands(const Remote& remote, const RequiredDescription& required,
                   std::chrono::milliseconds read_deadline);
  void AddEvents(const ProvidedDescription& provided, const RequiredDescription& required);

  void Raise(std::size_t handler, std::span<const std::byte> value);
  void CountLostEvents();

  const std::shared_ptr<NetworkThread> thread_;
  const std::shared_ptr<CallLine> line_;
  const std::uint32_t handle_;
  const std::map<std::string, std::shared_ptr<MirroredValue>> mirrored_;
  Outbox outbox_;
  LossReport loss_report_;
  std::vector<std::unique_ptr<EventProxy>> events_;  // by handler; null where it has no event
  Host host_{[](const auto& /*reason*/) {}};         // the component over there; runs nothing here
  ProvidedInterface interface_;

  mutable std::mutex mutex_;
  std::string fault_;
};

}  // namespace tendon
