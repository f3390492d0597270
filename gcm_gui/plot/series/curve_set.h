#pragma once

#include <gcm_gui/plot/row_losses.h>
#include <gcm_gui/plot/series/axis_frame.h>
#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/plot/series/curve.h>

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
  kSymmetric,  ///< 0 in the middle
};

/// The Y axis of all curves of one unit that are scaled alike, or for which it was chosen.
struct UnitAxis {
  QString unit;        ///< or the name of a chosen one: see Curve::axis()
  AxisFrame frame;     ///< how values become places
  AxisRange range;     ///< of places
  bool fitted = true;  ///< follows the visible data; else the user's choice
  AxisRange grown{};   ///< the places it was fitted to, of all time with Fit::kGrow
  bool has_grown = false;
  int color_index = -1;                    ///< of its only curve; -1 when it has several
  ValueNamesPointer names;                 ///< of all its curves; else null
  NumberKind numbers = NumberKind::kReal;  ///< whole, where all its curves are
};

/// Slices of which those before `first` are hidden.
struct SeenSlices {
  TimeSlices slices;
  Pass pass = Pass::kPresent;
  std::size_t first = 0;
};

/// How one state table's rows arrive.
struct SourceFigures {
  QString source;
  double rate = 0;  ///< Hz
  std::uint64_t lost = 0;
  std::uint64_t repeated = 0;
  QString path = {};             ///< of the curve that has lost most
  RowLosses losses_before = {};  ///< of its source, when that curve began
  RowLosses losses = {};         ///< since then, as far as they are known
};

/// The curves of one plot, in the order of their coming, and an axis for each unit among them. The
/// axes of the first four are written, see PlotAxes; the curves of others fill the height.
class CurveSet {
 public:
  /// The one there is, when it is there already.
  Curve& add(const CurveKey& key);
  /// Returns whether there was one.
  bool remove(const QString& path);
  /// With its samples, for adopt() of another set; nullptr when there is none.
  [[nodiscard]] std::unique_ptr<Curve> take(const QString& path);
  /// In a colour that is free here. Its path must not be here yet.
  Curve& adopt(std::unique_ptr<Curve> curve);
  /// Its axis is fitted anew.
  void setLook(Curve& curve, const CurveLook& look);
  /// Where its axis is another one then, that is fitted anew.
  void setNames(Curve& curve, ValueNamesPointer names);
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
  /// Of all axes, which are fitted anew. A logarithmic one cannot be symmetric: it is kClose then.
  void setScale(ValueScale scale);
  [[nodiscard]] ValueScale scale() const { return scale_; }
  /// Names of the curves that have values in the slices which a logarithmic axis has no place for:
  /// 0 and less. Empty on a linear one.
  [[nodiscard]] QStringList withoutPlace(std::span<const SeenSlices> seen) const;
  /// Fits the axes that follow the data to what the slices show. A curve whose values are more than
  /// a million times those of the others on its axis, and beyond 1e12, would make flat lines of
  /// them: it is left out, and named by beyondAxes().
  void fitAxes(std::span<const SeenSlices> seen);
  [[nodiscard]] const QStringList& beyondAxes() const { return beyond_; }
  /// Time of the newest sample of all; INT64_MIN without any.
  [[nodiscard]] std::int64_t newestTime() const;
  /// A source of which several columns are plotted counts once. One that is silent since a second
  /// before `now_ns`, and two of its periods, has rate 0.
  [[nodiscard]] std::vector<SourceFigures> figures(std::int64_t now_ns) const;

 private:
  struct Extremes {
    const Curve* curve = nullptr;
    AxisRange data;  // distances from the base; logarithms on such an axis
    bool is_beyond = false;
  };

  void updateAxes();
  void fit(UnitAxis& axis, std::span<const SeenSlices> seen);
  [[nodiscard]] AxisRange chooseFrame(UnitAxis& axis, std::span<const SeenSlices> seen);
  [[nodiscard]] AxisRange withGrown(const AxisRange& data, const UnitAxis& axis) const;
  void setFrame(UnitAxis& axis, const AxisFrame& frame);
  /// It has the names of states.
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
