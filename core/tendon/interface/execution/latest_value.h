#pragma once

#include <tendon/interface/execution/host.h>
#include <tendon/interface/mailbox.h>
#include <tendon/lockfree/lease.h>
#include <tendon/lockfree/snapshot.h>

#include <cassert>
#include <cstddef>

namespace tendon {

/// The argument of calls of which only the latest is kept: a newer one replaces an older one that
/// still waits. One token in the mailbox says that one waits; with the one that is being executed
/// that takes two slots, which the mailbox has in reserve.
template <typename T>
class LatestValue {
 public:
  explicit LatestValue(Mailbox& mailbox) : mailbox_(mailbox) {}

  /// Any thread; never waits. `make` gives the value, one caller at a time: where it throws nothing
  /// has happened. `token` is what the server executes, and takes it then.
  template <typename Make>
  Status Post(Mailbox::Entry& token, Make&& make) {
    if (!mailbox_.is_open()) return mailbox_.refusal();
    const Lease<>::Hold writing(writing_);
    if (!writing) {  // the call that writes right now is the newer one
      mailbox_.CountReplaced();
      return Status::kQueued;
    }
    return Host::Contain(nullptr, [&]() -> Status {
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

  /// In the server's thread; null where it was taken already.
  T* Take() noexcept { return newest_.Take(); }

 private:
  Mailbox& mailbox_;
  Lease<> writing_;
  Snapshot<T> newest_;
};

}  // namespace tendon
