#pragma once

#include <tendon/base/clock.h>
#include <tendon/interface/offer.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/triple_buffer.h>
#include <tendon/lockfree/try_lock.h>
#include <tendon/lockfree/wakeup.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

namespace tendon {

/// Lets a thread wait for an event instead of handling it. Make it a member of the component.
///
///     robot.AddEventWaiter(homed_, "Homed");
///     ...
///     homed_.Forget();
///     (void)home_();
///     if (!homed_.Wait(2s)) ...
///
/// Keeps the newest value raised since the last Wait() or Forget(). Raising the event costs one
/// wake-up and never waits.
///
/// Thread safety: one thread calls Wait() and Forget().
template <typename T>
class EventWaiter {
  static_assert(RequirePayload<T>());

 public:
  EventWaiter() = default;
  EventWaiter(const EventWaiter&) = delete;
  EventWaiter& operator=(const EventWaiter&) = delete;

  /// Waits for an event, and returns kDone and the newest value. Returns at once if an event was
  /// raised since the last wait. Returns kTimeout if no event is raised in time, kNotConnected if
  /// there is no connection to a source, and kNotActive while the source is faulted.
  Status Wait(T& value, std::chrono::nanoseconds timeout) requires(!std::is_same_v<T, None>) {
    return Await(value, timeout);
  }
  Status Wait(std::chrono::nanoseconds timeout) requires std::is_same_v<T, None> {
    None nothing;
    return Await(nothing, timeout);
  }
  /// Discards the kept value, so that only a later event ends a wait.
  void Forget() noexcept { newest_.Take(); }

  /// Number of values that were replaced by newer ones before a Wait() returned them.
  [[nodiscard]] std::uint64_t missed() const noexcept { return missed_.value(); }

 private:
  friend class RequiredInterface;

  /// Represents one connection, and lives as long as the connection.
  class Handler final : public Command<T, None> {
   public:
    explicit Handler(EventWaiter& waiter) : waiter_(waiter) { Report(Status::kTimeout); }
    ~Handler() override { Report(Status::kNotConnected); }
    Handler(const Handler&) = delete;
    Handler& operator=(const Handler&) = delete;

    Status Execute(const T& value, None& /*out*/) override {
      return ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {  // a copy may throw
        waiter_.Raised(value);
        return Status::kDone;
      });
    }
    void SetSourceFaulted(bool faulted) override {
      Report(faulted ? Status::kNotActive : Status::kTimeout);
    }

   private:
    void Report(Status::Code ending) {
      waiter_.ending_.Set(ending);
      waiter_.wakeup_.Notify();
    }

    EventWaiter& waiter_;
  };
  class HandlerOffer final : public Offer {
   public:
    HandlerOffer(MemberDescription description, EventWaiter& waiter)
        : Offer(std::move(description)), waiter_(waiter) {}
    [[nodiscard]] bool uses_mailbox() const override { return false; }
    [[nodiscard]] bool RunsInCaller(bool /*has_mailbox*/) const override { return false; }
    [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* /*mailbox*/) const override {
      return std::make_unique<Handler>(waiter_);
    }

   private:
    EventWaiter& waiter_;
  };

  /// Stores a value. Runs in the thread that raises the event. If several threads raise the event
  /// at once, one value is kept.
  void Raised(const T& value) {
    {
      const TryLock<>::Hold raising(raising_);
      if (!raising) return missed_.Add();
      if (newest_.Write(value)) missed_.Add();
    }
    wakeup_.Notify();
  }

  Status Await(T& value, std::chrono::nanoseconds timeout) {
    const SteadyTime deadline = DeadlineAfter(timeout);
    const auto is_over = [this] { return ending_.Get() != Status::kTimeout; };
    wakeup_.WaitUntil([&] { return newest_.is_fresh() || is_over(); }, deadline);
    const T* newest = newest_.Take();
    if (newest == nullptr) return ending_.Get();
    return ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {  // a copy may throw
      value = *newest;
      return Status::kDone;
    });
  }

  Published<Status::Code> ending_{Status::kNotConnected};  // result of a wait without an event
  TryLock<> raising_;
  TripleBuffer<T> newest_;
  SharedCounter<> missed_;
  Wakeup<> wakeup_;
};

}  // namespace tendon
