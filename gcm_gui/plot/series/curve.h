#pragma once

#include <gcm_gui/plot/series/coarse_history.h>
#include <gcm_gui/plot/series/envelope.h>
#include <gcm_gui/plot/series/row_losses.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/scaling.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/value_names.h>

#include <QString>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace tendon::gui {

/// In a sweeping window, a time span belongs to the present pass or to the one before. Other
/// windows have only the present pass.
enum class Pass { kPresent, kFormer };

/// One signal in one plot: its samples, its look, and the state of its source. A curve of a
/// recording is shifted in time: its times are on the plot's clock. GUI thread.
class Curve {
 public:
  Curve(CurveKey key, int color_index);

  [[nodiscard]] const QString& path() const { return key_.path; }
  [[nodiscard]] const QString& unit() const { return key_.unit; }
  /// The file of the recording that the curve shows; empty if it shows the same system as the plot.
  [[nodiscard]] const QString& recording() const { return recording_; }
  [[nodiscard]] bool isRecorded() const { return !recording_.isEmpty(); }
  /// The index of the colour in Theme::curve().
  [[nodiscard]] int colorIndex() const { return color_index_; }
  void setColorIndex(int index) { color_index_ = index; }

  /// Sets the time that is added to the times of samples, including existing samples. O(samples).
  void setShift(std::int64_t shift_ns);
  [[nodiscard]] std::int64_t shift() const { return shift_ns_; }
  /// Sets the end of the recording, without the shift. The curve has no values after this time.
  void setRecordedEnd(std::int64_t time_ns) { recorded_end_ns_ = time_ns; }

  /// Appends samples. The curve then no longer counts as stale.
  void append(std::span<const Sample> samples);
  /// Removes all samples, and waits for new ones.
  void removeSamples();
  /// Called when the source was restarted; see SampleRing::beginEpoch().
  void beginEpoch() { samples_.beginEpoch(); }
  /// Sets the memory for samples in bytes. An eighth of it is used for the older part, which is
  /// kept as minimum and maximum of each 100 ms.
  void setBudget(std::size_t bytes);
  [[nodiscard]] std::size_t bytes() const { return samples_.bytes() + history_.bytes(); }
  /// Returns true if the oldest samples were dropped. This part of the curve is then shown by
  /// minima and maxima.
  [[nodiscard]] bool isThinned() const;
  [[nodiscard]] const SampleRing& samples() const { return samples_; }

  /// Called when no samples arrive; `reason` names the source for which the curve waits. A new
  /// curve is stale.
  void setStale(const QString& reason) { stale_reason_ = reason; }
  [[nodiscard]] bool isStale() const { return !stale_reason_.isEmpty(); }
  [[nodiscard]] const QString& staleReason() const { return stale_reason_; }

  /// Sets the reason why the source's component does not run; empty while it runs. The curve stays
  /// visible, but is marked as old.
  void setStandstill(const QString& why);
  [[nodiscard]] bool isStandingStill() const { return !standstill_.isEmpty(); }
  [[nodiscard]] const QString& standstill() const { return standstill_; }
  /// Returns true if the newest sample may differ from the present value.
  [[nodiscard]] bool isSilent() const { return isStale() || isStandingStill(); }

  /// Sets the losses of the source that occurred before the curve was added.
  void setLossesBefore(const RowLosses& losses) { losses_before_ = losses; }
  [[nodiscard]] const RowLosses& lossesBefore() const { return losses_before_; }

  /// Sets the look without updating the axes. If the curve is in a CurveSet, call
  /// CurveSet::setLook() instead.
  void setLook(const CurveLook& look);
  [[nodiscard]] const CurveLook& look() const { return look_; }
  [[nodiscard]] const Scaling& scaling() const { return look_.scaling; }
  /// Sets the names of the curve's values without updating the axes. If the curve is in a CurveSet,
  /// call CurveSet::setNames() instead.
  void setNames(ValueNamesPointer names) { names_ = std::move(names); }
  [[nodiscard]] const ValueNamesPointer& allNames() const { return names_; }
  /// Returns the names to show; null if there are none or if the curve is scaled.
  [[nodiscard]] const ValueNames* names() const {
    return look_.scaling.isNone() ? names_.get() : nullptr;
  }
  /// True if the shown values are integers, which are drawn as steps.
  [[nodiscard]] bool isWhole() const {
    return samples_.kind() != ExactNumber::Kind::kReal && look_.scaling.isNone();
  }
  /// Returns the unit including the scaling: "rad ×1000 +2".
  [[nodiscard]] QString shownUnit() const { return UnitOf(unit(), look_.scaling); }
  /// Returns the name of the axis: the axis that the user has chosen, otherwise the default axis,
  /// whose name is the unit or, for named values, their type.
  [[nodiscard]] QString axis() const {
    if (!look_.axis.isEmpty()) return look_.axis;
    return names() != nullptr ? names()->type : shownUnit();
  }
  /// Sets the base of the curve's axis. Distances are relative to this base.
  void setBase(double base);

  void setVisible(bool visible) { visible_ = visible; }
  [[nodiscard]] bool isVisible() const { return visible_; }

  // The following functions return scaled values. Unscaled integers keep all digits.
  /// Returns the value of the last sample at or before `time_ns`; empty if there is a gap in
  /// between.
  [[nodiscard]] std::optional<ExactNumber> numberAt(std::int64_t time_ns) const;
  [[nodiscard]] std::optional<ExactNumber> latestNumber() const;
  /// Returns the distance of a scaled sample from the base.
  [[nodiscard]] double distanceOf(std::uint64_t index) const;
  /// Returns the rate of received rows in the last second of source time; 0 if there are fewer than
  /// two rows.
  [[nodiscard]] double rate() const;
  /// Returns the scaled curve in these slices, as distances from the base. The result is cached for
  /// each pass until the slices change or new samples arrive.
  [[nodiscard]] const Envelope& envelope(const TimeSlices& slices,
                                         Pass pass = Pass::kPresent) const;

 private:
  struct DrawnEnvelope {
    Envelope envelope;
    Envelope scaled;  // only if the curve is scaled
    TimeSlices slices;
    std::uint64_t end = 0;  // end index of the samples when this was built
  };

  void showHistory(Envelope& envelope, const TimeSlices& slices, double base) const;
  [[nodiscard]] ExactNumber shown(std::uint64_t index) const;

  CurveKey key_;
  QString recording_;
  std::int64_t shift_ns_ = 0;
  std::int64_t recorded_end_ns_ = std::numeric_limits<std::int64_t>::max();
  int color_index_;
  CurveLook look_;
  ValueNamesPointer names_;
  double base_ = 0;
  bool visible_ = true;
  QString stale_reason_;
  QString standstill_;
  RowLosses losses_before_;
  SampleRing samples_;
  CoarseHistory history_;                       // without the shift
  mutable std::array<DrawnEnvelope, 2> drawn_;  // by pass
};

/// Returns the text for a curve without samples: "waiting for robot/arm/state"; for a curve of a
/// recording, a text that there are no samples in the visible time.
[[nodiscard]] QString WaitingFor(const QString& path);

}  // namespace tendon::gui
