#pragma once

#include <gcm_console/screen/curve_feed.h>

#include <string>
#include <vector>

namespace console {

/// The minimum height of a curve.
constexpr int kFewestCurveRows = 3;

/// Draws the curves below each other, each with its title, newest value, unit and scale. The newest
/// sample is at the right edge; the width shows `window` seconds. States and counts are drawn as
/// steps. `columns` and `rows` are the size of the whole picture; it becomes higher if the curves
/// do not fit.
[[nodiscard]] std::string PictureOf(const std::vector<Curve>& curves, double window, int columns,
                                    int rows);

}  // namespace console
