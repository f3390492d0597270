#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/execution/reply_sink.h>

#include <chrono>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace tendon {

/// Calls a command with encoded values: encodes the typed argument, and decodes the reply.
template <Payload In, Payload Out>
class ConvertingCommand final : public Command<In, Out> {
 public:
  explicit ConvertingCommand(CommandBase& target) : target_(target) {}

  Status Execute(const In& in, Out& out) override {
    typename Scratch<Bodies>::Use bodies(bodies_);
    const Encoder argument(in, bodies->in);
    Decoder reply(bodies->out, out);
    const Status status = target_.ExecuteFrom(argument, reply);
    return status && !reply.Finish() ? Status(Status::kInvalid) : status;
  }
  Status Wait(const In& in, Out& out, std::chrono::nanoseconds timeout) override {
    typename Scratch<Bodies>::Use bodies(bodies_);
    Encode(in, bodies->in);
    Decoder reply(bodies->out, out);
    const Status status = target_.WaitEncoded(bodies->in, bodies->out, timeout);
    return status && !reply.Decode(bodies->out) ? Status(Status::kInvalid) : status;
  }
  [[nodiscard]] std::chrono::nanoseconds age() const override { return target_.age(); }

 private:
  struct Bodies {
    std::vector<std::byte> in;
    std::vector<std::byte> out;
  };

  /// Encodes the argument into the memory that the target chooses.
  class Encoder final : public ArgumentWriter {
   public:
    /// `room` is the buffer for a target that calls Encoded().
    Encoder(const In& in, std::vector<std::byte>& room) : in_(in), room_(room) {}

    [[nodiscard]] std::size_t size() const override { return EncodedSize(in_); }
    [[nodiscard]] bool WriteTo(std::span<std::byte> place) const override {
      return EncodeTo(in_, place) == place.size();
    }
    [[nodiscard]] std::span<const std::byte> Encoded() const override {
      Encode(in_, room_);
      return room_;
    }

   private:
    const In& in_;
    std::vector<std::byte>& room_;
  };

  /// Decodes a reply in place.
  class Decoder final : public ReplySink {
   public:
    /// `room` is the buffer for a target that calls Room().
    Decoder(std::vector<std::byte>& room, Out& out) : room_(room), out_(out) {}

    std::span<std::byte> Room(std::size_t size) override {
      room_.resize(size);
      is_in_room_ = true;
      return room_;
    }
    void Take(std::span<const std::byte> reply) override { has_decoded_ = Decode(reply); }

    bool Decode(std::span<const std::byte> reply) {
      if constexpr (std::is_same_v<Out, None>) return true;
      return tendon::Decode(reply, out_);
    }
    /// Called after the target was called. Returns false if the reply cannot be decoded.
    [[nodiscard]] bool Finish() {
      if constexpr (std::is_same_v<Out, None>) return true;
      return is_in_room_ ? Decode(room_) : has_decoded_;
    }

   private:
    std::vector<std::byte>& room_;
    Out& out_;
    bool is_in_room_ = false;
    bool has_decoded_ = false;
  };

  CommandBase& target_;
  Scratch<Bodies> bodies_;
};

}  // namespace tendon
