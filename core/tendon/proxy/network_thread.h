#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/wakeup.h>

#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace tendon {

/// Something that the network thread looks after.
class NetworkJob {
 public:
  NetworkJob() = default;
  NetworkJob(const NetworkJob&) = delete;
  NetworkJob& operator=(const NetworkJob&) = delete;
  virtual ~NetworkJob() = default;

  /// Called in the network thread after each Notify(), and often besides; must not block. Returns
  /// whether there may be more to do at once. Brings `next` forward to when it wants to be called
  /// again at the latest.
  virtual bool Work(SteadyTime now, SteadyTime& next) = 0;
};

/// The thread between the components of a process and its middleware: it sends what proxies have
/// taken and gathers rows for viewers, so that no component's thread ever enters the middleware,
/// but one that waits for an answer. Idle, it sleeps. Thread-safe.
class NetworkThread {
 public:
  explicit NetworkThread(std::string name = "network");
  NetworkThread(const NetworkThread&) = delete;
  NetworkThread& operator=(const NetworkThread&) = delete;
  /// Waits for the round that is under way.
  ~NetworkThread();

  void Add(NetworkJob& job);
  /// After it returns the job is not called any more, nor being called. Not from a job.
  void Remove(NetworkJob& job);

  /// There is something to do. As cheap as Wakeup::Notify().
  void Notify() noexcept { wakeup_.Notify(); }
  /// The same for what has time until `when`.
  void NotifyBy(SteadyTime when) noexcept { wakeup_.NotifyBy(when); }
  /// For inboxes which this thread empties.
  [[nodiscard]] Wakeup<>& wakeup() { return wakeup_; }

 private:
  void Run();
  /// Asks every job once.
  bool Round(SteadyTime& next);

  const std::string name_;
  Wakeup<> wakeup_;
  Flag stopping_;
  std::mutex turn_;  // taken before mutex_, so that a round after the other locks nobody out
  std::mutex mutex_;
  std::vector<NetworkJob*> jobs_;
  std::thread thread_;  // last: it uses the others
};

}  // namespace tendon
