#pragma once

#include <tendon/interface/connection.h>
#include <tendon/interface/required_interface.h>
#include <tendon/middleware/rate_limited_warning.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/proxy/executing_calls.h>
#include <tendon/proxy/function_proxy.h>
#include <tendon/proxy/loss_report.h>
#include <tendon/proxy/network_thread.h>
#include <tendon/proxy/outbox.h>
#include <tendon/proxy/worker_pool.h>

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Stands in for a required interface of another process, for one connection; it connects to a
/// provided interface here as usual. Calls are made in the middleware's thread, or in a line of
/// WorkerPool if they run code of the component in the caller's thread. Events are queued until
/// the network thread sends them.
class RequiredInterfaceProxy final : public NetworkJob,
                                     public std::enable_shared_from_this<RequiredInterfaceProxy>,
                                     private ExecutingCalls::Owner {
 public:
  /// Whether events are sent as kEvents, or as kTimedEvents with the time when they were raised.
  enum class Events { kPlain, kTimed };

  /// Throws ConfigurationError if the description is invalid.
  RequiredInterfaceProxy(std::shared_ptr<NetworkThread> thread, std::shared_ptr<Channel> channel,
                         const message::OpenInterface& open, Events events = Events::kPlain);

  /// Call it before the proxy is connected to `server`. Makes lines for calls that run code of the
  /// component in their caller's thread. A queued command waits in a line only behind such a call,
  /// so that commands keep their order.
  void MakeLines(const ProvidedInterface& server, CallExecutors& threads);

  [[nodiscard]] RequiredInterface& interface() { return interface_; }
  /// The number at the other end.
  [[nodiscard]] std::uint32_t handle() const { return handle_; }
  [[nodiscard]] std::uint32_t capacity() const { return capacity_; }
  /// The lane on which events are sent.
  [[nodiscard]] Lane lane() const { return outbox_.lane(); }
  /// Any thread: events that have not reached the remote handlers, whichever end lost them.
  /// Includes those lost at the other end as far as it has reported them.
  [[nodiscard]] std::uint64_t lost_events() const;
  /// Any thread: commands that have arrived, whatever became of them. Does not count reads.
  [[nodiscard]] std::uint64_t received() const;

  /// The connected component.
  struct Server {
    const ProvidedInterface* interface = nullptr;
    std::function<std::string()> fault;  ///< why it is faulted; any thread
  };
  /// Reports from now on how far `connection`'s calls have come and how the server is. Returns
  /// whether the server executes calls now. The arguments must live until EndCredit().
  bool BeginCredit(const Connection& connection, Server server);
  /// Waits until the commands in the line were executed, at most until `deadline`. Returns false if
  /// a command or a read is left: component code may still run, so it must not be freed.
  [[nodiscard]] bool Drain(SteadyTime deadline) const;
  void EndCredit();
  /// Any thread: the peer is gone; later events are not sent.
  void Sever() { outbox_.Close(); }
  /// Any thread: the callers of reads in the line have stopped waiting.
  void DropReads() { are_reads_dropped_.Set(true); }
  /// The same for commands; a running one continues.
  void DropCommands() { are_commands_dropped_.Set(true); }

  // In threads of the middleware, one at a time. `function` is the index in the interface.

  void OnCommand(std::size_t function, std::span<const std::byte> argument);
  void OnRead(std::size_t function, std::span<const std::byte> argument, Responder responder);
  /// Answers after the call was executed or refused.
  void OnWait(std::size_t function, std::span<const std::byte> question, Responder responder);
  void OnEventsLost(const message::EventsLost& events);

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  /// Logs a value that is too large, since the caller of an executed call gets no result then.
  bool CanBeSent(std::size_t function, std::size_t size);
  /// How often the network thread checks what it must report to the peer: never; seldom, since
  /// replies have probably reported it; or often.
  enum class Watch { kNone, kNowAndThen, kClosely };

  /// While it lives, its command counts as waiting in the line.
  class QueuedCommandCount;

  /// For a peer that exceeds its credit, or if memory is short.
  void LogRefused(std::size_t function);
  [[nodiscard]] bool MustWaitInLine(std::size_t function) const;
  [[nodiscard]] bool IsStale(SteadyTime since) const;
  /// In the line: if `function` is queued and the mailbox is full, waits for room.
  void WaitForRoom(std::size_t function, SteadyTime deadline) const;
  /// Posts `call(*this, argument)` with a copied argument. Returns false if too much waits.
  template <typename Call>
  bool PostTo(SerialExecutor& line, std::span<const std::byte> argument, Call call);
  void Read(std::size_t function, std::span<const std::byte> argument, Responder responder,
            Bytes& spare);
  Status Begin(ExecutingCalls::Begun& begun, std::span<const std::byte> argument, Bytes& result);
  void OnBegun(ExecutingCalls::Begun begun, Status status, Bytes& result);
  void CountReceived(Watch watch, std::uint64_t in_line = 0);
  void OnEnd(ExecutingCalls::Begun& begun, Status status, Bytes& result) override;
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
  std::vector<const QueuedOfferProxy*> handlers_;  // by event handler
  RateLimitedWarning complaints_{"network"};
  std::vector<bool> runs_component_;  // by function: in its caller's thread
  std::shared_ptr<SerialExecutor>
      commands_;                           // for commands that do, and those behind them; or null
  std::shared_ptr<SerialExecutor> reads_;  // the same for reads
  Flag are_reads_dropped_;
  Flag are_commands_dropped_;
  Bytes answer_;  // only in the middleware's thread

  mutable std::mutex mutex_;  // for all that follows
  const Connection* connection_ = nullptr;
  Server server_;
  std::uint64_t received_ = 0;
  std::uint64_t waiting_in_line_ = 0;  // received commands
  Watch watch_ = Watch::kNone;
  message::Credit told_;
  SteadyTime owed_since_{};  // since when a report is owed, at the latest
  ExecutingCalls begun_{*this};
};

}  // namespace tendon
