#include <gcm_gui/plot/shared_time_axis.h>

#include <algorithm>

namespace tendon::gui {
namespace {

// Restores the axes. Ignores units that no longer exist.
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
  for (auto* places : {&former_, &later_}) {
    for (Place& place : *places) {
      std::erase_if(place.axes, [&](const auto& each) { return each.first == &curves; });
    }
  }
}

void SharedTimeAxis::fitAll() {
  for (CurveSet* set : sets_) {
    for (UnitAxis& axis : set->axes()) axis.fitted = true;
  }
}

bool SharedTimeAxis::setHover(std::optional<int> column) {
  if (column == hover_) return false;
  hover_ = column;
  return true;
}

SharedTimeAxis::Place SharedTimeAxis::present() const {
  Place place{.window = window_};
  for (CurveSet* set : sets_) place.axes.emplace_back(set, set->axes());
  return place;
}

void SharedTimeAxis::remember(Gesture gesture) {
  const bool is_same_run = gesture != Gesture::kOnce && gesture == last_gesture_;
  last_gesture_ = gesture;
  if (is_same_run) return;
  later_.clear();
  former_.push_back(present());
  if (former_.size() > kMostSteps) former_.erase(former_.begin());
}

void SharedTimeAxis::go(std::vector<Place>& from, std::vector<Place>& to) {
  if (from.empty()) return;
  to.push_back(present());
  const Place place = std::move(from.back());
  from.pop_back();
  window_ = place.window;
  for (const auto& [set, axes] : place.axes) TakeOver(set->axes(), axes);
  endRun();
  touch();
}

}  // namespace tendon::gui
