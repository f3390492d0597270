#include <tendon/middleware/parts/part_assembly.h>
#include <tendon/middleware/parts/part_sender.h>
#include <tendon/middleware/parts/payload_limit.h>

#include <algorithm>

namespace tendon {
namespace {

constexpr std::size_t kMaxWholeSize = kMaxBodySize + FrameHeader::kSize;
/// What one sender lets on its way: one huge frame, and a window of others.
constexpr std::size_t kMaxClaimed = kMaxWholeSize + kSendWindow;

}  // namespace

PartAssembly::Progress PartAssembly::Add(std::uint32_t number, std::span<const std::byte> part,
                                         Bytes& frame) {
  Begun* begun = Find(number, part);
  // Every part but the last is full, so that many small ones cost no memory beyond what they claim.
  if (begun == nullptr || part.size() != std::min(kPartSize, begun->size - begun->bytes.size())) {
    return Progress::kNonsense;
  }
  taken_ += part.size();
  begun->bytes.insert(begun->bytes.end(), part.begin(), part.end());
  if (begun->bytes.size() < begun->size) return Progress::kMoreToCome;
  claimed_ -= begun->size;
  frame = std::move(begun->bytes);
  begun_.erase(number);
  return Progress::kWhole;
}

/// The frame of that number, which may begin with this part; null where it cannot.
PartAssembly::Begun* PartAssembly::Find(std::uint32_t number, std::span<const std::byte> part) {
  const auto found = begun_.find(number);
  if (found != begun_.end()) return &found->second;
  const auto header = ReadFrameHeader(part, kMaxWholeSize);
  if (!header) return nullptr;
  const std::size_t size = FrameHeader::kSize + header->size;
  if (size > kMaxClaimed - claimed_) return nullptr;
  Begun& begun = begun_[number];
  begun.size = size;
  begun.bytes.reserve(size);
  claimed_ += size;
  return &begun;
}

void PartAssembly::Clear() {
  begun_.clear();
  claimed_ = 0;
}

}  // namespace tendon
