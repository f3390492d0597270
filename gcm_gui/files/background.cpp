#include <gcm_gui/files/background.h>
#include <gcm_gui/guard/exception_guard.h>

#include <condition_variable>
#include <deque>
#include <iostream>
#include <mutex>
#include <utility>

namespace tendon::gui {

struct Background::Queue {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Task> tasks;  // guarded by mutex, as are all members below
  bool is_closed = false;  // no more tasks will be added
  bool is_done = false;    // the thread has ended
};

Background::Background(const char* what, std::chrono::milliseconds patience)
    : what_(what), patience_(patience), queue_(std::make_shared<Queue>()) {}

Background::~Background() {
  if (!thread_.joinable()) return;
  std::unique_lock lock(queue_->mutex);
  queue_->is_closed = true;
  queue_->changed.notify_all();
  const bool is_done =
      queue_->changed.wait_for(lock, patience_, [this] { return queue_->is_done; });
  if (is_done) {
    lock.unlock();
    thread_.join();
    return;
  }
  std::cerr << "gcm-gui: " << what_ << " was not finished: it took longer than "
            << patience_.count() << " ms\n";
  queue_->tasks.clear();
  thread_.detach();
}

void Background::start(Task task) {
  const std::lock_guard lock(queue_->mutex);
  queue_->tasks.push_back(std::move(task));
  queue_->changed.notify_all();
  if (!thread_.joinable())
    thread_ = std::thread([what = what_, queue = queue_] { work(what, queue); });
}

void Background::dropWaiting() {
  std::deque<Task> dropped;  // destroyed without the lock
  const std::lock_guard lock(queue_->mutex);
  dropped.swap(queue_->tasks);
}

void Background::work(const char* what, const std::shared_ptr<Queue>& queue) {
  std::unique_lock lock(queue->mutex);
  while (true) {
    queue->changed.wait(lock, [&] { return queue->is_closed || !queue->tasks.empty(); });
    if (queue->tasks.empty()) break;
    Task task = std::move(queue->tasks.front());
    queue->tasks.pop_front();
    lock.unlock();
    ExceptionGuard::run(what, task);
    task = nullptr;
    lock.lock();
  }
  queue->is_done = true;
  queue->changed.notify_all();
}

}  // namespace tendon::gui
