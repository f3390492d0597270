#pragma once

#include <tendon/payload/numeric_value.h>

#include <QList>
#include <QMetaType>
#include <optional>

namespace tendon::gui {

/// The recent values of a number, drawn as a small curve beside it.
struct Sparkline {
  QList<double> parts;      ///< oldest first, from 0 to 1; NaN if it cannot be drawn
  bool is_stepped = false;  ///< each value holds until the next one
};

/// Returns the trend of the latest values of a field. nullopt stands for a row without a value.
[[nodiscard]] Sparkline SparklineOf(const Schema& field,
                                    const QList<std::optional<NumericValue>>& values);

}  // namespace tendon::gui

Q_DECLARE_METATYPE(tendon::gui::Sparkline)
