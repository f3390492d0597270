#include <tendon/proxy/call_batch.h>

namespace tendon {

void CallBatch::Add(std::uint32_t handle, std::span<const std::byte> argument) {
  std::byte* place = AddHead(handle, argument.size());
  if (!argument.empty()) std::memcpy(place, argument.data(), argument.size());
}

void CallBatch::AddTimed(std::uint32_t handle, std::span<const std::byte> argument,
                         SteadyTime time) {
  const std::int64_t count = std::chrono::nanoseconds(time.time_since_epoch()).count();
  std::byte* place = AddHead(handle, argument.size() + sizeof count);
  if (!argument.empty()) std::memcpy(place, argument.data(), argument.size());
  std::memcpy(place + argument.size(), &count, sizeof count);
}

std::byte* CallBatch::AddHead(std::uint32_t handle, std::size_t argument_size) {
  const auto size = static_cast<std::uint32_t>(argument_size);
  const std::size_t start = std::max(frame_.size(), FrameHeader::kSize);
  frame_.resize(start + sizeof handle + sizeof size + (argument_size + 7) / 8 * 8);
  std::byte* place = frame_.data() + start;
  std::memcpy(place, &handle, sizeof handle);
  std::memcpy(place + sizeof handle, &size, sizeof size);
  ++calls_;
  return place + sizeof handle + sizeof size;
}

void CallBatch::Clear() {
  constexpr std::size_t kKept = std::size_t{1} << 20U;
  if (frame_.capacity() > kKept) Bytes().swap(frame_);
  frame_.clear();
  calls_ = 0;
}

}  // namespace tendon
