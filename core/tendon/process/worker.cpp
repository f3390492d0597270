#include <tendon/process/worker.h>

#include <tendon/base/log.h>
#include <tendon/base/os/thread.h>
#include <tendon/middleware/connect_cancellation.h>

#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <utility>

namespace tendon {

/// The tasks, and the loop that executes them.
class Worker::Queue {
 public:
  Queue(std::string name, std::string owner) : name_(std::move(name)), owner_(std::move(owner)) {}

  void Add(SteadyTime due, Task task) {
    const std::scoped_lock lock(mutex_);
    if (stopping_) return;
    tasks_.emplace(due, std::move(task));
    changed_.notify_one();
  }

  void Stop() {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
    changed_.notify_one();
  }

  void Clear() {
    std::multimap<SteadyTime, Task> dropped;  // destroyed after the lock is released
    const std::scoped_lock lock(mutex_);
    dropped.swap(tasks_);
  }

  /// Executes tasks until Stop() is called.
  void Run() {
    os::NameThisThread(name_);
    std::unique_lock lock(mutex_);
    while (!stopping_) {
      if (tasks_.empty()) {
        changed_.wait(lock);
        continue;
      }
      const SteadyTime due = tasks_.begin()->first;
      if (SteadyClock().Now() < due) {
        changed_.wait_until(lock, due);
        continue;
      }
      Task task = std::move(tasks_.begin()->second);
      tasks_.erase(tasks_.begin());
      lock.unlock();
      Execute(task);
      task = nullptr;
      lock.lock();
    }
  }

 private:
  void Execute(const Task& task) const {
    const auto log = [this](const char* what) {
      Log(LogLevel::kError, owner_, "a task of thread '" + name_ + "' failed: " + what);
    };
    try {
      task();
    } catch (const std::exception& failure) {
      log(failure.what());
    } catch (...) {
      log("its exception does not derive from std::exception");
    }
  }

  const std::string name_;
  const std::string owner_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::multimap<SteadyTime, Task> tasks_;
  bool stopping_ = false;
};

Worker::Worker(std::string name, std::string owner)
    : queue_(std::make_shared<Queue>(std::move(name), std::move(owner))),
      thread_([queue = queue_] { queue->Run(); }) {}

Worker::~Worker() {
  if (thread_.get_id() == std::this_thread::get_id()) thread_.detach();
  Stop();
}

void Worker::Post(Task task) { PostAfter(std::chrono::milliseconds(0), std::move(task)); }

void Worker::PostAfter(std::chrono::milliseconds delay, Task task) {
  queue_->Add(SteadyClock().Now() + delay, std::move(task));
}

void Worker::Stop() {
  queue_->Stop();
  if (thread_.joinable()) {
    const ConnectCancellation end(thread_.get_id());
    thread_.join();
  }
  queue_->Clear();
}

}  // namespace tendon
