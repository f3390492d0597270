#include <gcm_gui/plot/series/mark_track.h>

#include <algorithm>

namespace tendon::gui {
namespace {

bool IsBefore(const Mark& mark, std::int64_t time_ns) { return mark.time_ns < time_ns; }
bool IsBehind(std::int64_t time_ns, const Mark& mark) { return time_ns < mark.time_ns; }

}  // namespace

void MarkTrack::add(Mark mark) {
  const auto place = std::upper_bound(marks_.begin(), marks_.end(), mark.time_ns, IsBehind);
  marks_.insert(place, std::move(mark));
  if (marks_.size() > kMax) marks_.pop_front();
}

std::pair<MarkTrack::Iterator, MarkTrack::Iterator> MarkTrack::between(std::int64_t from_ns,
                                                                       std::int64_t to_ns) const {
  return {std::lower_bound(marks_.begin(), marks_.end(), from_ns, IsBefore),
          std::upper_bound(marks_.begin(), marks_.end(), to_ns, IsBehind)};
}

}  // namespace tendon::gui
