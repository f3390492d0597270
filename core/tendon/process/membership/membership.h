#pragma once

#include <tendon/base/backoff.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/context.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>
#include <tendon/process/log/log_forwarder.h>
#include <tendon/process/membership/differences.h>
#include <tendon/process/membership/health_reporter.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// Executes the requests of a GCM in a process. Called on the worker.
class MembershipDelegate {
 public:
  virtual ~MembershipDelegate() = default;
  [[nodiscard]] virtual ProcessContent content() const = 0;
  /// Called with the address that this process announces.
  virtual void OnOwnAddress(const std::string& address) = 0;
  virtual void OnPeers(const std::vector<ProcessDescription>& processes) = 0;
  /// Called with the address of the multicast broker for rows, which is empty if there is no
  /// broker.
  virtual void OnBroker(const std::string& address) = 0;
  /// Makes a connection. `done` is called on the worker.
  virtual void MakeConnection(const message::ConnectionPlan& plan,
                              std::function<void(const Result<ConnectionDescription>&)> done) = 0;
  virtual Result<void> BreakConnection(const InterfaceName& required) = 0;
  /// Executes an order. `begin` is called in a thread that may block; its error cancels the order.
  /// `done` is called on the worker.
  virtual void ExecuteOrder(const message::LifecycleOrder& order,
                            std::function<Result<void>()> begin,
                            std::function<void(const Result<message::LifecycleOutcome>&)> done) = 0;
  virtual void ListClasses(std::function<void(const Result<message::Classes>&)> done) = 0;
};

/// The membership of the process in a GCM. This class joins the GCM, reports changes, log and
/// health, and renews the lease four times a second. It joins again if the GCM was lost, was
/// restarted or has ended the membership. If there is no GCM, or another process has the same name,
/// the process continues to run, and this class tries again to join.
class Membership final : private NetworkJob {
 public:
  /// The address of the GCM, and the settings for joining it.
  struct Options {
    std::string gcm;  ///< the GCM's address
    bool retry = true;
    ProcessDescription process;  ///< all data except its address
    std::string listens;         ///< see AdvertisedAddressOf()
    std::string advertise;
  };
  Membership(ProcessContext& context, MembershipDelegate& delegate, Options options);
  ~Membership() override;

  void Begin();
  /// Leaves the GCM. Call it after the worker has stopped.
  void Leave();

  /// Waits until the process has joined. If the GCM refuses the process, returns the error at once.
  /// After `timeout`, returns the error of the last attempt.
  Result<void> WaitUntilJoined(std::chrono::milliseconds timeout) const;
  [[nodiscard]] bool is_joined() const;

  /// Sends a log record that this program did not log itself. Any thread.
  void ForwardLog(LogLevel level, std::string_view source, std::string_view text) {
    log_.Add(level, source, text);
  }

  /// Reports changes soon. Call it after a change. Any thread.
  void ReportSoon();
  /// On the worker: reports the changes since the last report.
  void Report();

 private:
  class GcmHandler;

  void Try();
  [[nodiscard]] Error WhyNotThere(const Error& error) const;
  void AskForBroker(const std::shared_ptr<Channel>& channel);
  void Join(const std::shared_ptr<Channel>& channel);
  [[nodiscard]] ProcessDescription Myself(const ProcessContent& content, const std::string& gcm);
  [[nodiscard]] ProcessDescription Description(const ProcessContent& content) const;
  void Finish(const std::shared_ptr<Channel>& channel, ProcessContent reported,
              const Result<message::JoinReply>& joined);
  void Fail(const Error& error);
  void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason);
  void TryLater();
  void SetJoined(std::shared_ptr<Channel> channel);
  bool Work(SteadyTime now, SteadyTime& next) override;
  void Renew(const std::shared_ptr<Channel>& channel);
  void Log(const std::string& text);
  void Warn(const std::string& text);

  ProcessContext& context_;
  MembershipDelegate& delegate_;
  Options options_;
  LogForwarder log_;
  HealthReporter health_;  // used only in the lease's thread

  // Used only on the worker.
  std::shared_ptr<Channel> candidate_;  // channel of a join request without a reply
  ProcessContent reported_;
  Backoff backoff_ = kLinkRetry;
  std::string logged_;
  std::string warned_;

  mutable std::mutex mutex_;  // guards the members below
  mutable std::condition_variable changed_;
  std::shared_ptr<Channel> channel_;  // set while the process is a member
  std::optional<Error> failure_;      // error of the last attempt
  bool is_report_due_ = false;
  SteadyTime next_renewal_{};
  const std::shared_ptr<Published<SteadyTime>> last_renewed_ =
      std::make_shared<Published<SteadyTime>>();

  /// The thread that renews the lease even while the network thread copies large messages. It is
  /// the last member, because it uses the other members.
  NetworkThread lease_thread_{"lease"};
};

}  // namespace tendon
