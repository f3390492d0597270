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
#include <tendon/proxy/queued_offer_proxy.h>
#include <tendon/proxy/worker_pool.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Represents a required interface of another process, for one connection. The proxy is connected
/// to a provided interface of this process like any required interface. Events are queued until the
/// network thread sends them.
///
/// The middleware's thread makes the calls. However, a call that runs code of the component in its
/// caller's thread is made by a SerialExecutor of WorkerPool.
class RequiredInterfaceProxy final : public NetworkJob,
                                     public std::enable_shared_from_this<RequiredInterfaceProxy>,
                                     private ExecutingCalls::Owner {
 public:
  /// The message that carries events. kPlain: kEvents. kTimed: kTimedEvents, which includes the
  /// time when each event was raised. With kTimed, handlers also receive the calls of commands.
  enum class Events { kPlain, kTimed };

  /// Throws ConfigurationError if the description is invalid.
  RequiredInterfaceProxy(std::shared_ptr<NetworkThread> thread, std::shared_ptr<Channel> channel,
                         const message::OpenInterface& open, Events events = Events::kPlain);

  /// If some calls run code of the component in their caller's thread, makes a serial executor for
  /// the commands and one for the reads of this kind. While a command is queued or running in the
  /// executor, all other commands also use the executor, so that commands keep their order. Must be
  /// called before the proxy is connected to `server`.
  void MakeExecutors(const ProvidedInterface& server, CallExecutors& threads);

  /// Prepares the event handlers that observe commands of `server`; see
  /// RequiredInterface::ObserveCalls(). Must be called before the proxy is connected to `server`.
  void PrepareObservers(const ProvidedInterface& server);

  [[nodiscard]] RequiredInterface& interface() { return interface_; }
  /// The number that the other end has issued.
  [[nodiscard]] std::uint32_t handle() const { return handle_; }
  [[nodiscard]] std::uint32_t capacity() const { return capacity_; }
  /// The lane on which events are sent.
  [[nodiscard]] Lane lane() const { return outbox_.lane(); }
  /// Number of events that have not reached the remote handlers. It includes the events that the
  /// other end has reported as lost. Any thread.
  [[nodiscard]] std::uint64_t lost_events() const;
  /// Returns true if events wait to be sent. Any thread.
  [[nodiscard]] bool has_unsent_events() const { return outbox_.HasUnsent(); }
  /// Number of commands that have arrived, whether they were executed or not. Reads are not
  /// counted. Any thread.
  [[nodiscard]] std::uint64_t received() const;

  /// The connected component.
  struct Server {
    const ProvidedInterface* interface = nullptr;
    /// Returns the reason why the component is faulted; called in any thread.
    std::function<std::string()> fault;
  };
  /// From now on, reports to the peer the state of the server, and which calls of `connection` were
  /// executed. Returns true if the server executes calls now. The arguments must exist until
  /// EndCredit().
  bool BeginCredit(const Connection& connection, Server server);
  /// Waits until the serial executor has executed all commands, at most until `deadline`. Returns
  /// false if a command or a read is left; then code of the component may still run, so the
  /// component must not be destroyed.
  [[nodiscard]] bool Drain(SteadyTime deadline) const;
  void EndCredit();
  /// Called when the connection to the other process has ended. Later events are not sent. Any
  /// thread.
  void Sever() { outbox_.Close(); }
  /// Drops the queued reads, because their callers have stopped waiting. Any thread.
  void DropReads() { are_reads_dropped_.Set(true); }
  /// Drops the queued commands. A running command continues. Any thread.
  void DropCommands() { are_commands_dropped_.Set(true); }

  // Called in threads of the middleware, one call at a time. `function` is the index in the
  // interface.

  void OnCommand(std::size_t function, std::span<const std::byte> argument);
  void OnRead(std::size_t function, std::span<const std::byte> argument, Responder responder);
  /// Begins a call. The reply is sent after the call was executed or refused.
  void OnWait(std::size_t function, std::span<const std::byte> argument, Responder responder);
  void OnEventsLost(const message::EventsLost& events);

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  /// Returns true if a result of this size can be sent. Logs a result that is too large, because
  /// the caller does not get it although the call was executed.
  bool CanBeSent(std::size_t function, std::size_t size);
  /// The rate at which the network thread checks if it must send a Credit to the peer. kIdle:
  /// never. kRelaxed: seldom, because replies have probably reported all calls. kPrompt: often.
  enum class CreditReporting { kIdle, kRelaxed, kPrompt };

  /// While this object exists, a command counts as queued in the serial executor.
  class QueuedCommandCount;

  /// These functions log that a call was dropped. LogRefused() is for a full queue: the peer has
  /// exceeded its credit, or memory is exhausted.
  void LogDropped(std::size_t function, const std::string& reason);
  void LogRefused(std::size_t function);
  [[nodiscard]] bool MustUseExecutor(std::size_t function) const;
  [[nodiscard]] bool IsStale(SteadyTime since) const;
  /// Called by the serial executor. If calls of `function` are queued in the mailbox and the
  /// mailbox is full, waits until the mailbox has a free slot.
  void WaitForRoom(std::size_t function, SteadyTime deadline) const;
  /// Posts `call(*this, argument)` with a copy of the argument. Returns false if the queue is full.
  template <typename Call>
  bool PostTo(SerialExecutor& executor, std::span<const std::byte> argument, Call call);
  void Read(std::size_t function, std::span<const std::byte> argument, Responder responder,
            Bytes& spare);
  Status Begin(ExecutingCalls::ExecutingCall& executing, std::span<const std::byte> argument,
               Bytes& result);
  void OnStarted(ExecutingCalls::ExecutingCall executing, Status status, Bytes& result);
  void CountReceived(CreditReporting reporting, std::uint64_t in_executor = 0);
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
  std::vector<QueuedOfferProxy*> handlers_;  // indexed by event handler
  RateLimitedWarning warnings_{"network"};
  // For each function: true if a call runs code of the component in the caller's thread.
  std::vector<bool> runs_component_;
  // For commands that run code of the component, and for commands after them; may be null.
  std::shared_ptr<SerialExecutor> commands_;
  std::shared_ptr<SerialExecutor> reads_;  // for reads that run code of the component; may be null
  Flag are_reads_dropped_;
  Flag are_commands_dropped_;
  Bytes reply_;  // used only in the middleware's thread

  mutable std::mutex mutex_;  // guards the members below
  const Connection* connection_ = nullptr;
  Server server_;
  std::uint64_t received_ = 0;
  std::uint64_t queued_in_executor_ = 0;  // commands in commands_
  CreditReporting reporting_ = CreditReporting::kIdle;
  message::Credit reported_;
  SteadyTime owed_since_{};  // start of the time without a report
  ExecutingCalls executing_{*this};
};

}  // namespace tendon
