#pragma once

#include <QString>
#include <optional>

namespace tendon::gui {

/// What a plot shows of a value: factor * value + offset. The samples stay as they came.
struct Scaling {
  double factor = 1;  ///< never 0
  double offset = 0;

  [[nodiscard]] double of(double value) const { return factor * value + offset; }
  [[nodiscard]] bool isNone() const { return factor == 1 && offset == 0; }
  bool operator==(const Scaling&) const = default;
};

/// How a curve is to be shown: scaled, and on which axis. Curves with the same axis share it; an
/// empty one stands for that of the unit.
struct CurveLook {
  Scaling scaling;
  QString axis;

  bool operator==(const CurveLook&) const = default;
};

inline constexpr qsizetype kLongestAxis = 40;  ///< letters of its name

/// A number with all the digits that it takes to be read as the same.
[[nodiscard]] QString ExactText(double value);

/// "×1000 +2", "×-1", "-0.5"; empty where nothing is scaled.
[[nodiscard]] QString TextOf(const Scaling& scaling);
/// "rad ×1000 +2": what stands behind a scaled number.
[[nodiscard]] QString UnitOf(const QString& unit, const Scaling& scaling);

/// Why a plot cannot show this, a sentence; nothing where it can.
[[nodiscard]] std::optional<QString> RefusalOf(const CurveLook& look);

/// What a person has typed, with a decimal point; nothing where it is no number.
[[nodiscard]] std::optional<double> NumberIn(const QString& text);

}  // namespace tendon::gui
