#pragma once

#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/context.h>
#include <tendon/process/life/messages.h>
#include <tendon/process/log/log_forwarder.h>
#include <tendon/process/membership/differences.h>
#include <tendon/process/membership/health_teller.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// What a GCM wants of a process; called on the worker.
class MembershipDelegate {
 public:
  virtual ~MembershipDelegate() = default;
  [[nodiscard]] virtual ProcessContent content() const = 0;
  /// Where others are told to reach us, before they are.
  virtual void OnOwnAddress(const std::string& address) = 0;
  virtual void OnPeers(const std::vector<ProcessDescription>& processes) = 0;
  /// Where the broker for rows is that many watch; empty where there is none.
  virtual void OnFanOut(const std::string& address) = 0;
  /// `done` is called on the worker.
  virtual void MakeConnection(const message::Wiring& wiring,
                              std::function<void(const Result<ConnectionDescription>&)> done) = 0;
  virtual Result<void> BreakConnection(const InterfaceName& required) = 0;
  /// `begin` is called in a thread that may wait, and says whether the order still holds; `done` is
  /// called on the worker.
  virtual void Obey(const message::LifeOrder& order, std::function<Result<void>()> begin,
                    std::function<void(const Result<message::LifeOutcome>&)> done) = 0;
  virtual void ListClasses(std::function<void(const Result<message::Classes>&)> done) = 0;
};

/// The process as a member of a GCM: joins, keeps it informed, sends it what is logged, tells it
/// its health, renews the lease four times a second, and joins again when the GCM was lost, was
/// started anew, or has given us up. Without a GCM, or when the name is somebody else's, the
/// process runs on, and it is tried again.
class Membership final : private NetworkJob {
 public:
  /// Which GCM to join, and as what.
  struct Options {
    std::string gcm;  ///< its address
    bool retry = true;
    ProcessDescription process;  ///< but for its address
    std::string listens;         ///< see OwnAddressOf()
    std::string advertise;
  };
  Membership(ProcessContext& context, MembershipDelegate& delegate, Options options);
  ~Membership() override;

  void Begin();
  /// Says good-bye. Once the worker has stopped.
  void Leave();

  /// Until we are a member; the error is the GCM's refusal at once, or, after `timeout`, the last.
  Result<void> WaitUntilJoined(std::chrono::milliseconds timeout) const;
  [[nodiscard]] bool is_joined() const;

  /// Any thread: something has changed; the GCM will hear of it.
  void ReportSoon();
  /// On the worker: tells the GCM what has changed since the last report.
  void Report();

 private:
  class GcmHandler;

  void Try();
  [[nodiscard]] Error WhyNotThere(const Error& error) const;
  void AskForFanOut(const std::shared_ptr<Channel>& channel);
  void Join(const std::shared_ptr<Channel>& channel);
  [[nodiscard]] ProcessDescription Myself(const ProcessContent& content, const std::string& gcm);
  [[nodiscard]] ProcessDescription Description(const ProcessContent& content) const;
  void Finish(const std::shared_ptr<Channel>& channel, ProcessContent reported,
              const Result<message::Joined>& joined);
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
  HealthTeller health_;  // of the lease's thread

  // Of the worker.
  std::shared_ptr<Channel> candidate_;  // has been asked to let us join
  ProcessContent reported_;
  std::chrono::milliseconds pause_{0};
  std::string logged_;
  std::string warned_;

  mutable std::mutex mutex_;  // of what follows
  mutable std::condition_variable changed_;
  std::shared_ptr<Channel> channel_;  // while we are a member
  std::optional<Error> failure_;      // of the last attempt
  bool is_report_due_ = false;
  SteadyTime next_renewal_{};
  const std::shared_ptr<Published<SteadyTime>> last_renewed_ =
      std::make_shared<Published<SteadyTime>>();

  /// Renews the lease while that of the process copies large messages. Last: it uses the others.
  NetworkThread lease_thread_{"lease"};
};

}  // namespace tendon
