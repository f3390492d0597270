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

/// The number of bytes in front of the argument of a call: its handle and the size of its argument.
inline constexpr std::size_t kCallHead = 8;

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

/// A call that waits to be sent. Its memory is laid out like the frame of a batch with only this
/// call, so that the call can be sent without a copy.
class CallBuffer {
 public:
  /// Returns the memory for an argument of `size` bytes. Memory that must grow gets exactly the
  /// needed size, and its old content is not copied.
  std::span<std::byte> Resize(std::size_t size);
  /// The argument; may be called after Resize().
  [[nodiscard]] std::span<const std::byte> argument() const;
  /// Bytes of memory. Resize() never makes it smaller.
  [[nodiscard]] std::size_t capacity() const { return bytes_.size(); }

  /// Writes everything around the argument, except the header of the frame. Returns the frame that
  /// a batch with only this call would have. May be called again, like CallBatch::Add().
  [[nodiscard]] std::span<std::byte> Frame(std::uint32_t handle) { return FrameWith(handle, {}); }
  /// Does the same for a call with a time; see CallBatch::AddTimed().
  [[nodiscard]] std::span<std::byte> TimedFrame(std::uint32_t handle, SteadyTime time);

 private:
  [[nodiscard]] std::span<std::byte> FrameWith(std::uint32_t handle,
                                               std::span<const std::byte> time);

  std::size_t size_ = 0;  // of the argument
  Bytes bytes_;
};

/// Calls `visit(handle, argument)` for each call in `body`, which is untrusted. Stops at the first
/// incomplete call.
template <typename Visitor>
void ForEachCall(std::span<const std::byte> body, Visitor visit) {
  while (body.size() >= kCallHead) {
    std::uint32_t handle = 0;
    std::uint32_t size = 0;
    std::memcpy(&handle, body.data(), sizeof handle);
    std::memcpy(&size, body.data() + sizeof handle, sizeof size);
    body = body.subspan(kCallHead);
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
