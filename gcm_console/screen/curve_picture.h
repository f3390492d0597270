#pragma once

#include <gcm_console/screen/curve_feed.h>

#include <string>
#include <vector>

namespace console {

/// Fewer rows no curve has in a picture.
constexpr int kFewestCurveRows = 3;

/// Curves below each other, each with its title, its newest value, all of it, and a scale; the
/// newest sample is at the right edge, and `window` seconds fit in. States and counts are drawn in
/// steps. `columns` and `rows` are those of the whole picture, which becomes higher where not all
/// curves fit in.
[[nodiscard]] std::string PictureOf(const std::vector<Curve>& curves, double window, int columns,
                                    int rows);

}  // namespace console
