#include <tendon/proxy/call_batch.h>

#include <tendon/payload/cdr.h>

#include <array>
#include <bit>

namespace tendon {
namespace {

/// The place of the argument in the frame of a batch with only one call.
constexpr std::size_t kFirstArgument = FrameHeader::kSize + kCallHead;

using EncodedTime = std::array<std::byte, sizeof(std::int64_t)>;

EncodedTime EncodeTime(SteadyTime time) {
  const std::int64_t count = std::chrono::nanoseconds(time.time_since_epoch()).count();
  return std::bit_cast<EncodedTime>(count);
}

/// Returns the place of the argument.
std::byte* WriteCallHead(std::byte* place, std::uint32_t handle, std::size_t argument_size) {
  const auto size = static_cast<std::uint32_t>(argument_size);
  std::memcpy(place, &handle, sizeof handle);
  std::memcpy(place + sizeof handle, &size, sizeof size);
  return place + kCallHead;
}

}  // namespace

void CallBatch::Add(std::uint32_t handle, std::span<const std::byte> argument) {
  std::ranges::copy(argument, AddHead(handle, argument.size()));
}

void CallBatch::AddTimed(std::uint32_t handle, std::span<const std::byte> argument,
                         SteadyTime time) {
  const EncodedTime encoded = EncodeTime(time);
  std::byte* const place = AddHead(handle, argument.size() + encoded.size());
  std::ranges::copy(encoded, std::ranges::copy(argument, place).out);
}

std::byte* CallBatch::AddHead(std::uint32_t handle, std::size_t argument_size) {
  const std::size_t start = std::max(frame_.size(), FrameHeader::kSize);
  frame_.resize(start + kCallHead + payload::AlignUp(argument_size, 8));
  ++calls_;
  return WriteCallHead(frame_.data() + start, handle, argument_size);
}

void CallBatch::Clear() {
  constexpr std::size_t kKept = std::size_t{1} << 20U;
  if (frame_.capacity() > kKept) Bytes().swap(frame_);
  frame_.clear();
  calls_ = 0;
}

std::span<std::byte> CallBuffer::Resize(std::size_t size) {
  const std::size_t needed = kFirstArgument + payload::AlignUp(size + sizeof(EncodedTime), 8);
  if (bytes_.size() < needed) bytes_ = Bytes(needed);
  size_ = size;
  return std::span(bytes_).subspan(kFirstArgument, size);
}

std::span<const std::byte> CallBuffer::argument() const {
  return std::span(bytes_).subspan(kFirstArgument, size_);
}

std::span<std::byte> CallBuffer::TimedFrame(std::uint32_t handle, SteadyTime time) {
  return FrameWith(handle, EncodeTime(time));
}

std::span<std::byte> CallBuffer::FrameWith(std::uint32_t handle, std::span<const std::byte> time) {
  const std::size_t size = size_ + time.size();
  const auto frame = std::span(bytes_).first(kFirstArgument + payload::AlignUp(size, 8));
  std::byte* const argument = WriteCallHead(frame.data() + FrameHeader::kSize, handle, size);
  std::byte* const end = std::ranges::copy(time, argument + size_).out;
  std::fill(end, frame.data() + frame.size(), std::byte{0});
  return frame;
}

}  // namespace tendon
