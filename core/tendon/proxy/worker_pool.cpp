#include <tendon/proxy/worker_pool.h>

#include <tendon/base/os/thread.h>
#include <tendon/middleware/pending_requests.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <list>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

namespace tendon {

/// Used only while the lock of the pool is held.
struct SerialExecutor::Queue {
  struct QueuedTask {
    Call call;
    std::size_t bytes = 0;
  };

  [[nodiscard]] bool HasRoom(std::size_t more) const {
    return calls.size() < most_calls && (bytes == 0 || bytes + more <= most_bytes);
  }

  const std::size_t most_calls;
  const std::size_t most_bytes;
  std::deque<QueuedTask> calls{};  // the first call may be running
  std::size_t bytes = 0;           // total bytes of the calls
};

class WorkerPool::Pool {
 public:
  using Queue = std::shared_ptr<SerialExecutor::Queue>;

  explicit Pool(std::string name) : name_(std::move(name)) {}

  bool Post(const Queue& queue, SerialExecutor::Call call, std::size_t bytes) {
    std::list<std::thread> ended;
    {
      const std::scoped_lock lock(mutex_);
      if (is_stopping_ || !queue->HasRoom(bytes)) return false;
      queue->calls.push_back({std::move(call), bytes});
      if (queue->calls.size() == 1 && !Serve(queue, Taker::kOther)) {
        queue->calls.pop_back();
        return false;
      }
      queue->bytes += bytes;
      ended.swap(ended_);
    }
    for (std::thread& thread : ended) thread.join();
    return true;
  }

  bool Drain(const Queue& queue, SteadyTime deadline) {
    std::unique_lock lock(mutex_);
    return progress_.wait_until(lock, deadline, [&queue] { return queue->calls.empty(); });
  }

  void Stop() {
    std::unique_lock lock(mutex_);
    is_stopping_ = true;
    work_.notify_all();
    progress_.wait(lock, [this] { return threads_.empty(); });
    for (std::thread& thread : ended_) thread.join();
    ended_.clear();
    while (!ready_.empty()) {
      const Queue queue = std::move(ready_.front());
      ready_.pop_front();
      Drop(*queue, lock);
    }
  }

 private:
  using Self = std::list<std::thread>::iterator;
  /// The thread that can take the next call: this thread, which has just finished another call, or
  /// only another thread.
  enum class Taker { kThis, kOther };

  // Called while the lock is held.

  /// Lets a thread execute the first call of the queue. Returns false if there is no thread or not
  /// enough memory.
  bool Serve(const Queue& queue, Taker taker) {
    try {
      ready_.push_back(queue);
    } catch (const std::bad_alloc&) {
      return false;
    }
    const std::size_t takers = idle_ + (taker == Taker::kThis ? 1 : 0);
    if (ready_.size() > takers && threads_.size() < kMax) CallGuarded(name_, [this] { Start(); });
    if (threads_.empty()) {
      ready_.pop_back();
      return false;
    }
    if (taker == Taker::kOther || ready_.size() > 1) work_.notify_one();
    return true;
  }

  void Start() {
    const auto self = threads_.emplace(threads_.end());
    try {
      *self = std::thread([this, self] { Run(self); });
    } catch (...) {
      threads_.erase(self);
      throw;
    }
  }

  /// Drops all calls of a queue. The lock is released while the calls are destroyed, because their
  /// destructors may run any code.
  static void Drop(SerialExecutor::Queue& queue, std::unique_lock<std::mutex>& lock) {
    auto dropped = std::exchange(queue.calls, {});
    queue.bytes = 0;
    lock.unlock();
    dropped.clear();
    lock.lock();
  }

  void ExecuteOne(std::unique_lock<std::mutex>& lock) {
    const Queue queue = std::move(ready_.front());
    ready_.pop_front();
    SerialExecutor::Call call = std::move(queue->calls.front().call);
    lock.unlock();
    CallGuarded(name_, [&call] { call(); });
    call = nullptr;
    lock.lock();
    queue->bytes -= queue->calls.front().bytes;
    queue->calls.pop_front();
    if (!queue->calls.empty() && (is_stopping_ || !Serve(queue, Taker::kThis))) Drop(*queue, lock);
    progress_.notify_all();
  }

  void Run(Self self) {
    constexpr std::chrono::seconds kIdleAtMost(10);
    os::NameThisThread(name_);
    std::unique_lock lock(mutex_);
    while (true) {
      ++idle_;
      const bool has_work =
          work_.wait_for(lock, kIdleAtMost, [this] { return is_stopping_ || !ready_.empty(); });
      --idle_;
      if (is_stopping_ || !has_work) break;
      ExecuteOne(lock);
    }
    ended_.splice(ended_.end(), threads_, self);
    progress_.notify_all();
  }

  const std::string name_;
  std::mutex mutex_;
  std::condition_variable work_;
  std::condition_variable progress_;
  std::deque<Queue> ready_;  // queues with a call to execute
  std::list<std::thread> threads_;
  std::list<std::thread> ended_;  // threads to be joined
  std::size_t idle_ = 0;
  bool is_stopping_ = false;
};

WorkerPool::WorkerPool(std::string name) : pool_(std::make_shared<Pool>(std::move(name))) {}

WorkerPool::~WorkerPool() { pool_->Stop(); }

std::shared_ptr<SerialExecutor> WorkerPool::MakeExecutor(std::size_t most_calls,
                                                         std::size_t most_bytes) {
  return std::shared_ptr<SerialExecutor>(new SerialExecutor(pool_, most_calls, most_bytes));
}

SerialExecutor::SerialExecutor(std::shared_ptr<WorkerPool::Pool> pool, std::size_t most_calls,
                               std::size_t most_bytes)
    : pool_(std::move(pool)),
      queue_(std::make_shared<Queue>(Queue{.most_calls = most_calls, .most_bytes = most_bytes})) {}

SerialExecutor::~SerialExecutor() = default;

bool SerialExecutor::Post(Call call, std::size_t bytes) {
  return pool_->Post(queue_, std::move(call), bytes);
}

bool SerialExecutor::Drain(SteadyTime deadline) { return pool_->Drain(queue_, deadline); }

}  // namespace tendon
