#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/os/thread.h>
#include <tendon/lockfree/flag.h>

#include <cassert>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

namespace tendon::loopback {

class End;

/// The thread of a LoopbackMiddleware, and its ends of links.
class Courier {
 public:
  using Errand = std::function<void()>;

  Courier() : thread_([this] { Run(); }) {}
  Courier(const Courier&) = delete;
  Courier& operator=(const Courier&) = delete;
  ~Courier() { assert(!thread_.joinable()); }

  /// Executes the errand soon, in order. Returns false after Stop().
  bool Post(Errand errand) {
    const std::scoped_lock lock(mutex_);
    if (stopped_) return false;
    errands_.push_back(std::move(errand));
    changed_.notify_all();
    return true;
  }

  /// Executes the errand at that time; not after Stop().
  void PostAt(SteadyTime due, Errand errand) {
    const std::scoped_lock lock(mutex_);
    if (stopped_) return;
    later_.emplace(due, std::move(errand));
    changed_.notify_all();
  }

  /// Waits until all errands posted before are done.
  void Flush() {
    assert(std::this_thread::get_id() != thread_.get_id());
    std::unique_lock lock(mutex_);
    const std::uint64_t target = done_ + errands_.size() + (busy_ ? 1 : 0);
    changed_.wait(lock, [&] { return done_ >= target; });
  }

  void Adopt(std::shared_ptr<End> end) {
    const std::scoped_lock lock(mutex_);
    ends_.insert(std::move(end));
  }
  void Forget(const std::shared_ptr<End>& end) {
    const std::scoped_lock lock(mutex_);
    ends_.erase(end);
  }
  std::set<std::shared_ptr<End>> ends() {
    const std::scoped_lock lock(mutex_);
    return ends_;
  }

  /// True if no more links are accepted.
  [[nodiscard]] bool is_closing() const { return is_closing_.Get(); }

  /// Closes every end. After the return, all their handlers have got OnClosed().
  void Stop();
  /// See LoopbackMiddleware.
  void Crash();

 private:
  /// With the mutex held: moves delayed errands that are due to the queue.
  void TakeDue() {
    const SteadyTime now = SteadyClock().Now();
    while (!later_.empty() && later_.begin()->first <= now) {
      errands_.push_back(std::move(later_.begin()->second));
      later_.erase(later_.begin());
    }
  }
  void Await(std::unique_lock<std::mutex>& lock) {
    TakeDue();
    while (!stopped_ && errands_.empty()) {
      if (later_.empty()) {
        changed_.wait(lock);
      } else {
        changed_.wait_until(lock, later_.begin()->first);
      }
      TakeDue();
    }
  }
  void Run() {
    os::NameThisThread("loopback");
    std::unique_lock lock(mutex_);
    while (true) {
      Await(lock);
      if (errands_.empty()) return;
      {
        const Errand errand = std::move(errands_.front());
        errands_.pop_front();
        busy_ = true;
        lock.unlock();
        errand();
      }
      lock.lock();
      busy_ = false;
      ++done_;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Errand> errands_;
  std::multimap<SteadyTime, Errand> later_;
  std::set<std::shared_ptr<End>> ends_;
  std::uint64_t done_ = 0;
  bool busy_ = false;
  bool stopped_ = false;
  Flag is_closing_{false};
  std::thread thread_;  // last, because it uses the other members
};

}  // namespace tendon::loopback
