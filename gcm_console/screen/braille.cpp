#include <gcm_console/screen/braille.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace console {

BrailleCanvas::BrailleCanvas(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      cells_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0U) {}

void BrailleCanvas::Set(int x, int y) {
  // The order of the dots in Unicode: left side from the top, right side from the top, then the
  // lowest two.
  constexpr std::array<unsigned, 8> kBits = {0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80};
  if (x < 0 || y < 0 || x >= width() || y >= height()) return;
  const auto cell = static_cast<std::size_t>(y / 4 * columns_ + x / 2);
  cells_[cell] |= kBits.at(static_cast<std::size_t>(y % 4 * 2 + x % 2));
}

void BrailleCanvas::Line(int x1, int y1, int x2, int y2) {
  const int steps = std::max({std::abs(x2 - x1), std::abs(y2 - y1), 1});
  for (int step = 0; step <= steps; ++step) {
    Set(x1 + (x2 - x1) * step / steps, y1 + (y2 - y1) * step / steps);
  }
}

std::string BrailleCanvas::Row(int row) const {
  constexpr unsigned kFirst = 0x2800;
  std::string text;
  for (int column = 0; column < columns_; ++column) {
    const unsigned letter = kFirst + cells_[static_cast<std::size_t>(row * columns_ + column)];
    text += static_cast<char>(0xe0U | (letter >> 12U));
    text += static_cast<char>(0x80U | ((letter >> 6U) & 0x3fU));
    text += static_cast<char>(0x80U | (letter & 0x3fU));
  }
  return text;
}

}  // namespace console
