#pragma once

#include <gcm_console/feeds/curve_feed.h>

#include <string>
#include <vector>

namespace console {

/// Draws dots in a terminal. Each character cell has two columns and four rows of dots.
class BrailleCanvas {
 public:
  /// Creates a canvas. Its size is given in character cells.
  BrailleCanvas(int columns, int rows);

  [[nodiscard]] int width() const { return 2 * columns_; }  ///< in dots
  [[nodiscard]] int height() const { return 4 * rows_; }
  /// Draws a dot; (0, 0) is at the top left. Dots outside of the canvas are ignored.
  void Set(int x, int y);
  /// Draws from one dot to the other, both included.
  void Line(int x1, int y1, int x2, int y2);
  /// Returns one line for the terminal, in UTF-8.
  [[nodiscard]] std::string Row(int row) const;

 private:
  int columns_;
  int rows_;
  std::vector<unsigned> cells_;
};

/// The minimum height of a curve, in rows.
constexpr int kFewestCurveRows = 3;

/// Draws the curves one below another, each with its title, newest value, unit and scale. The
/// newest sample is at the right edge; the width corresponds to `window` seconds. States and counts
/// are drawn as steps. `columns` and `rows` are the size of the whole picture. If the curves do not
/// fit, the picture becomes higher.
[[nodiscard]] std::string PictureOf(const std::vector<NumberCurve>& curves, double window,
                                    int columns, int rows);

}  // namespace console
