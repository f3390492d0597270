#pragma once

#include <tendon/base/status.h>
#include <tendon/interface/execution/answer_sink.h>
#include <tendon/interface/execution/scratch.h>
#include <tendon/lockfree/wakeup.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/layout.h>

#include <chrono>
#include <span>
#include <type_traits>
#include <vector>

namespace tendon {

/// An operation bound for one connection: made when two interfaces are connected, destroyed after
/// the connection. It has two faces: typed for callers that share the type, and encoded (CDR
/// bodies) for those that do not: proxies, other plug-ins' types, consoles.
///
/// Thread safety: called by one thread at a time, or by many where the connection was made for
/// many.
class CommandBase {
 public:
  CommandBase(Layout in, Layout out) : in_layout_(in), out_layout_(out) {}
  CommandBase(const CommandBase&) = delete;
  CommandBase& operator=(const CommandBase&) = delete;
  virtual ~CommandBase() = default;

  /// kInvalid when `in` does not decode. `out` gets the answer of what has come to a good end.
  virtual Status ExecuteEncoded(std::span<const std::byte> in, AnswerSink& out) = 0;
  /// The same, and waits until it was executed: for at most `timeout`. `out` is replaced and keeps
  /// its capacity.
  virtual Status WaitEncoded(std::span<const std::byte> /*in*/, std::vector<std::byte>& /*out*/,
                             std::chrono::nanoseconds /*timeout*/) {
    return Status::kUnsupported;
  }

  /// WaitEncoded() in two halves, for who must not block. kQueued: `call` is its number until
  /// EndEncoded(), and `ended`, which outlives the command, is notified once the server has done
  /// with it, or has stopped after it was posted. Any other status is its end.
  virtual Status BeginEncoded(std::span<const std::byte> /*in*/, std::vector<std::byte>& /*out*/,
                              Wakeup<>& /*ended*/, std::size_t& /*call*/) {
    return Status::kUnsupported;
  }
  [[nodiscard]] virtual bool HasEnded(std::size_t /*call*/) { return true; }
  /// How a call has ended that was begun. One that has not is given up, as at the deadline.
  virtual Status EndEncoded(std::size_t /*call*/, std::vector<std::byte>& /*out*/) {
    return Status::kUnsupported;
  }

  /// How old the value is that a read has answered last; 0 where each read asks, and the largest
  /// value where there was none.
  [[nodiscard]] virtual std::chrono::nanoseconds age() const { return {}; }

  /// For handlers of events: their source has faulted, or is about to start anew.
  virtual void SetSourceFaulted(bool /*faulted*/) {}

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
  /// Returns once it was executed; kTimeout when it was not and will not be, kOutcomeUnknown when
  /// it was started. What runs in the caller's thread ends when it ends.
  virtual Status Wait(const In& in, Out& out, std::chrono::nanoseconds /*timeout*/) {
    return Execute(in, out);
  }
  /// See BeginEncoded().
  virtual Status Begin(const In& in, Out& out, Wakeup<>& /*ended*/, std::size_t& /*call*/) {
    return Execute(in, out);
  }
  virtual Status End(std::size_t /*call*/, Out& /*out*/) { return Status::kUnsupported; }

  Status ExecuteEncoded(std::span<const std::byte> in, AnswerSink& out) override {
    return Convert(in, out,
                   [this](const In& typed, Out& answer) { return Execute(typed, answer); });
  }
  Status WaitEncoded(std::span<const std::byte> in, std::vector<std::byte>& out,
                     std::chrono::nanoseconds timeout) final {
    return Convert(in, out, [this, timeout](const In& typed, Out& answer) {
      return Wait(typed, answer, timeout);
    });
  }
  Status BeginEncoded(std::span<const std::byte> in, std::vector<std::byte>& out, Wakeup<>& ended,
                      std::size_t& call) final {
    return Convert(in, out,
                   [&](const In& typed, Out& answer) { return Begin(typed, answer, ended, call); });
  }
  Status EndEncoded(std::size_t call, std::vector<std::byte>& out) final {
    typename Scratch<Values>::Use values(values_);
    const Status status = End(call, values->out);
    if (status) Put(values->out, out);
    return status;
  }

 private:
  struct Values {
    In in{};
    Out out{};
  };

  static void Put(const Out& answer, std::vector<std::byte>& out) { Encode(answer, out); }
  static void Put(const Out& answer, AnswerSink& out) {
    EncodeTo(answer, out.Room(EncodedSize(answer)));
  }

  template <typename Sink, typename Call>
  Status Convert(std::span<const std::byte> in, Sink& out, Call call) {
    typename Scratch<Values>::Use values(values_);
    if constexpr (!std::is_same_v<In, None>) {
      if (!Decode(in, values->in)) return Status::kInvalid;
    }
    const Status status = call(values->in, values->out);
    if (status) Put(values->out, out);
    return status;
  }

  Scratch<Values> values_;
};

}  // namespace tendon
