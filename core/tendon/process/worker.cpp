#include <tendon/base/log.h>
#include <tendon/base/os/thread.h>
#include <tendon/process/worker.h>

#include <exception>
#include <utility>

namespace tendon {

Worker::Worker(std::string name, std::string owner)
    : name_(std::move(name)), owner_(std::move(owner)), thread_(&Worker::Run, this) {}

Worker::~Worker() { Stop(); }

void Worker::Post(Task task) { PostAfter(std::chrono::milliseconds(0), std::move(task)); }

void Worker::PostAfter(std::chrono::milliseconds delay, Task task) {
  const std::scoped_lock lock(mutex_);
  if (stopping_) return;
  tasks_.emplace(SteadyClock().Now() + delay, std::move(task));
  changed_.notify_one();
}

void Worker::Stop() {
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
    changed_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
  std::multimap<SteadyTime, Task> dropped;  // destroyed without the lock: a task may own anything
  const std::scoped_lock lock(mutex_);
  dropped.swap(tasks_);
}

void Worker::Run() {
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

void Worker::Execute(const Task& task) const {
  const auto log = [this](const char* what) {
    Log(LogLevel::kError, owner_, "a task of thread '" + name_ + "' failed: " + what);
  };
  try {
    task();
  } catch (const std::exception& failure) {
    log(failure.what());
  } catch (...) {
    log("it threw no std::exception");
  }
}

}  // namespace tendon
