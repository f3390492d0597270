#pragma once

#include <tendon/interface/execution/component_access.h>
#include <tendon/interface/mailbox.h>
#include <tendon/lockfree/triple_buffer.h>
#include <tendon/lockfree/try_lock.h>

#include <cassert>
#include <cstddef>

namespace tendon {

/// The argument of a command that keeps only its latest call. A newer argument replaces an older
/// one that is still queued. One token in the mailbox stands for the queued argument. Another token
/// may be executed at the same time, so the mailbox reserves two slots.
template <typename T>
class LatestValue {
 public:
  explicit LatestValue(Mailbox& mailbox) : mailbox_(mailbox) {}

  /// Stores the value that `make` returns. Any thread; never waits. One thread at a time calls
  /// `make`; if `make` throws, nothing changes. The server later executes `token`, which calls
  /// Take().
  template <typename Make>
  Status Post(Mailbox::Entry& token, Make&& make) {
    if (!mailbox_.is_open()) return mailbox_.refusal();
    const TryLock<>::Hold writing(writing_);
    if (!writing) {  // another thread writes a value now, which counts as the newer one
      mailbox_.CountReplaced();
      return Status::kQueued;
    }
    return ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {
      if (newest_.Write(make())) {
        mailbox_.CountReplaced();
      } else {
        std::byte* const slot = mailbox_.ClaimReserved();
        assert(slot != nullptr);
        mailbox_.Publish(slot, token);
      }
      return Status::kQueued;
    });
  }

  /// Returns the newest value, or null if it was already taken. Called in the server's thread.
  T* Take() noexcept { return newest_.Take(); }

 private:
  Mailbox& mailbox_;
  TryLock<> writing_;
  TripleBuffer<T> newest_;
};

}  // namespace tendon
