#pragma once

#include <tendon/base/result.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace tendon::client {

/// Counts pending answers. Thread-safe.
class Outstanding {
 public:
  void Add() {
    const std::scoped_lock lock(mutex_);
    ++count_;
  }
  void Remove() {
    const std::scoped_lock lock(mutex_);
    if (--count_ == 0) none_.notify_all();
  }
  void WaitUntilNone(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    none_.wait_for(lock, timeout, [this] { return count_ == 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable none_;
  std::size_t count_ = 0;
};

/// A handler that is called exactly once. If the last copy is destroyed before that, the handler is
/// called with an error.
template <typename T>
class Once {
 public:
  using Handler = std::function<void(Result<T>)>;

  Once(std::shared_ptr<Outstanding> outstanding, Handler handler)
      : outstanding_(std::move(outstanding)), handler_(std::move(handler)) {
    outstanding_->Add();
  }
  Once(const Once&) = delete;
  Once& operator=(const Once&) = delete;
  ~Once() {
    if (handler_)
      Call(Error{ErrorCode::kUnreachable, "the request was cancelled: this program is ending"});
    outstanding_->Remove();
  }

  void Call(Result<T> result) {
    if (const Handler handler = std::exchange(handler_, nullptr)) handler(std::move(result));
  }

 private:
  const std::shared_ptr<Outstanding> outstanding_;
  Handler handler_;  // empty after the call
};

/// The same as a function.
template <typename T>
std::function<void(Result<T>)> CallOnce(std::shared_ptr<Outstanding> outstanding,
                                        std::function<void(Result<T>)> handler) {
  return [once = std::make_shared<Once<T>>(std::move(outstanding), std::move(handler))](
             Result<T> result) { once->Call(std::move(result)); };
}

}  // namespace tendon::client
