#include <tendon/proxy/call_batch.h>

namespace tendon {

void CallBatch::Add(std::uint32_t handle, std::span<const std::byte> argument) {
  const auto size = static_cast<std::uint32_t>(argument.size());
  const std::size_t start = body_.size();
  body_.resize(start + sizeof handle + sizeof size + (argument.size() + 7) / 8 * 8);
  std::byte* place = body_.data() + start;
  std::memcpy(place, &handle, sizeof handle);
  std::memcpy(place + sizeof handle, &size, sizeof size);
  if (size > 0) std::memcpy(place + sizeof handle + sizeof size, argument.data(), size);
  ++calls_;
}

void CallBatch::Clear() {
  constexpr std::size_t kKept = std::size_t{1} << 20U;
  if (body_.capacity() > kKept) Bytes().swap(body_);
  body_.clear();
  calls_ = 0;
}

}  // namespace tendon
