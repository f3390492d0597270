#pragma once

#include <gcm_console/feeds/curve_feed.h>

#include <string>
#include <vector>

namespace console {

/// Draws dots in a terminal: each character cell has two columns and four rows of dots.
class BrailleCanvas {
 public:
  /// The size is in character cells.
  BrailleCanvas(int columns, int rows);

  [[nodiscard]] int width() const { return 2 * columns_; }  ///< in dots
  [[nodiscard]] int height() const { return 4 * rows_; }
  /// (0, 0) is the top left; dots outside are ignored.
  void Set(int x, int y);
  /// Draws from one dot to the other, both included.
  void Line(int x1, int y1, int x2, int y2);
  /// One line of the terminal, in UTF-8.
  [[nodiscard]] std::string Row(int row) const;

 private:
  int columns_;
  int rows_;
  std::vector<unsigned> cells_;
};

/// The minimum height of a curve.
constexpr int kFewestCurveRows = 3;

/// Draws the curves below each other, each with its title, newest value, unit and scale. The newest
/// sample is at the right edge; the width shows `window` seconds. States and counts are drawn as
/// steps. `columns` and `rows` are the size of the whole picture; it becomes higher if the curves
/// do not fit.
[[nodiscard]] std::string PictureOf(const std::vector<Curve>& curves, double window, int columns,
                                    int rows);

}  // namespace console
