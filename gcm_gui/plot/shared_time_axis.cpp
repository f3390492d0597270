#include <gcm_gui/plot/shared_time_axis.h>

#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/plot/series/time_shift.h>

#include <algorithm>

namespace tendon::gui {
namespace {

// Restores the ranges of the axes. Ignores the axes whose units no longer exist.
void TakeOver(std::vector<UnitAxis>& axes, const std::vector<UnitAxis>& former) {
  for (UnitAxis& axis : axes) {
    for (const UnitAxis& there : former) {
      if (there.unit != axis.unit) continue;
      axis.range = Moved(there.range, there.frame, axis.frame);
      axis.fitted = there.fitted || !IsShowable(axis.range);
    }
  }
}

}  // namespace

void SharedTimeAxis::join(CurveSet& curves) { sets_.push_back(&curves); }

void SharedTimeAxis::leave(CurveSet& curves) {
  std::erase(sets_, &curves);
  for (auto* states : {&former_, &later_}) {
    for (ViewState& state : *states) {
      std::erase_if(state.axes, [&](const auto& each) { return each.first == &curves; });
    }
  }
}

void SharedTimeAxis::fitAll() {
  for (CurveSet* set : sets_) set->fitAll();
}

std::int64_t SharedTimeAxis::now() const {
  // A recording is always complete up to the shown moment, so there is no delay to estimate.
  return IsMomentShown() ? ShownTime() : clock_.now(ShownTime());
}

bool SharedTimeAxis::setHover(std::optional<int> column) {
  if (column == hover_) return false;
  hover_ = column;
  return true;
}

std::optional<std::int64_t> SharedTimeAxis::shift(const QString& recording) const {
  const auto found = shifts_.find(recording);
  return found == shifts_.end() ? std::nullopt : std::optional(found->second);
}

bool SharedTimeAxis::isShown(const QString& recording) const {
  return std::any_of(sets_.begin(), sets_.end(), [&](const CurveSet* set) {
    const auto& curves = set->curves();
    return std::any_of(curves.begin(), curves.end(),
                       [&](const auto& curve) { return curve->recording() == recording; });
  });
}

void SharedTimeAxis::setShift(const QString& recording, std::int64_t shift_ns) {
  shifts_[recording] = std::clamp(shift_ns, -kLongestShift, kLongestShift);
}

SharedTimeAxis::ViewState SharedTimeAxis::present() const {
  ViewState state{.window = window_, .shifts = shifts_, .axes = {}};
  for (CurveSet* set : sets_) state.axes.emplace_back(set, set->axes());
  return state;
}

void SharedTimeAxis::remember(Gesture gesture) {
  const bool is_same_run = gesture != Gesture::kOnce && gesture == last_gesture_;
  last_gesture_ = gesture;
  if (is_same_run) return;
  later_.clear();
  former_.push_back(present());
  if (former_.size() > kMaxSteps) former_.erase(former_.begin());
}

void SharedTimeAxis::go(std::vector<ViewState>& from, std::vector<ViewState>& to) {
  if (from.empty()) return;
  to.push_back(present());
  const ViewState state = std::move(from.back());
  from.pop_back();
  window_ = state.window;
  // A recording that was added later is not moved.
  for (const auto& [recording, shift_ns] : state.shifts) shifts_[recording] = shift_ns;
  for (const auto& [set, axes] : state.axes) TakeOver(set->axes(), axes);
  endRun();
  touch();
}

}  // namespace tendon::gui
