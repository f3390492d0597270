#pragma once

#include <gcm_gui/plot/series/axis_range.h>

#include <QString>

namespace tendon::gui {

/// How values become places on an axis: a place is (value - base) / 10^exponent, of which a
/// logarithmic axis takes the logarithm. So the range of an axis is one of ordinary numbers,
/// whatever its values are: near each other and far from 0, or near the largest doubles.
struct AxisFrame {
  double base = 0;   ///< a round number near the values, written beside the unit; else 0
  int exponent = 0;  ///< not 0 for values whose distances do not fit a double

  /// Of a value that is `distance` from the base.
  [[nodiscard]] double placeOf(double distance, ValueScale scale) const {
    return PlaceOf(distance * factor(), scale);
  }
  [[nodiscard]] double factor() const { return exponent == 0 ? 1 : kOfExponent; }
  /// What is added to each label, "+9e9"; empty where that is nothing.
  [[nodiscard]] QString baseText() const;
  bool operator==(const AxisFrame&) const = default;

  static constexpr int kExponent = 300;
  static constexpr double kOfExponent = 1e-300;
};

/// The same values in another frame.
[[nodiscard]] AxisRange Moved(const AxisRange& range, const AxisFrame& from, const AxisFrame& to);

/// A frame for values from base + low to base + high, which are distances from the base of
/// `current`; that one as long as it serves.
[[nodiscard]] AxisFrame FrameFor(const AxisFrame& current, const AxisRange& distances,
                                 NumberKind numbers);

}  // namespace tendon::gui
