#pragma once

#include <tendon/interface/command.h>

#include <chrono>
#include <type_traits>
#include <vector>

namespace tendon {

/// Calls an encoded command with typed values, through the codec.
template <Payload In, Payload Out>
class ConvertingCommand final : public Command<In, Out> {
 public:
  explicit ConvertingCommand(CommandBase& target) : target_(target) {}

  Status Execute(const In& in, Out& out) override {
    return Convert(in, out, [this](const auto& encoded, auto& answer) {
      return target_.ExecuteEncoded(encoded, answer);
    });
  }
  Status Wait(const In& in, Out& out, std::chrono::nanoseconds timeout) override {
    return Convert(in, out, [this, timeout](const auto& encoded, auto& answer) {
      return target_.WaitEncoded(encoded, answer, timeout);
    });
  }
  [[nodiscard]] std::chrono::nanoseconds age() const override { return target_.age(); }

 private:
  struct Bodies {
    std::vector<std::byte> in;
    std::vector<std::byte> out;
  };

  template <typename Call>
  Status Convert(const In& in, Out& out, Call call) {
    typename Scratch<Bodies>::Use bodies(bodies_);
    Encode(in, bodies->in);
    const Status status = call(bodies->in, bodies->out);
    if constexpr (!std::is_same_v<Out, None>) {
      if (status && !Decode(bodies->out, out)) return Status::kInvalid;
    }
    return status;
  }

  CommandBase& target_;
  Scratch<Bodies> bodies_;
};

}  // namespace tendon
