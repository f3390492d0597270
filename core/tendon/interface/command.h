#pragma once

#include <tendon/base/status.h>
#include <tendon/interface/execution/argument_writer.h>
#include <tendon/interface/execution/reply_sink.h>
#include <tendon/interface/execution/scratch.h>
#include <tendon/lockfree/wakeup.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/layout.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace tendon {

/// A command that is bound for one connection. It is created when two interfaces are connected, and
/// destroyed after the connection. Callers with the same types call it with typed values. Proxies,
/// consoles, and plug-ins that were built with other types call it with encoded values (CDR
/// bodies).
///
/// Thread safety: one thread at a time, or many threads if the connection was made for many.
class CommandBase {
 public:
  CommandBase(Layout in, Layout out) : in_layout_(in), out_layout_(out) {}
  CommandBase(const CommandBase&) = delete;
  CommandBase& operator=(const CommandBase&) = delete;
  virtual ~CommandBase() = default;

  /// Executes the command with an encoded argument. Returns kInvalid if `in` cannot be decoded.
  /// Writes the reply to `out` only on success.
  virtual Status ExecuteEncoded(std::span<const std::byte> in, ReplySink& out) = 0;
  /// Like ExecuteEncoded(), for an argument that is not encoded yet. A command that stores the
  /// encoded argument overrides this function and encodes the argument directly into its storage.
  virtual Status ExecuteFrom(const ArgumentWriter& in, ReplySink& out) {
    return ExecuteEncoded(in.Encoded(), out);
  }
  /// Like ExecuteEncoded(), but waits at most `timeout` for the end of the execution. Replaces the
  /// content of `out`, which keeps its capacity.
  virtual Status WaitEncoded(std::span<const std::byte> /*in*/, std::vector<std::byte>& /*out*/,
                             std::chrono::nanoseconds /*timeout*/) {
    return Status::kUnsupported;
  }

  /// Starts a call without blocking; together with EndEncoded() it replaces WaitEncoded(). After
  /// kQueued, `call` identifies the call until EndEncoded(), and `ended` is notified when the
  /// server has finished the call or has stopped before it. Any other status is final. `ended` must
  /// outlive the command.
  virtual Status BeginEncoded(std::span<const std::byte> /*in*/, std::vector<std::byte>& /*out*/,
                              Wakeup<>& /*ended*/, std::size_t& /*call*/) {
    return Status::kUnsupported;
  }
  [[nodiscard]] virtual bool HasEnded(std::size_t /*call*/) { return true; }
  /// Returns the outcome of a call that BeginEncoded() has queued. If the call has not ended,
  /// abandons it, as WaitEncoded() does at its deadline.
  virtual Status EndEncoded(std::size_t /*call*/, std::vector<std::byte>& /*out*/) {
    return Status::kUnsupported;
  }

  /// Returns the age of the value that the last read returned. Returns 0 if every read goes to the
  /// server, and the largest value if no value was read.
  [[nodiscard]] virtual std::chrono::nanoseconds age() const { return {}; }

  /// Sets the name of the caller, for observers of the calls. Called once, before the first call.
  virtual void SetClient(const std::shared_ptr<const std::string>& /*client*/) {}

  /// For event handlers. Called with true when the component that raises the event has faulted, and
  /// with false when it is about to restart.
  virtual void SetSourceFaulted(bool /*faulted*/) {}

  /// True if this command may be cast to Command<In, Out>. The caller has already checked that the
  /// fingerprints are equal.
  template <Payload In, Payload Out>
  [[nodiscard]] bool Is() const {
    return in_layout_ == LayoutOf<In>() && out_layout_ == LayoutOf<Out>();
  }

 private:
  Layout in_layout_;
  Layout out_layout_;
};

/// A command that is called with typed values. A call costs one virtual function call.
template <Payload In, Payload Out>
class Command : public CommandBase {
 public:
  Command() : CommandBase(LayoutOf<In>(), LayoutOf<Out>()) {}

  virtual Status Execute(const In& in, Out& out) = 0;
  /// Waits until the call is executed. Returns kTimeout if the call was not executed and never will
  /// be. Returns kOutcomeUnknown if the execution has started. A command that runs in the caller's
  /// thread ignores `timeout`.
  virtual Status Wait(const In& in, Out& out, std::chrono::nanoseconds /*timeout*/) {
    return Execute(in, out);
  }
  /// See BeginEncoded().
  virtual Status Begin(const In& in, Out& out, Wakeup<>& /*ended*/, std::size_t& /*call*/) {
    return Execute(in, out);
  }
  virtual Status End(std::size_t /*call*/, Out& /*out*/) { return Status::kUnsupported; }

  Status ExecuteEncoded(std::span<const std::byte> in, ReplySink& out) override {
    return Convert(in, out, [this](const In& typed, Out& reply) { return Execute(typed, reply); });
  }
  Status WaitEncoded(std::span<const std::byte> in, std::vector<std::byte>& out,
                     std::chrono::nanoseconds timeout) final {
    return Convert(in, out, [this, timeout](const In& typed, Out& reply) {
      return Wait(typed, reply, timeout);
    });
  }
  Status BeginEncoded(std::span<const std::byte> in, std::vector<std::byte>& out, Wakeup<>& ended,
                      std::size_t& call) final {
    return Convert(in, out,
                   [&](const In& typed, Out& reply) { return Begin(typed, reply, ended, call); });
  }
  Status EndEncoded(std::size_t call, std::vector<std::byte>& out) final {
    typename Scratch<Values>::Use values(values_);
    const Status status = End(call, values->out);
    if (status) Put(values->out, out);
    return status;
  }

 protected:
  static void Put(const Out& reply, ReplySink& out) {
    EncodeTo(reply, out.Room(EncodedSize(reply)));
  }

 private:
  struct Values {
    In in{};
    Out out{};
  };

  static void Put(const Out& reply, std::vector<std::byte>& out) { Encode(reply, out); }

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
