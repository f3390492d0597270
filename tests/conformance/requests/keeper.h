#pragma once

#include <gtest/gtest.h>
#include <tendon/middleware/middleware.h>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

#include "conformance/recorder.h"

namespace tendon::conformance {

/// Defers the reply to each request: keeps its slot until the test takes it.
class Keeper final : public LinkHandler {
 public:
  explicit Keeper(std::shared_ptr<Link> link) : link_(std::move(link)) { link_->Admit(); }

  void OnFrame(std::span<const std::byte> /*frame*/) override { Put(nullptr); }
  void OnDirectFrame(std::span<const std::byte> /*frame*/, ReplySlot& answer) override {
    auto later = answer.Defer();
    EXPECT_NE(later, nullptr);
    EXPECT_EQ(answer.Defer(), nullptr) << "it is deferred once";
    Put(std::move(later));
  }
  void OnClosed(const Error& /*reason*/) override {
    const std::scoped_lock lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

  [[nodiscard]] const std::shared_ptr<Link>& link() const { return link_; }
  bool WaitForClosed() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kTestTimeout, [this] { return is_closed_; });
  }
  /// The slot for the reply to the next request; null if the request did not come on a shorter
  /// path.
  std::unique_ptr<ReplySlot> Take() {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(changed_.wait_for(lock, kTestTimeout, [this] { return !answers_.empty(); }));
    if (answers_.empty()) return nullptr;
    auto answer = std::move(answers_.front());
    answers_.pop_front();
    return answer;
  }

 private:
  void Put(std::unique_ptr<ReplySlot> answer) {
    const std::scoped_lock lock(mutex_);
    answers_.push_back(std::move(answer));
    changed_.notify_all();
  }

  const std::shared_ptr<Link> link_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::unique_ptr<ReplySlot>> answers_;
  bool is_closed_ = false;
};

}  // namespace tendon::conformance
