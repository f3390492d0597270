#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/wakeup.h>
#include <tendon/middleware/frame.h>

#include <cassert>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// The body of a reply. The body is stored here, or it refers to memory of another object, so
/// that a large reply need not be copied.
class Reply {
 public:
  explicit Reply(Bytes own) : own_(std::move(own)) {}
  /// `body` is valid as long as `owner` is held; `owner` is not null.
  Reply(std::span<const std::byte> body, std::shared_ptr<const void> owner)
      : lent_(body), owner_(std::move(owner)) {
    assert(owner_);
  }

  /// Valid until this object is moved or destroyed.
  [[nodiscard]] std::span<const std::byte> body() const {
    return owner_ ? lent_ : std::span<const std::byte>(own_);
  }
  /// Copies the body if it is in memory of another object.
  [[nodiscard]] Bytes TakeBytes() && {
    return owner_ ? Bytes(lent_.begin(), lent_.end()) : std::move(own_);
  }

 private:
  Bytes own_;
  std::span<const std::byte> lent_;
  std::shared_ptr<const void> owner_;
};

/// The requests of one channel that wait for a reply. Calls each handler exactly once, without
/// holding a lock, and logs its exceptions. Allocates memory only when more requests wait than ever
/// before; handlers may allocate. Thread-safe.
class PendingRequests {
 public:
  using Handler = std::function<void(Result<Bytes>)>;

  /// Adds a request and returns its number. After FinishAll(), returns 0 and leaves the handler
  /// unchanged.
  std::uint64_t Add(std::chrono::milliseconds timeout, Handler& handler);

  /// Removes a request that was never sent; its handler is not called.
  void Withdraw(std::uint64_t request);

  /// Ends a request: calls its handler or wakes its caller. Returns false if the request has
  /// already ended.
  bool Finish(std::uint64_t request, Result<Reply> outcome);

  /// Returns true if the request still waits for its reply.
  [[nodiscard]] bool IsAwaited(std::uint64_t request);

  /// Ends the requests that have timed out, with an error that names `peer`. A BlockingRequest has
  /// its own deadline and is not ended here.
  void Expire(SteadyTime now, const std::string& peer);

  /// Ends all requests in order with `reason`, and refuses all later ones.
  void FinishAll(const Error& reason);

 private:
  friend class BlockingRequest;

  /// Memory for one request at a time. It is reused and its address never changes, because a thread
  /// may still be about to wake the caller of an earlier request.
  struct Slot {
    std::uint64_t request = 0;
    SteadyTime deadline{};
    std::chrono::milliseconds timeout{};
    Handler handler;
    bool is_awaited = false;  // a BlockingRequest waits for the outcome; there is no handler
    std::optional<Result<Reply>> outcome;
    Flag has_ended;
    Wakeup<> wakeup;
  };

  // Called while the lock is held.
  Slot& Take();
  Slot*& EntryOf(std::uint64_t request) { return by_number_[request & (by_number_.size() - 1)]; }
  [[nodiscard]] Slot* Remove(std::uint64_t request);
  void Free(Slot& slot);

  Slot* AddAwaited();
  std::optional<Result<Reply>> Leave(Slot& slot);

  std::mutex mutex_;
  bool finished_ = false;
  std::uint64_t last_ = 0;
  std::deque<Slot> slots_;
  std::vector<Slot*> free_;       // has capacity for all slots_
  std::vector<Slot*> by_number_;  // by the low bits of the number; the size is a power of two
};

/// The error "no reply from robot within 500 ms; outcome unknown".
[[nodiscard]] Error NoReply(const std::string& peer, std::chrono::milliseconds timeout);

/// Logs the current exception. Must be called in a catch block.
void LogFailure(const std::string& peer);

/// Calls `function`, which may be code of the user, and logs its exceptions.
template <typename Function>
void CallGuarded(const std::string& peer, Function function) {
  try {
    function();
  } catch (...) {
    LogFailure(peer);
  }
}

/// A request whose caller waits for the reply. It needs no handler and therefore no memory
/// allocation. Used by one thread. Must not outlive the PendingRequests.
class BlockingRequest {
 public:
  explicit BlockingRequest(PendingRequests& requests)
      : requests_(requests), slot_(requests.AddAwaited()) {
    if (slot_ != nullptr) number_ = slot_->request;
  }
  BlockingRequest(const BlockingRequest&) = delete;
  BlockingRequest& operator=(const BlockingRequest&) = delete;
  ~BlockingRequest() { (void)Leave(); }

  /// The number of the request; 0 if no more requests can be sent.
  [[nodiscard]] std::uint64_t number() const { return number_; }

  /// Waits for the outcome and returns it. Returns no value if `deadline` has passed. Must be
  /// called only once, because a reply that arrives afterwards is ignored.
  std::optional<Result<Reply>> WaitUntil(SteadyTime deadline) {
    if (slot_ == nullptr) return std::nullopt;
    slot_->wakeup.WaitUntil([this] { return slot_->has_ended.Get(); }, deadline);
    return Leave();
  }

 private:
  std::optional<Result<Reply>> Leave() {
    PendingRequests::Slot* const slot = std::exchange(slot_, nullptr);
    return slot == nullptr ? std::nullopt : requests_.Leave(*slot);
  }

  PendingRequests& requests_;
  PendingRequests::Slot* slot_;
  std::uint64_t number_ = 0;
};

}  // namespace tendon
