#pragma once

#include <gcm_gui/plot/series/cursors.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/live_clock.h>
#include <gcm_gui/plot/series/time_window.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace tendon::gui {

/// What plots that lie below each other have in common: which time they show, the present of their
/// sources, the cursors, the column under the mouse, and the way back to what was shown before.
///
/// Who changes anything says so by touch(); who shows it compares revision(). GUI thread.
class TimeLink {
 public:
  /// Steps that are remembered.
  static constexpr std::size_t kMostSteps = 64;

  enum class Gesture {
    kOnce,      ///< a step of its own
    kZoomTime,  ///< these are one step until another gesture, or endRun(), comes between
    kZoomValues,
    kMove,
  };

  /// Its axes are part of what is remembered, until it leaves.
  void join(CurveSet& curves);
  void leave(CurveSet& curves);
  /// All axes follow the data.
  void fitAll();

  [[nodiscard]] TimeWindow& window() { return window_; }
  [[nodiscard]] Cursors& cursors() { return cursors_; }
  [[nodiscard]] LiveClock& clock() { return clock_; }
  [[nodiscard]] std::optional<int> hover() const { return hover_; }
  /// Returns whether it was elsewhere.
  bool setHover(std::optional<int> column);

  void touch() { ++revision_; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  /// To be called before `gesture` changes what is shown.
  void remember(Gesture gesture);
  void endRun() { last_gesture_ = Gesture::kOnce; }
  // Nothing happens at the end of the way.
  void goBack() { go(former_, later_); }
  void goForward() { go(later_, former_); }
  [[nodiscard]] bool hasFormer() const { return !former_.empty(); }
  [[nodiscard]] bool hasLater() const { return !later_.empty(); }

 private:
  struct Place {
    TimeWindow window;
    std::vector<std::pair<CurveSet*, std::vector<UnitAxis>>> axes;
  };

  [[nodiscard]] Place present() const;
  void go(std::vector<Place>& from, std::vector<Place>& to);

  TimeWindow window_;
  Cursors cursors_;
  LiveClock clock_;
  std::optional<int> hover_;
  std::vector<CurveSet*> sets_;
  std::vector<Place> former_;
  std::vector<Place> later_;
  Gesture last_gesture_ = Gesture::kOnce;
  std::uint64_t revision_ = 0;
};

}  // namespace tendon::gui
