#pragma once

#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/plot/series/curve.h>

#include <QString>
#include <cstddef>
#include <memory>
#include <vector>

namespace tendon::gui {

/// How a Y axis follows the visible data.
enum class Fit {
  kClose,      ///< as narrow as the data
  kGrow,       ///< never narrower than before
  kSymmetric,  ///< 0 in the middle
};

/// The Y axis of all curves of one unit.
struct UnitAxis {
  QString unit;
  AxisRange range;
  bool fitted = true;  ///< follows the visible data; else the user's choice
  AxisRange grown{};   ///< the data it was fitted to, of all time with Fit::kGrow
  bool has_grown = false;
  int color_index = -1;  ///< of its only curve; -1 when it has several
};

/// How one state table's rows arrive.
struct SourceFigures {
  QString source;
  double rate = 0;  ///< Hz
  std::uint64_t lost = 0;
  std::uint64_t repeated = 0;
};

/// The curves of one plot, in the order of their coming, and an axis for each unit among them: the
/// first axis is written at the left, the second at the right; the curves of others fill the
/// height.
class CurveSet {
 public:
  /// The one there is, when it is there already.
  Curve& add(const CurveKey& key);
  /// Returns whether there was one.
  bool remove(const QString& path);
  /// nullptr when there is none. Stays where it is until it is removed.
  [[nodiscard]] Curve* find(const QString& path) const;

  [[nodiscard]] const std::vector<std::unique_ptr<Curve>>& curves() const { return curves_; }
  [[nodiscard]] bool empty() const { return curves_.empty(); }
  [[nodiscard]] std::vector<UnitAxis>& axes() { return axes_; }
  [[nodiscard]] const std::vector<UnitAxis>& axes() const { return axes_; }
  [[nodiscard]] const UnitAxis& axisOf(const Curve& curve) const;

  /// Of all axes.
  void setFit(Fit fit);
  [[nodiscard]] Fit fit() const { return fit_; }
  /// Fits the axes that follow the data to what the slices show.
  void fitAxes(const TimeSlices& slices);
  /// Time of the newest sample of all; INT64_MIN without any.
  [[nodiscard]] std::int64_t newestTime() const;
  /// A source of which several columns are plotted counts once. One that is silent since a second
  /// before `now_ns`, and two of its periods, has rate 0.
  [[nodiscard]] std::vector<SourceFigures> figures(std::int64_t now_ns) const;

 private:
  void updateAxes();
  [[nodiscard]] int freeColor() const;

  std::vector<std::unique_ptr<Curve>> curves_;
  std::vector<UnitAxis> axes_;
  Fit fit_ = Fit::kClose;
};

}  // namespace tendon::gui
