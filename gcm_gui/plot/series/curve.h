#pragma once

#include <gcm_gui/plot/series/coarse_history.h>
#include <gcm_gui/plot/series/envelope.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/scaling.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/value_names.h>

#include <QString>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace tendon::gui {

/// The pass of a sweeping window to which a time span belongs. Other windows have only the present
/// pass.
enum class Pass { kPresent, kFormer };

/// One signal in one plot: its samples, its look, and the state of its source. GUI thread.
class Curve {
 public:
  Curve(CurveKey key, int color_index);

  [[nodiscard]] const QString& path() const { return key_.path; }
  [[nodiscard]] const QString& unit() const { return key_.unit; }
  /// The index for Theme::curve().
  [[nodiscard]] int colorIndex() const { return color_index_; }
  void setColorIndex(int index) { color_index_ = index; }

  /// Appends samples; the curve is not stale any more.
  void append(std::span<const Sample> samples);
  /// See SampleRing::beginEpoch().
  void beginEpoch() { samples_.beginEpoch(); }
  /// The memory for samples in bytes. An eighth of it is for the older part, which is kept as
  /// minimum and maximum of each 100 ms.
  void setBudget(std::size_t bytes);
  [[nodiscard]] std::size_t bytes() const { return samples_.bytes() + history_.bytes(); }
  /// True if the oldest visible part no longer has samples.
  [[nodiscard]] bool isThinned() const;
  [[nodiscard]] const SampleRing& samples() const { return samples_; }

  /// Called when no samples come; `reason` says for what the curve waits. A new curve is stale.
  void setStale(const QString& reason) { stale_reason_ = reason; }
  [[nodiscard]] bool isStale() const { return !stale_reason_.isEmpty(); }
  [[nodiscard]] const QString& staleReason() const { return stale_reason_; }

  /// Sets the reason why the source's component does not run; empty while it runs. The curve
  /// remains visible, marked as old.
  void setStandstill(const QString& why);
  [[nodiscard]] bool isStandingStill() const { return !standstill_.isEmpty(); }
  [[nodiscard]] const QString& standstill() const { return standstill_; }
  /// True if the newest sample may not be the present value.
  [[nodiscard]] bool isSilent() const { return isStale() || isStandingStill(); }

  /// Sets the losses of the source before the curve was added.
  void setLossesBefore(const RowLosses& losses) { losses_before_ = losses; }
  [[nodiscard]] const RowLosses& lossesBefore() const { return losses_before_; }

  /// Does not update the axes: use CurveSet::setLook().
  void setLook(const CurveLook& look);
  [[nodiscard]] const CurveLook& look() const { return look_; }
  [[nodiscard]] const Scaling& scaling() const { return look_.scaling; }
  /// The names of its values, if any. Does not update the axes: use CurveSet::setNames().
  void setNames(ValueNamesPointer names) { names_ = std::move(names); }
  [[nodiscard]] const ValueNamesPointer& allNames() const { return names_; }
  /// The names to show; null if there are none or the curve is scaled.
  [[nodiscard]] const ValueNames* names() const {
    return look_.scaling.isNone() ? names_.get() : nullptr;
  }
  /// True if the shown values are integers, which are drawn as steps.
  [[nodiscard]] bool isWhole() const {
    return samples_.kind() != ExactNumber::Kind::kReal && look_.scaling.isNone();
  }
  /// The unit with the scaling: "rad ×1000 +2".
  [[nodiscard]] QString shownUnit() const { return UnitOf(unit(), look_.scaling); }
  /// The name of the chosen axis; otherwise of the default one: the unit, or the type of named
  /// values.
  [[nodiscard]] QString axis() const {
    if (!look_.axis.isEmpty()) return look_.axis;
    return names() != nullptr ? names()->type : shownUnit();
  }
  /// Sets the base of its axis, to which distances are relative.
  void setBase(double base);

  void setVisible(bool visible) { visible_ = visible; }
  [[nodiscard]] bool isVisible() const { return visible_; }

  // Scaled values.
  /// The value of the last sample at or before `time_ns`; empty if there is a gap in between.
  [[nodiscard]] std::optional<double> valueAt(std::int64_t time_ns) const;
  [[nodiscard]] std::optional<double> latestValue() const;
  // The same as exact numbers: unscaled integers keep all digits.
  [[nodiscard]] std::optional<ExactNumber> numberAt(std::int64_t time_ns) const;
  [[nodiscard]] std::optional<ExactNumber> latestNumber() const;
  /// The distance of a scaled sample from the base.
  [[nodiscard]] double distanceOf(std::uint64_t index) const;
  /// The rate of received rows over the latest second of source time; 0 with less than two rows.
  [[nodiscard]] double rate() const;
  /// The scaled curve in these slices, as distances from the base. Cached for each pass until the
  /// slices change or new samples arrive.
  [[nodiscard]] const Envelope& envelope(const TimeSlices& slices,
                                         Pass pass = Pass::kPresent) const;

 private:
  struct DrawnEnvelope {
    Envelope envelope;
    Envelope scaled;  // if the curve is scaled
    TimeSlices slices;
    std::uint64_t end = 0;  // end index of the samples
  };

  void showHistory(Envelope& envelope, const TimeSlices& slices, double base) const;
  [[nodiscard]] ExactNumber shown(std::uint64_t index) const;

  CurveKey key_;
  int color_index_;
  CurveLook look_;
  ValueNamesPointer names_;
  double base_ = 0;
  bool visible_ = true;
  QString stale_reason_;
  QString standstill_;
  RowLosses losses_before_;
  SampleRing samples_;
  CoarseHistory history_;
  mutable std::array<DrawnEnvelope, 2> drawn_;  // by pass
};

/// "waiting for robot/arm/state"
[[nodiscard]] QString WaitingFor(const QString& path);

}  // namespace tendon::gui
