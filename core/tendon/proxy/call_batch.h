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

/// Several calls or events in the body of one frame, so that a burst costs one frame. For each
/// call: u32 handle, u32 size, the argument, and padding to 8; little-endian. In front of the body
/// is room for the header of the frame.
class CallBatch {
 public:
  /// The most bytes of a call in addition to its argument.
  static constexpr std::size_t kOverhead = 24;

  void Add(std::uint32_t handle, std::span<const std::byte> argument);
  /// Adds a call whose argument is followed by i64 `time`, in ns on our steady clock; `size`
  /// includes the time.
  void AddTimed(std::uint32_t handle, std::span<const std::byte> argument, SteadyTime time);
  void Clear();

  [[nodiscard]] bool empty() const { return calls_ == 0; }
  [[nodiscard]] std::size_t calls() const { return calls_; }
  [[nodiscard]] std::span<const std::byte> body() const {
    return std::span(frame_).subspan(empty() ? 0 : FrameHeader::kSize);
  }
  /// The body and the room for the header; empty without calls.
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

/// The same for calls with times, which are on the sender's steady clock: `visit(handle, argument,
/// time)`. Skips calls too short for a time.
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
