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

  /// Called in the network thread after each Notify() and at other times; must not block. Returns
  /// true if more work may be possible at once. If the next call is due before `next`, sets `next`
  /// to the time of that call.
  virtual bool Work(SteadyTime now, SteadyTime& next) = 0;
};

/// The thread between the components of a process and its middleware. It sends the calls that
/// proxies have queued, and collects rows for viewers. The thread of a component calls the
/// middleware itself only when it waits for a reply. Sleeps when idle. Thread-safe.
class NetworkThread {
 public:
  explicit NetworkThread(std::string name = "network");
  NetworkThread(const NetworkThread&) = delete;
  NetworkThread& operator=(const NetworkThread&) = delete;
  /// Ends the thread; waits until the current round of jobs is done.
  ~NetworkThread();

  void Add(NetworkJob& job);
  /// Removes a job. After the return, the job is not running and is not called again. Must not be
  /// called by a job.
  void Remove(NetworkJob& job);

  /// Notifies the thread of new work. Costs as much as Wakeup::Notify().
  void Notify() noexcept { wakeup_.Notify(); }
  /// Notifies the thread of work that may be done later, but not later than `when`.
  void NotifyBy(SteadyTime when) noexcept { wakeup_.NotifyBy(when); }
  /// The wakeup of this thread, for inboxes that it empties.
  [[nodiscard]] Wakeup<>& wakeup() { return wakeup_; }

 private:
  void Run();
  /// Calls every job once. Returns true if a job has more work.
  bool Round(SteadyTime& next);

  const std::string name_;
  Wakeup<> wakeup_;
  Flag stopping_;
  // Locked before mutex_, so that Add() and Remove() do not have to wait for many rounds.
  std::mutex turn_;
  std::mutex mutex_;
  std::vector<NetworkJob*> jobs_;
  std::thread thread_;  // last, because it uses the other members
};

}  // namespace tendon
