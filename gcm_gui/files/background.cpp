#include <gcm_gui/files/background.h>

#include <gcm_gui/guard/exception_guard.h>

#include <QCoreApplication>
#include <QObject>
#include <QPointer>
#include <condition_variable>
#include <deque>
#include <iostream>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

namespace tendon::gui {

struct Background::Queue {
  explicit Queue(const char* the_what) : what(the_what) {}

  void close() {
    const std::lock_guard lock(mutex);
    is_closed = true;
    changed.notify_all();
  }
  [[nodiscard]] bool isDone() {
    const std::lock_guard lock(mutex);
    return is_done;
  }

  const char* const what;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Task> tasks;                  // guarded by mutex, as are the next two members
  bool is_closed = false;                  // no more tasks will be added
  bool is_done = false;                    // the thread has ended
  std::shared_ptr<const void> belongings;  // set before close(); then used by the thread alone
};

/// The threads that were handed over. The application owns this object, so it is destroyed when the
/// program ends.
class Background::DetachedThreads : public QObject {
 public:
  static DetachedThreads& instance() {
    static QPointer<DetachedThreads> threads;
    if (threads == nullptr) threads = new DetachedThreads;
    return *threads;
  }
  ~DetachedThreads() override {
    const auto begin = std::chrono::steady_clock::now();
    for (auto& [queue, thread] : threads_) {
      finish(*queue, std::move(thread), begin, kTimeoutAtEnd);
    }
  }

  void add(const std::shared_ptr<Queue>& queue, std::thread& thread) {
    for (auto& [former_queue, former] : threads_) {
      if (former_queue->isDone()) former.join();
    }
    std::erase_if(threads_, [](const auto& former) { return !former.second.joinable(); });
    threads_.emplace_back(queue, std::move(thread));
  }

 private:
  DetachedThreads() : QObject(QCoreApplication::instance()) {}

  std::vector<std::pair<std::shared_ptr<Queue>, std::thread>> threads_;
};

Background::Background(const char* what, std::chrono::milliseconds timeout)
    : timeout_(timeout), queue_(std::make_shared<Queue>(what)) {}

Background::~Background() {
  if (!thread_.joinable()) return;
  queue_->close();
  finish(*queue_, std::move(thread_), std::chrono::steady_clock::now(), timeout_);
}

void Background::finish(Queue& queue, std::thread thread,
                        std::chrono::steady_clock::time_point begin,
                        std::chrono::milliseconds timeout) {
  std::unique_lock lock(queue.mutex);
  const bool is_done =
      queue.changed.wait_until(lock, begin + timeout, [&] { return queue.is_done; });
  if (is_done) {
    lock.unlock();
    thread.join();
    return;
  }
  std::cerr << "gcm-gui: " << queue.what << " was not finished: it took longer than "
            << timeout.count() << " ms\n";
  queue.tasks.clear();
  thread.detach();
}

void Background::start(Task task) {
  const std::lock_guard lock(queue_->mutex);
  queue_->tasks.push_back(std::move(task));
  queue_->changed.notify_all();
  if (!thread_.joinable()) thread_ = std::thread([queue = queue_] { work(queue); });
}

void Background::dropWaiting() {
  std::deque<Task> dropped;  // destroyed without the lock
  const std::lock_guard lock(queue_->mutex);
  dropped.swap(queue_->tasks);
}

void Background::handOver(std::shared_ptr<const void> belongings) {
  if (!thread_.joinable()) return;
  queue_->belongings = std::move(belongings);  // close() publishes it to the thread
  queue_->close();
  try {
    DetachedThreads::instance().add(queue_, thread_);
  } catch (const std::bad_alloc&) {
    thread_.detach();
  }
}

void Background::work(const std::shared_ptr<Queue>& queue) {
  std::unique_lock lock(queue->mutex);
  while (true) {
    queue->changed.wait(lock, [&] { return queue->is_closed || !queue->tasks.empty(); });
    if (queue->tasks.empty()) break;
    Task task = std::move(queue->tasks.front());
    queue->tasks.pop_front();
    lock.unlock();
    ExceptionGuard::run(queue->what, task);
    task = nullptr;
    lock.lock();
  }
  lock.unlock();
  queue->belongings = nullptr;
  lock.lock();
  queue->is_done = true;
  queue->changed.notify_all();
}

}  // namespace tendon::gui
