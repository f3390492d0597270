#pragma once

#include <gcm_gui/plot/series/axis_frame.h>
#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/plot/series/curve.h>
#include <gcm_gui/plot/series/sample_ring.h>

#include <QString>
#include <QStringList>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace tendon::gui {

/// How a Y axis follows the visible data.
enum class Fit {
  kClose,      ///< as narrow as the data
  kGrow,       ///< never narrower than before
  kSymmetric,  ///< 0 is in the middle
};

/// The Y axis of all curves with the same unit and scaling, or with the same chosen axis.
struct UnitAxis {
  QString unit;        ///< or the name of a chosen axis: see Curve::axis()
  AxisFrame frame;     ///< maps values to places
  AxisRange range;     ///< of places
  bool fitted = true;  ///< follows the visible data; false: chosen by the user
  AxisRange grown{};   ///< the data range it was fitted to; of all time with Fit::kGrow
  bool has_grown = false;
  int color_index = -1;                    ///< of its only curve; -1 if it has several
  ValueNamesPointer names;                 ///< common to all its curves; else null
  NumberKind numbers = NumberKind::kReal;  ///< whole if all its curves are whole
};

/// Slices of a pass; those before `first` are hidden.
struct SeenSlices {
  TimeSlices slices;
  Pass pass = Pass::kPresent;
  std::size_t first = 0;
};

/// Figures about the received rows of one state table.
struct SourceFigures {
  QString source;
  double rate = 0;  ///< Hz
  std::uint64_t lost = 0;
  std::uint64_t repeated = 0;
  QString path = {};             ///< of the curve with the most losses
  RowLosses losses_before = {};  ///< of its source, before that curve was added
  RowLosses losses = {};         ///< since then, as far as known
};

/// The curves of one plot in order of addition, and an axis for each unit. Only the first four axes
/// have labels, see PlotAxes; curves of further axes use the whole height.
class CurveSet {
 public:
  /// Returns the existing curve if there is one.
  Curve& add(const CurveKey& key);
  /// Returns true if it existed.
  bool remove(const QString& path);
  /// Removes the curve with its samples, for adopt() of another set; nullptr if there is none.
  [[nodiscard]] std::unique_ptr<Curve> take(const QString& path);
  /// Adds the curve in a free colour. Its path must not be here yet.
  Curve& adopt(std::unique_ptr<Curve> curve);
  /// Also refits the curve's axis.
  void setLook(Curve& curve, const CurveLook& look);
  /// Also refits the curve's axis if it changes.
  void setNames(Curve& curve, ValueNamesPointer names);
  /// nullptr if there is none. The pointer is valid until the curve is removed.
  [[nodiscard]] Curve* find(const QString& path) const;

  [[nodiscard]] const std::vector<std::unique_ptr<Curve>>& curves() const { return curves_; }
  [[nodiscard]] bool empty() const { return curves_.empty(); }
  [[nodiscard]] std::vector<UnitAxis>& axes() { return axes_; }
  [[nodiscard]] const std::vector<UnitAxis>& axes() const { return axes_; }
  [[nodiscard]] const UnitAxis& axisOf(const Curve& curve) const;

  /// For all axes.
  void setFit(Fit fit);
  [[nodiscard]] Fit fit() const { return fit_; }
  /// For all axes, which are then refitted. A logarithmic axis uses kClose for kSymmetric.
  void setScale(ValueScale scale);
  [[nodiscard]] ValueScale scale() const { return scale_; }
  /// The names of the curves with values of 0 or less in the slices, which have no place on a
  /// logarithmic axis. Empty on a linear one.
  [[nodiscard]] QStringList withoutPlace(std::span<const SeenSlices> seen) const;
  /// Fits the axes that follow the data to the values in the slices. Ignores a curve whose values
  /// are beyond 1e12 and more than a million times those of the others on its axis, because it
  /// would flatten the others; beyondAxes() names it.
  void fitAxes(std::span<const SeenSlices> seen);
  [[nodiscard]] const QStringList& beyondAxes() const { return beyond_; }
  /// The time of the newest sample of all curves; INT64_MIN without any.
  [[nodiscard]] std::int64_t newestTime() const;
  /// One entry per source, even if several of its columns are plotted. The rate is 0 if the last
  /// row is older than a second and two periods at `now_ns`.
  [[nodiscard]] std::vector<SourceFigures> figures(std::int64_t now_ns) const;

 private:
  struct Extremes {
    const Curve* curve = nullptr;
    AxisRange data;  // distances from the base, or their logarithms
    bool is_beyond = false;
  };

  void updateAxes();
  void fit(UnitAxis& axis, std::span<const SeenSlices> seen);
  [[nodiscard]] AxisRange chooseFrame(UnitAxis& axis, std::span<const SeenSlices> seen);
  [[nodiscard]] AxisRange withGrown(const AxisRange& data, const UnitAxis& axis) const;
  void setFrame(UnitAxis& axis, const AxisFrame& frame);
  /// True if the axis has the names of states.
  [[nodiscard]] bool hasStates(const UnitAxis& axis) const;
  void showBases();
  [[nodiscard]] std::vector<Extremes> extremesOn(const UnitAxis& axis,
                                                 std::span<const SeenSlices> seen) const;
  [[nodiscard]] AxisRange extremesOf(const Curve& curve, const SeenSlices& seen) const;
  [[nodiscard]] int freeColor() const;

  std::vector<std::unique_ptr<Curve>> curves_;
  std::vector<UnitAxis> axes_;
  QStringList beyond_;
  Fit fit_ = Fit::kClose;
  ValueScale scale_ = ValueScale::kLinear;
};

}  // namespace tendon::gui
