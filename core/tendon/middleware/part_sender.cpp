#include <tendon/middleware/part_sender.h>

#include <algorithm>

namespace tendon {

void PartSender::Frame::Write(const FrameHeader& header, std::span<const std::byte> body) {
  bytes.resize(2 * FrameHeader::kSize);
  WriteHeader(header, std::span(bytes).last<FrameHeader::kSize>());
  bytes.insert(bytes.end(), body.begin(), body.end());
}

bool PartSender::MustSendInParts(Lane lane, std::size_t size) {
  if (size > FrameHeader::kSize + part_size()) return true;
  if (!is_busy_.Get()) return false;
  const std::scoped_lock lock(mutex_);
  return lanes_.contains(lane);
}

Status PartSender::Add(Link& link, Lane lane, const FrameHeader& header,
                       std::span<const std::byte> body) {
  const std::size_t size = FrameHeader::kSize + body.size();
  Frame frame;
  frame.bytes.reserve(FrameHeader::kSize + size);  // first, because it may throw
  if (const Status reserved = Reserve(size); !reserved) return reserved;
  frame.Write(header, body);  // without the lock, because it may be large
  const std::scoped_lock lock(mutex_);
  if (is_closed_) return Status::kNotConnected;
  frame.number = ++last_number_;
  // NewLane() numbers lanes upwards from 1. Lanes for single messages are numbered downwards from
  // the largest number.
  if (lane == kOwnLane) lane = kOwnLane - frame.number;
  Enter(lane, std::move(frame));
  is_busy_.Set(true);
  SendParts(link);
  return Status::kQueued;
}

Status PartSender::Reserve(std::size_t size) {
  const std::scoped_lock lock(mutex_);
  if (is_closed_) return Status::kNotConnected;
  std::size_t& waiting = IsHuge(size) ? huge_waiting_ : waiting_;
  if (waiting != 0 && waiting + size > kSendWindow) return Status::kQueueFull;
  waiting += size;
  return Status::kQueued;
}

/// Adds the frame to its lane. If there is not enough memory, releases the reserved bytes and
/// throws.
void PartSender::Enter(Lane lane, Frame frame) {
  const std::size_t size = frame.size();
  try {
    lanes_[lane].push_back(std::move(frame));
  } catch (...) {
    Release(size);
    std::erase_if(lanes_, [](const auto& one) { return one.second.empty(); });
    throw;
  }
}

void PartSender::Release(std::size_t size) { (IsHuge(size) ? huge_waiting_ : waiting_) -= size; }

bool PartSender::OnTaken(Link& link, std::uint64_t bytes) {
  const std::scoped_lock lock(mutex_);
  if (bytes < taken_ || bytes > sent_) return false;
  taken_ = bytes;
  for (; !on_way_.empty() && on_way_.front().end <= taken_; on_way_.pop_front()) {
    Release(on_way_.front().size);
  }
  UpdatePartSize();
  SendParts(link);
  return true;
}

/// Adapts the part size to the measured speed. A measurement that is not finished yet can only make
/// the parts smaller.
void PartSender::UpdatePartSize() {
  if (!probe_) return;
  using Seconds = std::chrono::duration<double>;
  const Seconds took =
      std::max<Seconds>(clock_.Now() - probe_->since, std::chrono::microseconds(1));
  const double fitting = static_cast<double>(probe_->bytes) * (Seconds(kPartTime) / took);
  const bool is_through = taken_ >= probe_->end;
  const std::size_t most = is_through ? kPartSize : part_size();
  const auto least = static_cast<double>(kMinPartSize);
  part_size_.Set(static_cast<std::size_t>(std::clamp(fitting, least, static_cast<double>(most))));
  if (fitting < static_cast<double>(kMaxReturned)) {
    quick_until_.Set({});
  } else if (is_through) {
    quick_until_.Set(clock_.Now() + kQuickFor);
  }
  if (is_through) probe_.reset();
}

void PartSender::Resume(Link& link) {
  if (!is_busy_.Get()) return;
  const std::scoped_lock lock(mutex_);
  SendParts(link);
}

/// Sends one part of each lane in turn.
void PartSender::SendParts(Link& link) {
  const std::size_t ahead = kPartsAhead * (FrameHeader::kSize + part_size());
  while (!lanes_.empty() && sent_ - taken_ < ahead) {
    auto lane = lanes_.upper_bound(last_lane_);
    if (lane == lanes_.end()) lane = lanes_.begin();
    Frame& frame = lane->second.front();
    if (!SendPart(link, frame)) return;
    last_lane_ = lane->first;
    if (frame.sent < frame.size()) continue;
    on_way_.push_back({.end = sent_, .size = frame.size()});
    lane->second.pop_front();
    if (lane->second.empty()) lanes_.erase(lane);
  }
  if (lanes_.empty()) is_busy_.Set(false);
}

Status PartSender::SendPart(Link& link, Frame& frame) {
  const std::size_t size = std::min(part_size(), frame.size() - frame.sent);
  FrameHeader header;
  header.type = MessageType::kPart;
  header.size = static_cast<std::uint32_t>(size);
  header.handle = frame.number;
  const auto part = std::span(frame.bytes).subspan(frame.sent, FrameHeader::kSize + size);
  WriteHeader(header, part.first<FrameHeader::kSize>());
  const Status sent = link.Send(part);
  if (!sent) return sent;
  frame.sent += size;
  sent_ += size;
  if (!probe_) {
    probe_ = Probe{.end = sent_, .bytes = sent_ - taken_, .since = clock_.Now()};
  }
  return sent;
}

void PartSender::Close() {
  const std::scoped_lock lock(mutex_);
  is_closed_ = true;
  is_busy_.Set(false);
  lanes_.clear();
  on_way_.clear();
  waiting_ = huge_waiting_ = 0;
}

std::size_t PartSender::waiting() const {
  const std::scoped_lock lock(mutex_);
  return waiting_ + huge_waiting_;
}

}  // namespace tendon
