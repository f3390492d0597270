#pragma once

#include <tendon/interface/connection.h>
#include <tendon/interface/required_interface.h>
#include <tendon/proxy/function_proxy.h>
#include <tendon/proxy/messages.h>
#include <tendon/proxy/network_thread.h>
#include <tendon/proxy/outbox.h>
#include <tendon/proxy/reports/loss_report.h>
#include <tendon/proxy/waiting/begun_calls.h>

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Stands in for a required interface of another process, for one connection: it is connected to a
/// provided interface here as any other. Calls that arrive are made in the middleware's thread;
/// events wait here until the network thread sends them.
class RequiredInterfaceProxy final : public NetworkJob, private BegunCalls::Owner {
 public:
  /// Whether events are sent as kEvents or, with the time when they were raised, as kTimedEvents.
  enum class Events { kPlain, kTimed };

  /// `latest_only` names handlers that keep the latest event only. ConfigurationError where the
  /// description makes no sense.
  RequiredInterfaceProxy(std::shared_ptr<NetworkThread> thread, std::shared_ptr<Channel> channel,
                         const message::OpenInterface& open, Events events = Events::kPlain,
                         const std::vector<std::string>& latest_only = {});

  [[nodiscard]] RequiredInterface& interface() { return interface_; }
  /// Of the other end.
  [[nodiscard]] std::uint32_t handle() const { return handle_; }
  [[nodiscard]] std::uint32_t capacity() const { return capacity_; }
  /// In which events are sent.
  [[nodiscard]] Lane lane() const { return outbox_.lane(); }
  /// Any thread: how many events have not reached the handlers over there, whichever end has lost
  /// them; of those the other end has lost, as many as it has told of.
  [[nodiscard]] std::uint64_t lost_events() const;
  /// Any thread: how many calls have arrived that the component is to execute, whatever became of
  /// them. Reads are none.
  [[nodiscard]] std::uint64_t received() const;

  /// The component that is connected here.
  struct Server {
    const ProvidedInterface* interface = nullptr;
    std::function<std::string()> fault;  ///< why it is faulted; any thread
  };
  /// From now on the peer hears how far `connection`'s calls have come, and how the server is.
  /// Returns whether it executes calls. All must live until EndCredit().
  bool BeginCredit(const Connection& connection, Server server);
  void EndCredit();
  /// Any thread: the peer is gone; what is raised from now on is not sent.
  void Sever() { outbox_.Close(); }

  // In threads of the middleware, one at a time. `function` is its place in the interface.

  void OnCommand(std::size_t function, std::span<const std::byte> argument);
  void OnRead(std::size_t function, std::span<const std::byte> argument, Responder responder);
  /// Answers when the call was executed, or will not be. Where its caller alone waits for that and
  /// its last call was over soon, within some 100 us, this thread waits for it.
  void OnWait(std::size_t function, std::span<const std::byte> question, Responder responder);
  void OnEventsLost(const message::EventsLost& events);

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  /// If not, that is logged: nobody hears the answer of a call that was executed.
  bool CanBeSent(std::size_t function, std::size_t size);
  /// How closely the network thread looks for what the peer must be told: not at all; now and then,
  /// for answers have told it most likely; or until it is told.
  enum class Watch { kNone, kNowAndThen, kClosely };

  void CountReceived(Watch watch);
  void Await(BegunCalls::Begun begun);
  [[nodiscard]] bool IsQuick(std::size_t function) const;
  void NoteTime(std::size_t function, std::chrono::nanoseconds took);
  void OnEnd(BegunCalls::Begun& begun, Status status, Bytes& result, SteadyTime now) override;
  [[nodiscard]] bool IsAccepting() const;
  [[nodiscard]] std::string Fault() const;
  [[nodiscard]] bool IsChanged() const;
  [[nodiscard]] bool IsUrgent(const message::Credit& credit) const;
  void SendCredit(SteadyTime now, SteadyTime& next);

  const std::shared_ptr<NetworkThread> thread_;
  const std::shared_ptr<Channel> channel_;
  const std::uint32_t handle_;
  const std::uint32_t capacity_;
  Outbox outbox_;
  LossReport loss_report_;
  Published<std::uint64_t> lost_there_{0};
  RequiredInterface interface_;
  std::vector<std::unique_ptr<FunctionProxy>> functions_;
  std::vector<std::string> function_names_;
  std::vector<const QueuedOfferProxy*> handlers_;                    // of events
  Bytes answer_;                                                     // of the middleware's thread
  const std::unique_ptr<Published<std::uint8_t>[]> quick_in_a_row_;  // calls, by function
  const std::shared_ptr<Wakeup<>> ended_;  // of calls that this thread waits for
  std::mutex waiting_;                     // while it does; taken before mutex_

  mutable std::mutex mutex_;  // of what follows
  const Connection* connection_ = nullptr;
  Server server_;
  std::uint64_t received_ = 0;
  Watch watch_ = Watch::kNone;
  message::Credit told_;
  SteadyTime owed_since_{};  // at the latest
  BegunCalls begun_{*this};
};

}  // namespace tendon
