#pragma once

#include <support/machine/sanitized.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/ice/attacks.h"

namespace tendon::ice {

/// The number of mutants that are sent to a program: 20,000 if TENDON_FULL_FAULTS is set. With a
/// sanitizer, each mutant takes about ten times longer.
inline int MutantsWithoutTls() {
  if (std::getenv("TENDON_FULL_FAULTS") != nullptr) return 20'000;
  return test::IsSanitized() ? 2'000 : 5'000;
}

/// The number of mutants inside TLS, where most mutants need a new handshake.
inline int MutantsInTls() {
  if (std::getenv("TENDON_FULL_FAULTS") != nullptr) return 20'000;
  return test::IsSanitized() ? 200 : 1'000;
}

/// Valid messages in which one to four bytes were changed. The changes are the same in every run.
class Mutants {
 public:
  Bytes Next() {
    Bytes mutant = right_[random_() % right_.size()];
    const unsigned changes = 1 + random_() % 4U;
    for (unsigned i = 0; i < changes; ++i) {
      mutant[random_() % mutant.size()] = static_cast<std::byte>(random_());
    }
    return mutant;
  }

 private:
  static Bytes WithFrame() {
    const Bytes frame = conformance::FrameOf(1);
    const std::string_view text(reinterpret_cast<const char*>(frame.data()), frame.size());
    return Request()
        .Int(static_cast<int>(7 + frame.size()))
        .Byte(1)
        .Byte(1)
        .String(text)
        .Finished();
  }

  std::mt19937 random_{4711};
  const std::vector<Bytes> right_{
      WithSequence(4).Finished(), WithFrame(),
      Request("ice_isA").Int(20).Byte(1).Byte(1).String("::Ice::Object").Finished(),
      RawMessage(RawMessage::kBatch).Int(1).String("tendon").Finished()};
};

/// The header of a message of Ice, read from its first bytes.
struct IceHeader {
  static constexpr std::size_t kSize = 14;

  explicit IceHeader(std::span<const std::byte> bytes) : size(IntAt(bytes, 10)) {
    const bool is_reply = bytes[8] == std::byte{RawMessage::kReply};
    is_end = bytes[8] == std::byte{RawMessage::kClose};
    if (is_reply && bytes.size() >= kSize + 4) request = IntAt(bytes, kSize);
  }
  static std::uint32_t IntAt(std::span<const std::byte> bytes, std::size_t place) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i > 0; --i) {
      value = (value << 8U) | std::to_integer<std::uint32_t>(bytes[place + i - 1]);
    }
    return value;
  }

  std::uint32_t size = 0;
  std::uint32_t request = 0;  // the request that this message answers, or 0
  bool is_end = false;        // closes the connection; the other end must hang up
};

/// Sends messages over one connection until the connection ends. `Connection` has Send(), which
/// returns false on a failure, and Receive(), which waits for some bytes and returns none at the
/// end.
template <typename Connection>
class Conversation {
 public:
  explicit Conversation(Connection connection) : connection_(std::move(connection)) {}

  /// Sends the message and checks that it was read: a ping sent after it is answered. Returns false
  /// if the connection has ended. After a message that claims to continue, no ping is sent, because
  /// the ping would count as a part of the message. Such a message is the last one on its
  /// connection.
  bool Bears(const Bytes& message) {
    const Bytes ping = Request("ice_ping", kPing).Int(6).Byte(1).Byte(1).Finished();
    const bool claims_more = IceHeader(message).size > message.size();
    return connection_.Send(message) && !claims_more && connection_.Send(ping) && IsAnswered();
  }

 private:
  static constexpr std::uint32_t kPing = 0x50494e47;

  bool IsAnswered() {
    while (true) {
      while (heard_.size() >= IceHeader::kSize && heard_.size() >= IceHeader(heard_).size) {
        const IceHeader header(heard_);
        const bool is_answer = header.request == kPing;
        heard_.erase(heard_.begin(), heard_.begin() + header.size);
        if (is_answer || header.is_end) return is_answer;
      }
      const Bytes some = connection_.Receive();
      if (some.empty()) return false;
      heard_.insert(heard_.end(), some.begin(), some.end());
    }
  }

  Connection connection_;
  Bytes heard_;
};

/// Sends `count` messages over connections made by `connect()`. Each connection sends as many
/// messages as the peer accepts. Returns the number of connections.
template <typename Connect>
int SayMutants(Mutants& mutants, int count, Connect connect) {
  int connections = 0;
  while (count > 0) {
    Conversation conversation(connect());
    ++connections;
    for (bool goes_on = true; goes_on && count > 0; --count) {
      goes_on = conversation.Bears(mutants.Next());
    }
  }
  return connections;
}

}  // namespace tendon::ice
