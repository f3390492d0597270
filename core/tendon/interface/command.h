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

/// The argument of one call before it is encoded. The command decides where it is encoded, so that
/// it needs no copy. Used by one thread, during the call.
class ArgumentWriter {
 public:
  ArgumentWriter() = default;
  ArgumentWriter(const ArgumentWriter&) = delete;
  ArgumentWriter& operator=(const ArgumentWriter&) = delete;
  virtual ~ArgumentWriter() = default;

  /// Bytes of the encoded argument.
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Encodes the argument into `place`, which has size() bytes. False if it has another size now.
  /// May throw what the codec throws.
  [[nodiscard]] virtual bool WriteTo(std::span<std::byte> place) const = 0;
  /// The encoded argument in memory of the caller, valid during the call. May throw likewise.
  [[nodiscard]] virtual std::span<const std::byte> Encoded() const = 0;
};

/// A command bound for one connection: created when two interfaces are connected, destroyed after
/// the connection. It has two interfaces: a typed one for callers with the same types, and an
/// encoded one (CDR bodies) for proxies, consoles and plug-ins that were built with other types.
///
/// Thread safety: one thread at a time, or many threads if the connection was made for many.
class CommandBase {
 public:
  CommandBase(Layout in, Layout out) : in_layout_(in), out_layout_(out) {}
  CommandBase(const CommandBase&) = delete;
  CommandBase& operator=(const CommandBase&) = delete;
  virtual ~CommandBase() = default;

  /// Returns kInvalid if `in` cannot be decoded. Writes the reply to `out` only on success.
  virtual Status ExecuteEncoded(std::span<const std::byte> in, AnswerSink& out) = 0;
  /// The same for an argument that is not encoded yet. A command that keeps the encoded argument
  /// overrides it and encodes the argument where it is kept.
  virtual Status ExecuteFrom(const ArgumentWriter& in, AnswerSink& out) {
    return ExecuteEncoded(in.Encoded(), out);
  }
  /// ExecuteEncoded(), but waits for at most `timeout` until the call was executed. Replaces the
  /// content of `out`, which keeps its capacity.
  virtual Status WaitEncoded(std::span<const std::byte> /*in*/, std::vector<std::byte>& /*out*/,
                             std::chrono::nanoseconds /*timeout*/) {
    return Status::kUnsupported;
  }

  /// WaitEncoded() in two steps, for callers that must not block. kQueued: `call` identifies the
  /// call until EndEncoded(). `ended` is notified when the server has finished the call, or stops
  /// before that; it must outlive the command. Any other status is final.
  virtual Status BeginEncoded(std::span<const std::byte> /*in*/, std::vector<std::byte>& /*out*/,
                              Wakeup<>& /*ended*/, std::size_t& /*call*/) {
    return Status::kUnsupported;
  }
  [[nodiscard]] virtual bool HasEnded(std::size_t /*call*/) { return true; }
  /// Returns the outcome of a begun call. A call that has not ended is abandoned, as at a deadline.
  virtual Status EndEncoded(std::size_t /*call*/, std::vector<std::byte>& /*out*/) {
    return Status::kUnsupported;
  }

  /// Age of the value that the last read returned. 0 if every read goes to the server; the largest
  /// value if no value was read.
  [[nodiscard]] virtual std::chrono::nanoseconds age() const { return {}; }

  /// For event handlers: the source of the event has faulted, or is about to restart.
  virtual void SetSourceFaulted(bool /*faulted*/) {}

  /// True if this command may be cast to Command<In, Out>. The fingerprints must already be equal.
  template <Payload In, Payload Out>
  [[nodiscard]] bool Is() const {
    return in_layout_ == LayoutOf<In>() && out_layout_ == LayoutOf<Out>();
  }

 private:
  Layout in_layout_;
  Layout out_layout_;
};

/// The typed interface: a call costs one virtual call.
template <Payload In, Payload Out>
class Command : public CommandBase {
 public:
  Command() : CommandBase(LayoutOf<In>(), LayoutOf<Out>()) {}

  virtual Status Execute(const In& in, Out& out) = 0;
  /// Waits until the call was executed. kTimeout: not executed, and it will not be;
  /// kOutcomeUnknown: the execution was started. A command that runs in the caller's thread ignores
  /// `timeout`.
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

 protected:
  static void Put(const Out& answer, AnswerSink& out) {
    EncodeTo(answer, out.Room(EncodedSize(answer)));
  }

 private:
  struct Values {
    In in{};
    Out out{};
  };

  static void Put(const Out& answer, std::vector<std::byte>& out) { Encode(answer, out); }

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
