#pragma once

#include <gcm_gui/plot/history/coarse_history.h>
#include <gcm_gui/plot/row_losses.h>
#include <gcm_gui/plot/scaling/scaling.h>
#include <gcm_gui/plot/series/envelope.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/value_names.h>

#include <QString>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace tendon::gui {

/// Which pass of a sweeping window a part of time belongs to; any other window has only the
/// present.
enum class Pass { kPresent, kFormer };

/// One signal in one plot: its samples, its colour, and whether its source is heard of. GUI thread.
class Curve {
 public:
  Curve(CurveKey key, int color_index);

  [[nodiscard]] const QString& path() const { return key_.path; }
  [[nodiscard]] const QString& unit() const { return key_.unit; }
  /// For Theme::curve().
  [[nodiscard]] int colorIndex() const { return color_index_; }
  void setColorIndex(int index) { color_index_ = index; }

  /// Ends staleness.
  void append(std::span<const Sample> samples);
  /// See SampleRing::beginEpoch().
  void beginEpoch() { samples_.beginEpoch(); }
  /// Bytes for its samples. Those for which there is no room are kept as extremes of each 100 ms,
  /// for which an eighth is set aside.
  void setBudget(std::size_t bytes);
  [[nodiscard]] std::size_t bytes() const { return samples_.bytes() + history_.bytes(); }
  /// The oldest part of what it shows has no samples any more.
  [[nodiscard]] bool isThinned() const;
  [[nodiscard]] const SampleRing& samples() const { return samples_; }

  /// Nothing comes: `reason` says what is waited for. A new curve is stale from the start.
  void setStale(const QString& reason) { stale_reason_ = reason; }
  [[nodiscard]] bool isStale() const { return !stale_reason_.isEmpty(); }
  [[nodiscard]] const QString& staleReason() const { return stale_reason_; }

  /// The source's component stands still, and why; empty where it runs. What there is goes on being
  /// shown, as old.
  void setStandstill(const QString& why);
  [[nodiscard]] bool isStandingStill() const { return !standstill_.isEmpty(); }
  [[nodiscard]] const QString& standstill() const { return standstill_; }
  /// Whether the newest sample is no longer what there is now.
  [[nodiscard]] bool isSilent() const { return isStale() || isStandingStill(); }

  /// What its source had lost before it began.
  void setLossesBefore(const RowLosses& losses) { losses_before_ = losses; }
  [[nodiscard]] const RowLosses& lossesBefore() const { return losses_before_; }

  /// What is shown of it; CurveSet::setLook() sees to the axes.
  void setLook(const CurveLook& look);
  [[nodiscard]] const CurveLook& look() const { return look_; }
  [[nodiscard]] const Scaling& scaling() const { return look_.scaling; }
  /// The names of its values, where they have any; CurveSet::setNames() sees to the axes.
  void setNames(ValueNamesPointer names) { names_ = std::move(names); }
  [[nodiscard]] const ValueNamesPointer& allNames() const { return names_; }
  /// Those that are shown: a scaled value has none. May be null.
  [[nodiscard]] const ValueNames* names() const {
    return look_.scaling.isNone() ? names_.get() : nullptr;
  }
  /// What is shown are integers, which step from sample to sample.
  [[nodiscard]] bool isWhole() const {
    return samples_.kind() != ExactNumber::Kind::kReal && look_.scaling.isNone();
  }
  /// Its unit, and how it is scaled: "rad ×1000 +2".
  [[nodiscard]] QString shownUnit() const { return UnitOf(unit(), look_.scaling); }
  /// The chosen one, else that of what is shown: the type of values that have names.
  [[nodiscard]] QString axis() const {
    if (!look_.axis.isEmpty()) return look_.axis;
    return names() != nullptr ? names()->type : shownUnit();
  }
  /// What distances are counted from: that of its axis.
  void setBase(double base);

  void setVisible(bool visible) { visible_ = visible; }
  [[nodiscard]] bool isVisible() const { return visible_; }

  // As they are shown: scaled.
  /// Of the last sample at `time_ns` or before, within the same stretch of unbroken samples.
  [[nodiscard]] std::optional<double> valueAt(std::int64_t time_ns) const;
  [[nodiscard]] std::optional<double> latestValue() const;
  // The same, exactly: integers, where they are not scaled, keep all their digits.
  [[nodiscard]] std::optional<ExactNumber> numberAt(std::int64_t time_ns) const;
  [[nodiscard]] std::optional<ExactNumber> latestNumber() const;
  /// How far a sample, as it is shown, is from the base.
  [[nodiscard]] double distanceOf(std::uint64_t index) const;
  /// Rows a second that arrived, over the latest second of the source's time; 0 with less than two.
  [[nodiscard]] double rate() const;
  /// The curve as slices show it, scaled, in distances from the base. Built when asked for other
  /// slices than the last time of the same pass, or when samples have come.
  [[nodiscard]] const Envelope& envelope(const TimeSlices& slices,
                                         Pass pass = Pass::kPresent) const;

 private:
  struct Drawn {
    Envelope envelope;
    Envelope scaled;  // of a scaled curve
    TimeSlices slices;
    std::uint64_t end = 0;  // of the samples
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
  mutable std::array<Drawn, 2> drawn_;  // of each pass
};

/// "waiting for robot/arm/state"
[[nodiscard]] QString WaitingFor(const QString& path);

}  // namespace tendon::gui
