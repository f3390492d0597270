#pragma once

#include <tendon/base/status.h>
#include <tendon/interface/mailbox.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/layout.h>

#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace tendon {

/// An operation bound for one caller: made when two interfaces are connected, called by one thread
/// at a time, destroyed after the connection. It has two faces: typed for callers that share the
/// type, and encoded (CDR bodies) for those that do not: proxies, other plug-ins' types, consoles.
class CommandBase {
 public:
  CommandBase(Layout in, Layout out) : in_layout_(in), out_layout_(out) {}
  CommandBase(const CommandBase&) = delete;
  CommandBase& operator=(const CommandBase&) = delete;
  virtual ~CommandBase() = default;

  /// kInvalid when `in` does not decode. `out` is replaced and keeps its capacity.
  virtual Status ExecuteEncoded(std::span<const std::byte> in, std::vector<std::byte>& out) = 0;

  /// Whether it may be cast to Command<In, Out>, the fingerprints being equal.
  template <Payload In, Payload Out>
  [[nodiscard]] bool Is() const {
    return in_layout_ == LayoutOf<In>() && out_layout_ == LayoutOf<Out>();
  }

 private:
  Layout in_layout_;
  Layout out_layout_;
};

/// The typed face: one virtual call.
template <Payload In, Payload Out>
class Command : public CommandBase {
 public:
  Command() : CommandBase(LayoutOf<In>(), LayoutOf<Out>()) {}

  virtual Status Execute(const In& in, Out& out) = 0;

  Status ExecuteEncoded(std::span<const std::byte> in, std::vector<std::byte>& out) final {
    if constexpr (!std::is_same_v<In, None>) {
      if (!Decode(in, in_)) return Status::kInvalid;
    }
    const Status status = Execute(in_, out_);
    if (status) Encode(out_, out);
    return status;
  }

 private:
  In in_{};
  Out out_{};
};

/// Calls an encoded command with typed values, through the codec.
template <Payload In, Payload Out>
class ConvertingCommand final : public Command<In, Out> {
 public:
  explicit ConvertingCommand(CommandBase& target) : target_(target) {}

  Status Execute(const In& in, Out& out) override {
    Encode(in, encoded_in_);
    const Status status = target_.ExecuteEncoded(encoded_in_, encoded_out_);
    if constexpr (!std::is_same_v<Out, None>) {
      if (status && !Decode(encoded_out_, out)) return Status::kInvalid;
    }
    return status;
  }

 private:
  CommandBase& target_;
  std::vector<std::byte> encoded_in_;
  std::vector<std::byte> encoded_out_;
};

/// Types that may lie in a mailbox' slot as they are; others go through a pool of objects that are
/// assigned, and keep what they have allocated.
template <typename T>
inline constexpr bool kLiesInSlot = std::is_trivially_copyable_v<T>;

/// Void and write commands, and event handlers: hands the call over to the thread that empties the
/// mailbox. Without a mailbox (a component without a thread) it runs in the caller's thread.
template <Payload In, typename Handler>
class QueuedCommand final : public Command<In, None>, private Mailbox::Entry {
 public:
  static_assert(alignof(In) <= 64, "an argument of a queued command is aligned to at most 64");

  QueuedCommand(Handler handler, Mailbox* mailbox)
      : handler_(std::move(handler)), mailbox_(mailbox) {
    if constexpr (!kLiesInSlot<In>) {
      if (mailbox_ != nullptr) pool_.resize(mailbox_->storage());
    }
  }

  static constexpr Mailbox::SlotShape Shape() {
    return kLiesInSlot<In> ? Mailbox::SlotShape{sizeof(In), alignof(In)} : Mailbox::SlotShape{};
  }

  Status Execute(const In& in, None& /*out*/) override {
    if (mailbox_ == nullptr) return ExecuteNow(in);
    if (!mailbox_->accepting()) return Status::kNotActive;
    std::byte* argument = mailbox_->Claim();
    if (argument == nullptr) return Status::kQueueFull;
    if constexpr (kLiesInSlot<In>) {
      new (argument) In(in);
    } else {
      pool_[mailbox_->claimed_slot()] = in;
    }
    mailbox_->Publish(*this);
    return Status::kQueued;
  }

 private:
  Status ExecuteNow(const In& in) {
    try {
      handler_(in);
      return Status::kDone;
    } catch (...) {
      return Status::kFailed;
    }
  }

  void ExecuteSlot(std::byte* argument, std::size_t slot) override {
    if constexpr (kLiesInSlot<In>) {
      handler_(*std::launder(reinterpret_cast<In*>(argument)));
    } else {
      handler_(pool_[slot]);
    }
  }

  Handler handler_;
  Mailbox* mailbox_;
  std::vector<In> pool_;
};

/// Reads and qualified reads: runs `body(in, out) -> Status` in the caller's thread.
template <Payload In, Payload Out, typename Body>
class DirectCommand final : public Command<In, Out> {
 public:
  explicit DirectCommand(Body body) : body_(std::move(body)) {}

  Status Execute(const In& in, Out& out) override {
    try {
      return body_(in, out);
    } catch (...) {
      return Status::kFailed;
    }
  }

 private:
  Body body_;
};

}  // namespace tendon
