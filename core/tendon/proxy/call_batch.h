#pragma once

#include <tendon/base/clock.h>
#include <tendon/middleware/frame.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace tendon {

/// Several calls or events in the body of one frame, so that a burst of calls needs only one frame.
/// Each call consists of u32 handle, u32 size, the argument, and padding to 8 bytes; little-endian.
/// The memory in front of the body is reserved for the header of the frame.
class CallBatch {
 public:
  /// The largest number of bytes of a call in addition to its argument.
  static constexpr std::size_t kOverhead = 24;

  void Add(std::uint32_t handle, std::span<const std::byte> argument);
  /// Adds a call with a time: i64 `time` follows the argument, in ns on the steady clock of this
  /// process. The size of the call includes the time.
  void AddTimed(std::uint32_t handle, std::span<const std::byte> argument, SteadyTime time);
  void Clear();

  [[nodiscard]] bool empty() const { return calls_ == 0; }
  [[nodiscard]] std::size_t calls() const { return calls_; }
  [[nodiscard]] std::span<const std::byte> body() const {
    return std::span(frame_).subspan(empty() ? 0 : FrameHeader::kSize);
  }
  /// The body, preceded by the memory for the header; empty if there are no calls.
  [[nodiscard]] std::span<std::byte> frame() { return frame_; }

 private:
  /// Writes the head of a call and returns the memory for its argument.
  std::byte* AddHead(std::uint32_t handle, std::size_t size);

  std::size_t calls_ = 0;
  Bytes frame_;
};

/// Calls `visit(handle, argument)` for each call in `body`, which is untrusted. Stops at the first
/// incomplete call.
template <typename Visitor>
void ForEachCall(std::span<const std::byte> body, Visitor visit) {
  constexpr std::size_t kHead = 8;
  while (body.size() >= kHead) {
    std::uint32_t handle = 0;
    std::uint32_t size = 0;
    std::memcpy(&handle, body.data(), sizeof handle);
    std::memcpy(&size, body.data() + sizeof handle, sizeof size);
    body = body.subspan(kHead);
    if (size > body.size()) return;
    visit(handle, body.first(size));
    const std::size_t padded = (std::size_t{size} + 7) / 8 * 8;
    body = body.subspan(std::min(padded, body.size()));
  }
}

/// Calls `visit(handle, argument, time)` for each call in `body`, whose calls have times. A time is
/// on the steady clock of the sender. Skips calls that are too short to contain a time.
template <typename Visitor>
void ForEachTimedCall(std::span<const std::byte> body, Visitor visit) {
  ForEachCall(body, [&visit](std::uint32_t handle, std::span<const std::byte> timed) {
    std::int64_t time = 0;
    if (timed.size() < sizeof time) return;
    const std::size_t size = timed.size() - sizeof time;
    std::memcpy(&time, timed.data() + size, sizeof time);
    visit(handle, timed.first(size), SteadyTime(std::chrono::nanoseconds(time)));
  });
}

}  // namespace tendon
