#pragma once

#include <tendon/base/os/socket.h>
#include <tendon/middleware/middleware.h>

#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "conformance/recorder.h"

namespace tendon::ice {

/// Builds messages of the Ice protocol byte by byte, so that they can be wrong.
class RawMessage {
 public:
  enum Type : unsigned char { kRequest, kBatch, kReply, kValidate, kClose };

  explicit RawMessage(Type type, unsigned char compression = 0) {
    Text("IceP");
    Byte(1).Byte(0).Byte(1).Byte(0).Byte(type).Byte(compression).Int(0);
  }

  RawMessage& Byte(unsigned value) {
    bytes_.push_back(static_cast<std::byte>(value));
    return *this;
  }
  RawMessage& Int(std::int64_t value) {
    for (int i = 0; i < 4; ++i) Byte(static_cast<unsigned>(value >> (8 * i)) & 0xffU);
    return *this;
  }
  RawMessage& Text(std::string_view text) {
    for (const char c : text) Byte(static_cast<unsigned char>(c));
    return *this;
  }
  RawMessage& String(std::string_view text) {
    return Byte(static_cast<unsigned>(text.size())).Text(text);
  }
  /// Writes a size in its long form, even if the short form would be enough.
  RawMessage& Size(std::int64_t size) { return Byte(255).Int(size); }
  /// Writes the identity "tendon", no facet, `operation`, mode normal, and no context.
  RawMessage& Target(std::string_view operation, int request = 1) {
    return Int(request).String("tendon").String("").Byte(0).String(operation).Byte(0).Byte(0);
  }

  /// Returns the message. Its header contains the true size.
  [[nodiscard]] Bytes Finished() const {
    return Claiming(static_cast<std::int64_t>(bytes_.size()));
  }
  [[nodiscard]] Bytes Claiming(std::int64_t size) const {
    RawMessage copy(*this);
    RawMessage field(kRequest);
    field.bytes_.clear();
    field.Int(size);
    std::memcpy(copy.bytes_.data() + 10, field.bytes_.data(), 4);
    return copy.bytes_;
  }

 private:
  Bytes bytes_;
};

/// Sends all bytes.
inline void SendAll(const os::Socket& socket, std::span<const std::byte> bytes) {
  EventuallyTrue([&] {
    const auto sent = os::SendSome(socket, bytes);
    bytes = sent ? bytes.subspan(*sent) : std::span<const std::byte>();
    return bytes.empty();
  });
}

/// Receives until there are `wanted` bytes or the other end closes the connection. Returns the
/// received bytes.
inline Bytes ReceiveAll(const os::Socket& socket, std::size_t wanted) {
  Bytes all;
  Bytes buffer(4096);
  EventuallyTrue([&] {
    const auto some = os::ReceiveSome(
        socket, std::span(buffer).first(std::min(buffer.size(), wanted - all.size())));
    if (!some) return true;
    all.insert(all.end(), some->begin(), some->end());
    return all.size() >= wanted;
  });
  return all;
}

}  // namespace tendon::ice
