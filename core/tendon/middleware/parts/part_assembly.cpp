#include <tendon/middleware/complaints.h>
#include <tendon/middleware/parts/part_assembly.h>
#include <tendon/middleware/parts/part_sender.h>
#include <tendon/middleware/parts/payload_limit.h>

#include <algorithm>
#include <new>
#include <string>
#include <utility>

namespace tendon {
namespace {

constexpr std::size_t kMaxWholeSize = kMaxBodySize + FrameHeader::kSize;
/// What one sender lets on its way: one huge frame, and a window of others.
constexpr std::size_t kMaxClaimed = kMaxWholeSize + kSendWindow;

/// A message about parts does not come in parts.
bool IsOfParts(MessageType type) {
  return type == MessageType::kPart || type == MessageType::kPartsTaken;
}

}  // namespace

PartAssembly::Progress PartAssembly::Add(std::uint32_t number, std::span<const std::byte> part,
                                         Frame& frame) {
  const auto found = begun_.find(number);
  const bool is_first = found == begun_.end();
  Frame* const begun = is_first ? Begin(number, part) : &found->second;
  if (begun == nullptr) return Progress::kNonsense;
  const std::size_t left = begun->header.size - begun->body.size();
  const auto more = is_first ? part.subspan(FrameHeader::kSize) : part;
  const std::size_t least = std::min(kLeastPartSize - (part.size() - more.size()), left);
  // None but the last is smaller than the least, so that nobody has us work for next to nothing.
  if (more.size() > left || more.size() < least) return Progress::kNonsense;
  taken_ += part.size();
  begun->body.insert(begun->body.end(), more.begin(), more.end());
  if (more.size() < left) return Progress::kMoreToCome;
  claimed_ -= FrameHeader::kSize + begun->header.size;
  frame = std::move(*begun);
  begun_.erase(number);
  return Progress::kWhole;
}

/// The frame of that number, which begins with this part; null where it cannot.
PartAssembly::Frame* PartAssembly::Begin(std::uint32_t number, std::span<const std::byte> part) {
  const auto header = ReadFrameHeader(part, kMaxWholeSize);
  if (!header || IsOfParts(header->type)) return nullptr;
  const std::size_t size = FrameHeader::kSize + header->size;
  if (size > kMaxClaimed - claimed_) return nullptr;
  Frame begun{.header = *header, .body = {}};
  try {
    begun.body.reserve(header->size);
  } catch (const std::bad_alloc&) {  // this message is lost, with its link; all others are not
    static Complaints complaints("channel");
    complaints.Add("out of memory (ulimit -v): a message of " + std::to_string(size) +
                   " bytes is refused");
    return nullptr;
  }
  claimed_ += size;
  return &(begun_[number] = std::move(begun));
}

void PartAssembly::Clear() {
  begun_.clear();
  claimed_ = 0;
}

}  // namespace tendon
