#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace tendon {

/// Receives the encoded reply of one call. A large reply is written directly to its destination,
/// without a copy. Used by one thread, which calls each function at most once.
class ReplySink {
 public:
  ReplySink() = default;
  ReplySink(const ReplySink&) = delete;
  ReplySink& operator=(const ReplySink&) = delete;
  virtual ~ReplySink() = default;

  /// Returns memory for a reply of `size` bytes; the caller must write all of them. Returns an
  /// empty span if there is not enough memory. May throw std::bad_alloc.
  virtual std::span<std::byte> Room(std::size_t size) = 0;
  /// An alternative to Room() for a reply that is already encoded and stays valid during the call.
  /// The default implementation copies the reply.
  virtual void Take(std::span<const std::byte> reply) {
    const std::span<std::byte> room = Room(reply.size());
    if (!room.empty()) std::ranges::copy(reply, room.begin());
  }
};

/// Stores the reply in `bytes` and replaces the former content. `bytes` keeps its capacity and must
/// outlive the sink.
class BytesSink final : public ReplySink {
 public:
  explicit BytesSink(std::vector<std::byte>& bytes) : bytes_(bytes) {}

  std::span<std::byte> Room(std::size_t size) override {
    bytes_.resize(size);
    return bytes_;
  }

 private:
  std::vector<std::byte>& bytes_;
};

}  // namespace tendon
