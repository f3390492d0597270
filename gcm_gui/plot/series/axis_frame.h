#pragma once

#include <gcm_gui/plot/series/axis_range.h>

#include <QString>

namespace tendon::gui {

/// Maps values to places on an axis: place = (value - base) / 10^exponent. On a logarithmic axis,
/// the place is the logarithm of this number. Therefore, the places are ordinary numbers, even if
/// the values are close together and far from 0, or near the largest double.
struct AxisFrame {
  /// A round number near the values if the values are far from 0; otherwise 0. The base is shown
  /// beside the unit.
  double base = 0;
  /// 0, unless the distances between values are too large for a double.
  int exponent = 0;

  /// Returns the place of a value at this distance from the base.
  [[nodiscard]] double placeOf(double distance, ValueScale scale) const {
    return PlaceOf(distance * factor(), scale);
  }
  [[nodiscard]] double factor() const { return exponent == 0 ? 1 : kOfExponent; }
  /// Returns the number to add to each label, such as "+9e9"; empty if the base is 0.
  [[nodiscard]] QString baseText() const;
  bool operator==(const AxisFrame&) const = default;

  static constexpr int kExponent = 300;
  static constexpr double kOfExponent = 1e-300;
};

/// Converts a range from one frame to another.
[[nodiscard]] AxisRange Moved(const AxisRange& range, const AxisFrame& from, const AxisFrame& to);

/// Returns a frame for the values of `distances`, which are relative to the base of `current`.
/// Returns `current` as long as it is suitable.
[[nodiscard]] AxisFrame FrameFor(const AxisFrame& current, const AxisRange& distances,
                                 NumberKind numbers);

}  // namespace tendon::gui
