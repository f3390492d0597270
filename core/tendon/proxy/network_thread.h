#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/wakeup.h>

#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace tendon {

/// A job of the network thread.
class NetworkJob {
 public:
  NetworkJob() = default;
  NetworkJob(const NetworkJob&) = delete;
  NetworkJob& operator=(const NetworkJob&) = delete;
  virtual ~NetworkJob() = default;

  /// Called in the network thread after each Notify(), and at other times; must not block. Returns
  /// true if there may be more work at once. Lowers `next` to the time of the next necessary call.
  virtual bool Work(SteadyTime now, SteadyTime& next) = 0;
};

/// The thread between the components of a process and its middleware. It sends the calls that
/// proxies have queued, and collects rows for viewers. So a component's thread calls the middleware
/// only when it waits for an answer. Sleeps when idle. Thread-safe.
class NetworkThread {
 public:
  explicit NetworkThread(std::string name = "network");
  NetworkThread(const NetworkThread&) = delete;
  NetworkThread& operator=(const NetworkThread&) = delete;
  /// Waits until the current round has ended.
  ~NetworkThread();

  void Add(NetworkJob& job);
  /// After it returns, the job is neither running nor called again. Must not be called by a job.
  void Remove(NetworkJob& job);

  /// Notifies the thread of new work. Costs as much as Wakeup::Notify().
  void Notify() noexcept { wakeup_.Notify(); }
  /// The same for work that may wait until `when`.
  void NotifyBy(SteadyTime when) noexcept { wakeup_.NotifyBy(when); }
  /// For inboxes that this thread empties.
  [[nodiscard]] Wakeup<>& wakeup() { return wakeup_; }

 private:
  void Run();
  /// Calls every job once.
  bool Round(SteadyTime& next);

  const std::string name_;
  Wakeup<> wakeup_;
  Flag stopping_;
  std::mutex turn_;  // locked before mutex_, so that rounds do not starve others
  std::mutex mutex_;
  std::vector<NetworkJob*> jobs_;
  std::thread thread_;  // last, because it uses the other members
};

}  // namespace tendon
