#pragma once

#include <string>
#include <vector>

namespace console {

/// A picture of dots in a terminal: each letter shows two columns and four rows of them.
class BrailleCanvas {
 public:
  /// In letters.
  BrailleCanvas(int columns, int rows);

  [[nodiscard]] int width() const { return 2 * columns_; }  ///< in dots
  [[nodiscard]] int height() const { return 4 * rows_; }
  /// (0, 0) is at the top left; what lies outside is left out.
  void Set(int x, int y);
  /// From one dot to another, both of them, too.
  void Line(int x1, int y1, int x2, int y2);
  /// One line of the terminal, in UTF-8.
  [[nodiscard]] std::string Row(int row) const;

 private:
  int columns_;
  int rows_;
  std::vector<unsigned> cells_;
};

}  // namespace console
