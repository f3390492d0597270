#pragma once

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

}  // namespace console
