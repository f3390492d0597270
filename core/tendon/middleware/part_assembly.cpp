#include <tendon/middleware/part_assembly.h>

#include <tendon/middleware/part_sender.h>
#include <tendon/middleware/payload_limit.h>

#include <algorithm>
#include <new>
#include <utility>

namespace tendon {
namespace {

constexpr std::size_t kMaxWholeSize = kMaxBodySize + FrameHeader::kSize;

/// Returns true if a message of this type may be sent in parts.
bool MayBeLarge(MessageType type) {
  switch (type) {
    case MessageType::kHello:
    case MessageType::kWelcome:
    case MessageType::kChallenge:
    case MessageType::kProof:
    case MessageType::kPart:
    case MessageType::kPartsTaken:
    case MessageType::kReplies:
      return false;
    default:
      return true;
  }
}

/// Returns true for replies and refusals. The budget does not count them, because this end has
/// requested them.
bool IsReply(MessageType type) {
  return type == MessageType::kReply || type == MessageType::kRefusal;
}

/// Reserves memory for `more` bytes of a body that will have `size` bytes. Reserves more than
/// needed, so that the body is seldom copied. The limit is 1 MiB or eight times the bytes that have
/// arrived, because the peer has only announced `size`.
void MakeRoom(Bytes& body, std::size_t more, std::size_t size) {
  constexpr std::size_t kAtFirst = std::size_t{1} << 20U;
  const std::size_t needed = body.size() + more;
  if (body.capacity() >= needed) return;
  body.reserve(std::min(size, std::max(kAtFirst, 8 * needed)));
}

}  // namespace

Budget<>& PartAssembly::BudgetOfProcess() {
  constexpr std::size_t kMax = std::size_t{512} << 20U;
  static auto& budget = *new Budget<>(kMax);  // never destroyed, because threads may still use it
  return budget;
}

PartAssembly::Progress PartAssembly::Add(std::uint32_t number, std::span<const std::byte> part,
                                         Frame& frame) {
  auto found = unfinished_.find(number);
  const bool is_first = found == unfinished_.end();
  if (is_first) found = Begin(number, part);
  if (found == unfinished_.end()) return Progress::kMalformed;
  UnfinishedFrame& unfinished = found->second;
  const std::size_t left = unfinished.header.size - unfinished.come;
  const auto more = is_first ? part.subspan(FrameHeader::kSize) : part;
  const std::size_t least = std::min(kMinPartSize - (part.size() - more.size()), left);
  // Only the last part may be smaller than `least`. This limits the work per byte.
  if (more.size() > left || more.size() < least) return Progress::kMalformed;
  taken_ += part.size();
  unfinished.last_part = clock_.Now();
  const bool is_last = more.size() == left;
  if (is_first && !is_last && is_wanted_) unfinished.is_wanted = is_wanted_(unfinished.header);
  const Progress progress =
      unfinished.is_wanted ? Keep(unfinished, more, is_last) : Progress::kMoreToCome;
  unfinished.come += more.size();
  if (progress != Progress::kMoreToCome) frame = {unfinished.header, std::move(unfinished.body)};
  if (!is_last) return progress;
  const std::size_t size = FrameHeader::kSize + unfinished.header.size;
  ClaimsFor(size) -= size;
  unfinished_.erase(found);
  return progress;
}

PartAssembly::Progress PartAssembly::Keep(UnfinishedFrame& unfinished,
                                          std::span<const std::byte> more, bool is_last) {
  if (is_last) {
    ReleaseBudget(unfinished);
  } else if (!IsReply(unfinished.header.type)) {
    if (!budget_.Take(more.size())) {
      ReleaseBudget(unfinished);
      Bytes().swap(unfinished.body);
      unfinished.is_wanted = false;
      return Progress::kTooMuch;
    }
    unfinished.kept += more.size();
    kept_ += more.size();
  }
  try {
    MakeRoom(unfinished.body, more.size(), unfinished.header.size);
  } catch (const std::bad_alloc&) {
    return Progress::kOutOfMemory;
  }
  unfinished.body.insert(unfinished.body.end(), more.begin(), more.end());
  return is_last ? Progress::kWhole : Progress::kMoreToCome;
}

void PartAssembly::ReleaseBudget(UnfinishedFrame& unfinished) {
  budget_.Give(unfinished.kept);
  kept_ -= std::exchange(unfinished.kept, 0);
}

/// Returns the counter for a frame of this size. There are two counters, because a PartSender has
/// at most one huge frame in progress, and kSendWindow bytes of other frames.
std::size_t& PartAssembly::ClaimsFor(std::size_t size) {
  return size > kSendWindow ? claimed_.of_huge : claimed_.of_others;
}

/// Begins a frame with its first part. Returns end() if the peer may not send this frame.
PartAssembly::Frames::iterator PartAssembly::Begin(std::uint32_t number,
                                                   std::span<const std::byte> part) {
  const auto header = ReadFrameHeader(part, kMaxWholeSize);
  if (!header || !MayBeLarge(header->type)) return unfinished_.end();
  const std::size_t size = FrameHeader::kSize + header->size;
  std::size_t& claimed = ClaimsFor(size);
  if (claimed != 0 && claimed + size > kSendWindow) return unfinished_.end();
  const auto unfinished =
      unfinished_.emplace(number, UnfinishedFrame{.header = *header, .body = {}}).first;
  claimed += size;
  return unfinished;
}

SteadyTime PartAssembly::given_up() const {
  if (unfinished_.empty()) return SteadyTime::max();
  const auto oldest = std::ranges::min_element(
      unfinished_, {}, [](const auto& one) { return one.second.last_part; });
  return oldest->second.last_part + kPartTimeout + unfinished_.size() * PartSender::kPartTime;
}

void PartAssembly::Clear() {
  unfinished_.clear();
  claimed_ = {};
  budget_.Give(std::exchange(kept_, 0));
}

}  // namespace tendon
