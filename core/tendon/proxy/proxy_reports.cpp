#include <tendon/proxy/proxy_reports.h>

#include <tendon/middleware/payload_limit.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace tendon {
namespace {

/// The number of bits for the size in a note. The other bits are for the handle.
constexpr unsigned kSizeBits = 40;
constexpr std::uint64_t kLargestSize = (std::uint64_t{1} << kSizeBits) - 1;
constexpr std::uint32_t kHandleMask = (std::uint32_t{1} << (64 - kSizeBits)) - 1;

}  // namespace

void LossReport::Set(std::size_t handler, std::uint64_t lost) {
  if (handler >= lost_.size()) {
    lost_.resize(handler + 1);
    reported_.lost.resize(handler + 1);
  }
  lost_[handler] = lost;
}

void LossReport::Report(SteadyTime now, SteadyTime& next) {
  constexpr std::chrono::milliseconds kBetweenReports(20);
  if (lost_ == reported_.lost) return;
  if (now >= earliest_) {
    earliest_ = now + kBetweenReports;
    message::EventsLost report = reported_;
    for (std::size_t i = 0; i < lost_.size(); ++i) {
      report.lost[i] += std::min(lost_[i] - reported_.lost[i], message::EventsLost::kMaxAtOnce);
    }
    const Status sent = channel_->Notify(message::kEventsLost, handle_, report);
    if (sent != Status(Status::kQueueFull)) reported_ = std::move(report);
  }
  if (lost_ != reported_.lost) next = std::min(next, earliest_);
}

void RefusedPayloads::Add(std::uint32_t handle, std::string member) {
  members_[handle & kHandleMask] = std::move(member);
}

void RefusedPayloads::Note(std::uint32_t handle, std::size_t size) noexcept {
  const std::uint64_t noted_size = std::min<std::uint64_t>(size, kLargestSize);
  note_.Set(std::uint64_t{handle & kHandleMask} << kSizeBits | noted_size);
  notes_.Add();
}

void RefusedPayloads::Report() {
  const std::uint64_t notes = notes_.value();
  if (notes == reported_) return;
  reported_ = notes;
  const std::uint64_t note = note_.Get();  // the last counted note, or a newer note
  const auto member = members_.find(static_cast<std::uint32_t>(note >> kSizeBits));
  if (member != members_.end()) Log(member->second, note & kLargestSize);
}

void RefusedPayloads::Log(const std::string& member, std::size_t size) {
  warnings_.Add(ExceedsMaxPayload("'" + member + "'", size, interface_).message);
}

}  // namespace tendon
