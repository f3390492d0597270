#pragma once

#include <gcm_gui/plot/series/axis_frame.h>
#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/plot/series/curve.h>
#include <gcm_gui/plot/series/row_losses.h>
#include <gcm_gui/plot/series/sample_ring.h>

#include <QString>
#include <QStringList>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tendon::gui {

/// The ways in which a Y axis follows the visible data.
enum class Fit {
  kClose,      ///< as narrow as the data
  kGrow,       ///< never narrower than before
  kSymmetric,  ///< 0 is in the middle
};

/// The Y axis of all curves that have the same unit and scaling, or for which the user has chosen
/// the same axis.
struct UnitAxis {
  QString unit;        ///< the name of the axis, usually a unit: see Curve::axis()
  AxisFrame frame;     ///< maps values to places
  AxisRange range;     ///< the range of places
  bool fitted = true;  ///< true: follows the visible data; false: range chosen by the user
  AxisRange grown{};   ///< data range of the fit; with Fit::kGrow, of all data so far
  bool has_grown = false;
  int color_index = -1;     ///< colour of its curve; -1 if it has several curves
  ValueNamesPointer names;  ///< names of the values; null unless all its curves have the same names
  NumberKind numbers = NumberKind::kReal;  ///< kWhole if all its curves are whole
};

/// The slices of one pass. The slices before `first` are hidden.
struct VisibleSlices {
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
  QString path = {};             ///< path of the curve with the most losses
  RowLosses losses_before = {};  ///< losses of the source before that curve was added
  RowLosses losses = {};         ///< known losses of the source since that time
};

/// The curves of one plot, in the order in which they were added, and an axis for each unit. Only
/// the first four axes have labels, see PlotAxes. Curves on further axes are drawn without labels
/// and use the whole height.
class CurveSet {
 public:
  /// Adds a curve. Returns the existing curve if the path is already in the set. The live
  /// curve of a signal and the first recorded one have the same colour.
  Curve& add(const CurveKey& key);
  /// Removes a curve. Returns false if the path is not in the set.
  bool remove(const QString& path);
  /// Removes a curve with its samples and returns it, so that another set can adopt() it; nullptr
  /// if the path is not in the set.
  [[nodiscard]] std::unique_ptr<Curve> take(const QString& path);
  /// Adds a curve and gives it a free colour. Its path must not be in the set yet.
  Curve& adopt(std::unique_ptr<Curve> curve);
  /// Sets the look of a curve, and refits the curve's axis.
  void setLook(Curve& curve, const CurveLook& look);
  /// Sets the names of a curve's values. If the curve gets another axis, refits this axis.
  void setNames(Curve& curve, ValueNamesPointer names);
  /// Returns the curve of this path; nullptr if there is none. The pointer is valid until the curve
  /// is removed.
  [[nodiscard]] Curve* find(const QString& path) const;

  [[nodiscard]] const std::vector<std::unique_ptr<Curve>>& curves() const { return curves_; }
  [[nodiscard]] bool empty() const { return curves_.empty(); }
  [[nodiscard]] std::vector<UnitAxis>& axes() { return axes_; }
  [[nodiscard]] const std::vector<UnitAxis>& axes() const { return axes_; }
  [[nodiscard]] const UnitAxis& axisOf(const Curve& curve) const;

  /// Lets all axes follow the data.
  void fitAll();
  /// True if all axes follow the data.
  [[nodiscard]] bool isFitted() const;
  /// Sets how all axes follow the data.
  void setFit(Fit fit);
  [[nodiscard]] Fit fit() const { return fit_; }
  /// Sets the scale of all axes, which are then refitted. On a logarithmic axis, kSymmetric has the
  /// effect of kClose.
  void setScale(ValueScale scale);
  [[nodiscard]] ValueScale scale() const { return scale_; }
  /// Returns the names of the curves that have values of 0 or less in the slices, because a
  /// logarithmic axis cannot show these values. Empty on a linear axis.
  [[nodiscard]] QStringList withoutPlace(std::span<const VisibleSlices> seen) const;
  /// Fits the axes that follow the data to the values in the slices. Ignores a curve whose values
  /// are beyond 1e12 and more than a million times larger than the values of the other curves on
  /// its axis: such a curve would flatten the others. beyondAxes() returns the ignored curves.
  void fitAxes(std::span<const VisibleSlices> seen);
  [[nodiscard]] const QStringList& beyondAxes() const { return beyond_; }
  /// Returns the time of the newest sample of all curves that are not recorded; INT64_MIN if there
  /// are no samples.
  [[nodiscard]] std::int64_t newestTime() const;
  /// Returns one entry for each source that is not recorded, even if several of its columns are
  /// plotted. The rate is 0
  /// if the last row is older than one second and older than two periods at `now_ns`.
  [[nodiscard]] std::vector<SourceFigures> figures(std::int64_t now_ns) const;

 private:
  struct Extremes {
    const Curve* curve = nullptr;
    AxisRange data;  // distances from the base, or logarithms of values
    bool is_beyond = false;
  };

  void updateAxes();
  void fit(UnitAxis& axis, std::span<const VisibleSlices> seen);
  [[nodiscard]] AxisRange chooseFrame(UnitAxis& axis, std::span<const VisibleSlices> seen);
  [[nodiscard]] AxisRange withGrown(const AxisRange& data, const UnitAxis& axis) const;
  void setFrame(UnitAxis& axis, const AxisFrame& frame);
  /// Returns true if the axis shows the names of states.
  [[nodiscard]] bool hasStates(const UnitAxis& axis) const;
  void showBases();
  [[nodiscard]] std::vector<Extremes> extremesOn(const UnitAxis& axis,
                                                 std::span<const VisibleSlices> seen) const;
  [[nodiscard]] AxisRange extremesOf(const Curve& curve, const VisibleSlices& seen) const;
  [[nodiscard]] int colorFor(const QString& path) const;

  std::vector<std::unique_ptr<Curve>> curves_;
  std::vector<UnitAxis> axes_;
  QStringList beyond_;
  Fit fit_ = Fit::kClose;
  ValueScale scale_ = ValueScale::kLinear;
};

}  // namespace tendon::gui
