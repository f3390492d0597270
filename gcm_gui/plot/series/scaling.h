#pragma once

#include <QString>
#include <optional>

namespace tendon::gui {

/// The shown value is factor * value + offset. Samples are stored unscaled.
struct Scaling {
  double factor = 1;  ///< never 0
  double offset = 0;

  [[nodiscard]] double of(double value) const { return factor * value + offset; }
  [[nodiscard]] bool isNone() const { return factor == 1 && offset == 0; }
  bool operator==(const Scaling&) const = default;
};

/// The look of a curve: its scaling, and its axis. Curves with the same axis name share an axis; an
/// empty name means the axis of the unit.
struct CurveLook {
  Scaling scaling;
  QString axis;

  bool operator==(const CurveLook&) const = default;
};

inline constexpr qsizetype kLongestAxis = 40;  ///< characters

/// A number with enough digits to read back the same value.
[[nodiscard]] QString ExactText(double value);

/// "×1000 +2", "×-1", "-0.5"; empty without scaling.
[[nodiscard]] QString TextOf(const Scaling& scaling);
/// "rad ×1000 +2": the unit of a scaled number.
[[nodiscard]] QString UnitOf(const QString& unit, const Scaling& scaling);

/// The reason why a plot cannot show this, as a sentence; empty if it can.
[[nodiscard]] std::optional<QString> RefusalOf(const CurveLook& look);

/// Parses input with a decimal point; empty if it is not a number.
[[nodiscard]] std::optional<double> NumberIn(const QString& text);

}  // namespace tendon::gui
