#pragma once

#include <tendon/base/rate_limited_warning.h>
#include <tendon/interface/connection.h>
#include <tendon/interface/required_interface.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/proxy/executing_calls.h>
#include <tendon/proxy/function_proxy.h>
#include <tendon/proxy/network_thread.h>
#include <tendon/proxy/outbox.h>
#include <tendon/proxy/proxy_reports.h>
#include <tendon/proxy/queued_command_proxy.h>
#include <tendon/proxy/worker_pool.h>

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Represents a required interface of another process, for one connection; it connects to a
/// provided interface of this process as usual. Calls are made in the middleware's thread, or in a
/// line of WorkerPool if they run code of the component in the caller's thread. Events are queued
/// until the network thread sends them.
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
  /// The number that the other end has issued.
  [[nodiscard]] std::uint32_t handle() const { return handle_; }
  [[nodiscard]] std::uint32_t capacity() const { return capacity_; }
  /// The lane on which events are sent.
  [[nodiscard]] Lane lane() const { return outbox_.lane(); }
  /// Any thread: number of events that have not reached the remote handlers. Counts the losses of
  /// both ends, as far as the other end has reported its own.
  [[nodiscard]] std::uint64_t lost_events() const;
  /// Any thread: number of commands that have arrived, executed or not. Does not count reads.
  [[nodiscard]] std::uint64_t received() const;

  /// The connected component.
  struct Server {
    const ProvidedInterface* interface = nullptr;
    std::function<std::string()> fault;  ///< why it is faulted; any thread
  };
  /// Starts the reports about the executed calls of `connection` and the state of the server.
  /// Returns true if the server executes calls now. The arguments must live until EndCredit().
  bool BeginCredit(const Connection& connection, Server server);
  /// Waits until the commands in the line were executed, at most until `deadline`. Returns false if
  /// a command or a read is left; then component code may still run, and must not be freed.
  [[nodiscard]] bool Drain(SteadyTime deadline) const;
  void EndCredit();
  /// Any thread: called when the peer is gone; later events are not sent.
  void Sever() { outbox_.Close(); }
  /// Any thread: drops the reads in the line, whose callers have stopped waiting.
  void DropReads() { are_reads_dropped_.Set(true); }
  /// The same for commands; a running command continues.
  void DropCommands() { are_commands_dropped_.Set(true); }

  // In threads of the middleware, one at a time. `function` is the index in the interface.

  void OnCommand(std::size_t function, std::span<const std::byte> argument);
  void OnRead(std::size_t function, std::span<const std::byte> argument, Responder responder);
  /// Replies after the call was executed or refused.
  void OnWait(std::size_t function, std::span<const std::byte> argument, Responder responder);
  void OnEventsLost(const message::EventsLost& events);

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  /// Returns false for a value that is too large, and logs it, because then the caller of an
  /// executed call gets no result.
  bool CanBeSent(std::size_t function, std::size_t size);
  /// How often the network thread checks whether it must report to the peer: never; seldom, if
  /// replies have probably reported everything; or often.
  enum class CreditReporting { kIdle, kRelaxed, kPrompt };

  /// While this object exists, a command counts as waiting in the line.
  class QueuedCommandCount;

  /// Logs a refused call: the peer has exceeded its credit, or there is no memory.
  void LogDropped(std::size_t function, const std::string& reason);
  void LogRefused(std::size_t function);
  [[nodiscard]] bool MustWaitInLine(std::size_t function) const;
  [[nodiscard]] bool IsStale(SteadyTime since) const;
  /// Called in the line: waits for room if `function` is queued and the mailbox is full.
  void WaitForRoom(std::size_t function, SteadyTime deadline) const;
  /// Posts `call(*this, argument)` with a copied argument. Returns false if the line is full.
  template <typename Call>
  bool PostTo(SerialExecutor& line, std::span<const std::byte> argument, Call call);
  void Read(std::size_t function, std::span<const std::byte> argument, Responder responder,
            Bytes& spare);
  Status Begin(ExecutingCalls::ExecutingCall& executing, std::span<const std::byte> argument,
               Bytes& result);
  void OnStarted(ExecutingCalls::ExecutingCall executing, Status status, Bytes& result);
  void CountReceived(CreditReporting reporting, std::uint64_t in_line = 0);
  void OnEnd(ExecutingCalls::ExecutingCall& executing, Status status, Bytes& result) override;
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
  std::vector<const QueuedOfferProxy*> handlers_;  // indexed by event handler
  RateLimitedWarning complaints_{"network"};
  std::vector<bool> runs_component_;  // by function: runs in its caller's thread
  std::shared_ptr<SerialExecutor>
      commands_;                           // line for such commands and those behind them; or null
  std::shared_ptr<SerialExecutor> reads_;  // line for such reads; or null
  Flag are_reads_dropped_;
  Flag are_commands_dropped_;
  Bytes answer_;  // used only in the middleware's thread

  mutable std::mutex mutex_;  // guards the members below
  const Connection* connection_ = nullptr;
  Server server_;
  std::uint64_t received_ = 0;
  std::uint64_t waiting_in_line_ = 0;  // number of received commands
  CreditReporting reporting_ = CreditReporting::kIdle;
  message::Credit reported_;
  SteadyTime owed_since_{};  // begin of the wait for the next report
  ExecutingCalls executing_{*this};
};

}  // namespace tendon
