#pragma once

#include <tendon/interface/connection.h>
#include <tendon/interface/required_interface.h>
#include <tendon/middleware/complaints.h>
#include <tendon/proxy/function_proxy.h>
#include <tendon/proxy/messages.h>
#include <tendon/proxy/network_thread.h>
#include <tendon/proxy/outbox.h>
#include <tendon/proxy/reports/loss_report.h>
#include <tendon/proxy/threads/call_threads.h>
#include <tendon/proxy/waiting/begun_calls.h>

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Stands in for a required interface of another process, for one connection: it is connected to a
/// provided interface here as any other. Calls that arrive are made in the middleware's thread, or,
/// where they run code of the component in their caller's thread, in a line of CallThreads; events
/// wait here until the network thread sends them.
class RequiredInterfaceProxy final : public NetworkJob,
                                     public std::enable_shared_from_this<RequiredInterfaceProxy>,
                                     private BegunCalls::Owner {
 public:
  /// Whether events are sent as kEvents or, with the time when they were raised, as kTimedEvents.
  enum class Events { kPlain, kTimed };

  /// `latest_only` names handlers that keep the latest event only. ConfigurationError where the
  /// description makes no sense.
  RequiredInterfaceProxy(std::shared_ptr<NetworkThread> thread, std::shared_ptr<Channel> channel,
                         const message::OpenInterface& open, Events events = Events::kPlain,
                         const std::vector<std::string>& latest_only = {});

  /// Before it is connected to `server`, and used: has calls made in lines where they run code of
  /// the component in their caller's thread. What is queued waits there only behind such a call:
  /// commands keep their order.
  void MakeLines(const ProvidedInterface& server, SortsOfCalls& threads);

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
  /// Waits for the commands that have arrived and are in the line, at most until then. False where
  /// one is, or a read is: code of the component may run still, which must not be freed.
  [[nodiscard]] bool Drain(SteadyTime deadline) const;
  void EndCredit();
  /// Any thread: the peer is gone; what is raised from now on is not sent.
  void Sever() { outbox_.Close(); }
  /// Any thread: nobody waits any more for reads that are still in the line.
  void DropReads() { are_reads_dropped_.Set(true); }
  /// Likewise for commands; one that runs ends as it ends.
  void DropCommands() { are_commands_dropped_.Set(true); }

  // In threads of the middleware, one at a time. `function` is its place in the interface.

  void OnCommand(std::size_t function, std::span<const std::byte> argument);
  void OnRead(std::size_t function, std::span<const std::byte> argument, Responder responder);
  /// Answers when the call was executed, or will not be.
  void OnWait(std::size_t function, std::span<const std::byte> question, Responder responder);
  void OnEventsLost(const message::EventsLost& events);

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  /// If not, that is logged: nobody hears the answer of a call that was executed.
  bool CanBeSent(std::size_t function, std::size_t size);
  /// How closely the network thread looks for what the peer must be told: not at all; now and then,
  /// for answers have told it most likely; or until it is told.
  enum class Watch { kNone, kNowAndThen, kClosely };

  /// While it lives, a command that was counted waits in the line.
  class PlaceInLine;

  /// Of a peer that sends more than it may have under way, or where memory is short.
  void LogRefused(std::size_t function);
  [[nodiscard]] bool MustWaitInLine(std::size_t function) const;
  [[nodiscard]] bool IsStale(SteadyTime since) const;
  /// In the line: where `function` is queued and the mailbox is full, until it is not any more.
  void WaitForRoom(std::size_t function, SteadyTime deadline) const;
  /// `call(*this, argument)` later, with a copy. False where too much waits there.
  template <typename Call>
  bool PostTo(CallLine& line, std::span<const std::byte> argument, Call call);
  void Read(std::size_t function, std::span<const std::byte> argument, Responder responder,
            Bytes& spare);
  Status Begin(BegunCalls::Begun& begun, std::span<const std::byte> argument, Bytes& result);
  void OnBegun(BegunCalls::Begun begun, Status status, Bytes& result);
  void CountReceived(Watch watch, std::uint64_t in_line = 0);
  void OnEnd(BegunCalls::Begun& begun, Status status, Bytes& result) override;
  [[nodiscard]] bool IsAccepting() const;
  [[nodiscard]] std::string Fault() const;
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
  std::vector<const QueuedOfferProxy*> handlers_;  // of events
  Complaints complaints_{"network"};
  std::vector<bool> runs_component_;    // in the thread of its caller, by function
  std::shared_ptr<CallLine> commands_;  // that do so, and what comes behind them; or null
  std::shared_ptr<CallLine> reads_;     // likewise
  Flag are_reads_dropped_;
  Flag are_commands_dropped_;
  Bytes answer_;  // of the middleware's thread

  mutable std::mutex mutex_;  // of what follows
  const Connection* connection_ = nullptr;
  Server server_;
  std::uint64_t received_ = 0;
  std::uint64_t waiting_in_line_ = 0;  // of them
  Watch watch_ = Watch::kNone;
  message::Credit told_;
  SteadyTime owed_since_{};  // at the latest
  BegunCalls begun_{*this};
};

}  // namespace tendon
