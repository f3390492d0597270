#pragma once

#include <tendon/interface/execution/component_access.h>
#include <tendon/interface/mailbox.h>
#include <tendon/lockfree/triple_buffer.h>
#include <tendon/lockfree/try_lock.h>

#include <cassert>
#include <cstddef>

namespace tendon {

/// The argument of a command that keeps only its latest call: a newer one replaces an older one
/// that still waits. One token in the mailbox stands for the waiting argument. With a token that is
/// being executed, this takes two slots, which the mailbox reserves.
template <typename T>
class LatestValue {
 public:
  explicit LatestValue(Mailbox& mailbox) : mailbox_(mailbox) {}

  /// Any thread; never waits. `make` returns the value and is called by one thread at a time; if it
  /// throws, nothing has changed. The server later executes `token`, which calls Take().
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

  /// In the server's thread; null if the value was already taken.
  T* Take() noexcept { return newest_.Take(); }

 private:
  Mailbox& mailbox_;
  TryLock<> writing_;
  TripleBuffer<T> newest_;
};

}  // namespace tendon
