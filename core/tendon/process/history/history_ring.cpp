#include <tendon/process/history/history_ring.h>

#include <tendon/payload/codec.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

namespace tendon {
namespace {

/// Precedes the body of each record.
struct StoredHead {
  std::int64_t time = 0;
  std::uint32_t size = 0;
  std::uint32_t tag = 0;
};

}  // namespace

bool HistoryMemory::Reserve(std::size_t bytes) {
  if (bytes > limit_ / 4 - std::min(reserved_, limit_ / 4) || !Take(nullptr, bytes)) return false;
  reserved_ += bytes;
  return true;
}

void HistoryMemory::Release(std::size_t bytes) {
  reserved_ -= bytes;
  used_ -= bytes;
}

bool HistoryMemory::Take(HistoryRing* ring, std::size_t bytes) {
  if (bytes > limit_) return false;
  while (used_ > limit_ - bytes) {
    HistoryRing* largest = ring;
    std::size_t most = ring == nullptr ? 0 : ring->bytes() + bytes;
    for (HistoryRing* one : rings_) {
      if (one == ring || one->bytes() <= most) continue;
      most = one->bytes();
      largest = one;
    }
    if (largest == nullptr || !largest->DropOldest()) return false;
  }
  used_ += bytes;
  return true;
}

HistoryRing::HistoryRing(HistoryMemory& memory, std::chrono::nanoseconds span)
    : memory_(memory), span_(span) {
  memory_.rings_.push_back(this);
}

HistoryRing::~HistoryRing() {
  memory_.used_ -= bytes_;
  std::erase(memory_.rings_, this);
}

bool HistoryRing::Append(const HistoryRecord& record) {
  const std::size_t needed = sizeof(StoredHead) + payload::AlignUp(record.body.size(), 8);
  const auto fits = [&] {
    if (chunks_.empty()) return false;
    const Chunk& last = chunks_.back();
    return record.number == last.first + last.count && needed <= last.capacity - last.used;
  };
  if (!fits() && !AddChunk(record, needed)) {
    CountDropped(record.time);
    return false;
  }
  Chunk& chunk = chunks_.back();
  std::byte* const place = chunk.bytes.get() + chunk.used;
  const StoredHead head{record.time, static_cast<std::uint32_t>(record.body.size()), record.tag};
  std::memcpy(place, &head, sizeof head);
  std::ranges::copy(record.body, place + sizeof head);
  chunk.used += needed;
  ++chunk.count;
  chunk.last_time = record.time;
  return true;
}

void HistoryRing::CountDropped(std::int64_t time) {
  ++dropped_;
  last_dropped_ = time;
}

bool HistoryRing::AddChunk(const HistoryRecord& record, std::size_t needed) {
  const std::size_t size = ChunkSizeFor(needed);
  if (!memory_.Take(this, size + sizeof(Chunk))) return false;
  try {
    chunks_.push_back({.bytes = std::make_unique_for_overwrite<std::byte[]>(size),
                       .capacity = size,
                       .first = record.number,
                       .first_time = record.time,
                       .last_time = record.time});
  } catch (const std::bad_alloc&) {
    memory_.used_ -= size + sizeof(Chunk);
    return false;
  }
  bytes_ += size + sizeof(Chunk);
  return true;
}

/// Chunks grow until about 16 of them hold the whole span, but 8 of them always fit into the share
/// of the ring. A series with missing numbers has smaller chunks, because a missing number begins a
/// new chunk. A large record has a separate chunk, so that no memory is left unused at its end.
std::size_t HistoryRing::ChunkSizeFor(std::size_t needed) {
  if (needed > kLargestChunk / 8) return needed;
  if (!chunks_.empty()) {
    const Chunk& last = chunks_.back();
    const bool is_full = last.capacity - last.used < needed;
    const std::chrono::nanoseconds time(last.last_time - last.first_time);
    if (is_full && time < span_ / 16) next_size_ *= 2;
    if (!is_full || time > span_ / 4) next_size_ /= 2;
  }
  const std::size_t largest = std::clamp(memory_.UsefulChunk(), kSmallestChunk, kLargestChunk);
  next_size_ = std::clamp(next_size_, kSmallestChunk, largest);
  return std::max(next_size_, needed);
}

bool HistoryRing::DropOldest() {
  if (chunks_.empty()) return false;
  dropped_ += chunks_.front().count;
  last_dropped_ = std::max(last_dropped_.value_or(INT64_MIN), chunks_.front().last_time);
  RemoveFront();
  return true;
}

void HistoryRing::DropBefore(std::int64_t time) {
  while (!chunks_.empty() && chunks_.front().last_time < time) RemoveFront();
}

void HistoryRing::RemoveFront() {
  const std::size_t size = chunks_.front().capacity + sizeof(Chunk);
  bytes_ -= size;
  memory_.used_ -= size;
  chunks_.pop_front();
}

HistoryRing::Cursor HistoryRing::From(std::uint64_t number) const {
  const auto chunk = std::ranges::partition_point(
      chunks_, [&](const Chunk& one) { return one.first + one.count <= number; });
  Cursor cursor(*this, static_cast<std::size_t>(chunk - chunks_.begin()));
  Cursor next = cursor;
  while (const auto record = next.Next()) {
    if (record->number >= number) break;
    cursor = next;
  }
  return cursor;
}

HistoryRing::Cursor HistoryRing::Since(std::int64_t time) const {
  const auto chunk =
      std::ranges::partition_point(chunks_, [&](const Chunk& one) { return one.last_time < time; });
  Cursor cursor(*this, static_cast<std::size_t>(chunk - chunks_.begin()));
  Cursor next = cursor;
  while (const auto record = next.Next()) {
    if (record->time >= time) break;
    cursor = next;
  }
  return cursor;
}

std::optional<HistoryRecord> HistoryRing::Cursor::Next() {
  if (chunk_ < ring_->chunks_.size() && record_ == ring_->chunks_[chunk_].count) {
    ++chunk_;
    position_ = 0;
    record_ = 0;
  }
  if (chunk_ == ring_->chunks_.size()) return std::nullopt;
  const Chunk& chunk = ring_->chunks_[chunk_];
  const std::byte* const place = chunk.bytes.get() + position_;
  StoredHead head;
  std::memcpy(&head, place, sizeof head);
  HistoryRecord record{.number = chunk.first + record_,
                       .time = head.time,
                       .tag = head.tag,
                       .body = {place + sizeof head, head.size}};
  position_ += sizeof head + payload::AlignUp(head.size, 8);
  ++record_;
  return record;
}

}  // namespace tendon
