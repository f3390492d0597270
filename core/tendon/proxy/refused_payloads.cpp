#include <tendon/middleware/parts/payload_limit.h>
#include <tendon/proxy/refused_payloads.h>

#include <algorithm>

namespace tendon {
namespace {

/// Number of bits of a note for the size; the other bits are the handle.
constexpr unsigned kSizeBits = 40;
constexpr std::uint64_t kLargestSize = (std::uint64_t{1} << kSizeBits) - 1;
constexpr std::uint32_t kHandleMask = (std::uint32_t{1} << (64 - kSizeBits)) - 1;

}  // namespace

void RefusedPayloads::Add(std::uint32_t handle, std::string member) {
  members_[handle & kHandleMask] = std::move(member);
}

void RefusedPayloads::Note(std::uint32_t handle, std::size_t size) noexcept {
  const std::uint64_t noted_size = std::min<std::uint64_t>(size, kLargestSize);
  note_.Set(std::uint64_t{handle & kHandleMask} << kSizeBits | noted_size);
  notes_.Add();
}

void RefusedPayloads::Tell() {
  const std::uint64_t notes = notes_.value();
  if (notes == told_) return;
  told_ = notes;
  const std::uint64_t note = note_.Get();  // one of the counted notes, or a newer one
  const auto member = members_.find(static_cast<std::uint32_t>(note >> kSizeBits));
  if (member != members_.end()) Log(member->second, note & kLargestSize);
}

void RefusedPayloads::Log(const std::string& member, std::size_t size) {
  complaints_.Add(ExceedsMaxPayload("'" + member + "'", size, interface_).message);
}

}  // namespace tendon
