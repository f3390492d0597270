#pragma once

#include <tendon/interface/execution/component_access.h>
#include <tendon/interface/mailbox.h>
#include <tendon/lockfree/triple_buffer.h>
#include <tendon/lockfree/try_lock.h>

#include <cassert>
#include <cstddef>

namespace tendon {

/// The argument of a command that keeps only its latest call. A newer argument replaces an older
/// one that is still queued. A token in the mailbox represents the queued argument. While one token
/// is executed, one more may be queued, so the mailbox reserves two slots.
template <typename T>
class LatestValue {
 public:
  explicit LatestValue(Mailbox& mailbox) : mailbox_(mailbox) {}

  /// Stores the value that `write` writes into its T&, which holds an old value. Never waits. Any
  /// thread, but only one thread at a time runs `write`; if `write` throws, nothing is stored. The
  /// server later executes `token`, which calls Take().
  template <typename Writer>
  Status Post(Mailbox::Entry& token, Writer&& write) {
    if (!mailbox_.is_open()) return mailbox_.refusal();
    const TryLock<>::Hold writing(writing_);
    if (!writing) {  // another thread writes a value now, which counts as the newer value
      mailbox_.CountReplaced();
      return Status::kQueued;
    }
    return ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {
      if (newest_.WriteWith(write)) {
        mailbox_.CountReplaced();
      } else {
        std::byte* const slot = mailbox_.ClaimReserved();
        assert(slot != nullptr);
        mailbox_.Publish(slot, token);
      }
      return Status::kQueued;
    });
  }

  /// Returns the newest value, or null if the server has already taken it. Called in the server's
  /// thread.
  T* Take() noexcept { return newest_.Take(); }

 private:
  Mailbox& mailbox_;
  TryLock<> writing_;
  TripleBuffer<T> newest_;
};

}  // namespace tendon
