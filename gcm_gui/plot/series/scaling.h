#pragma once

#include <QString>
#include <optional>

namespace tendon::gui {

/// The scaling of a curve: the plot shows factor * value + offset. Samples are stored unscaled.
struct Scaling {
  double factor = 1;  ///< never 0
  double offset = 0;

  [[nodiscard]] double of(double value) const { return factor * value + offset; }
  [[nodiscard]] bool isNone() const { return factor == 1 && offset == 0; }
  bool operator==(const Scaling&) const = default;
};

/// The look of a curve: its scaling and its axis. Curves with the same axis name share an axis.
/// With an empty name, the curve uses the axis of its unit.
struct CurveLook {
  Scaling scaling;
  QString axis;

  bool operator==(const CurveLook&) const = default;
};

inline constexpr qsizetype kLongestAxis = 40;  ///< characters

/// Formats a number with enough digits that parsing the text gives the same value.
[[nodiscard]] QString ExactText(double value);

/// Formats a scaling: "×1000 +2", "×-1", "-0.5"; empty if there is no scaling.
[[nodiscard]] QString TextOf(const Scaling& scaling);
/// Returns the unit of a scaled number: "rad ×1000 +2".
[[nodiscard]] QString UnitOf(const QString& unit, const Scaling& scaling);

/// Returns why a plot cannot show this look, as a sentence; empty if it can.
[[nodiscard]] std::optional<QString> RefusalOf(const CurveLook& look);

/// Parses a number with a decimal point; empty if `text` is not a number.
[[nodiscard]] std::optional<double> NumberIn(const QString& text);

}  // namespace tendon::gui
