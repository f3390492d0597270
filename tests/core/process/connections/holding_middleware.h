#pragma once

#include <support/peers/wrapped.h>
#include <tendon/middleware/connect_cancellation.h>

#include <algorithm>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "support/wait.h"

/// A middleware that delays opening links to some addresses, as if the process there hung, as long
/// as the test wants.
class HoldingMiddleware final : public tendon::test::WrappedMiddleware {
 public:
  using WrappedMiddleware::WrappedMiddleware;

  /// From now on, opening a link to that address waits.
  void Hold(const std::string& address) {
    const std::scoped_lock lock(mutex_);
    held_[address] = 0;
  }
  /// Lets all waiting and later attempts continue.
  void Release(const std::string& address) {
    const std::scoped_lock lock(mutex_);
    held_.erase(address);
    changed_.notify_all();
  }
  /// Makes the present attempts to open a link to this address time out. Later attempts wait again.
  void TimeOut(const std::string& address) {
    const std::scoped_lock lock(mutex_);
    ++held_[address];
    changed_.notify_all();
  }

  /// Returns the addresses of the waiting attempts, one entry for each attempt.
  [[nodiscard]] std::vector<std::string> waiting() const {
    const std::scoped_lock lock(mutex_);
    return waiting_;
  }
  [[nodiscard]] bool IsWaitedFor(const std::string& address) const {
    const auto all = waiting();
    return std::ranges::find(all, address) != all.end();
  }
  bool EventuallyWaitedFor(const std::string& address) const {
    return EventuallyTrue([&] { return IsWaitedFor(address); });
  }

  tendon::Result<std::shared_ptr<tendon::Link>> Open(const std::string& address,
                                                     std::shared_ptr<tendon::LinkHandler> handler,
                                                     std::chrono::milliseconds timeout) override {
    if (auto waited = Wait(address); !waited) return waited.error();
    return WrappedMiddleware::Open(address, std::move(handler), timeout);
  }

 private:
  tendon::Result<void> Wait(const std::string& address) {
    bool is_over = false;
    const tendon::CancellableConnect wait([&] {
      const std::scoped_lock lock(mutex_);
      is_over = true;
      changed_.notify_all();
    });
    std::unique_lock lock(mutex_);
    const auto begun = held_.find(address);
    if (begun == held_.end()) return {};
    const int timeouts = begun->second;
    waiting_.push_back(address);
    changed_.wait(
        lock, [&] { return is_over || !held_.contains(address) || held_.at(address) != timeouts; });
    waiting_.erase(std::ranges::find(waiting_, address));
    if (is_over) return tendon::ConnectCancelledError();
    if (!held_.contains(address)) return {};
    return tendon::Error{tendon::ErrorCode::kTimeout, address + " does not answer"};
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, int> held_;  // by address: the number of time-outs
  std::vector<std::string> waiting_;
};
