#pragma once

#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/plot/series/envelope.h>

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QSize>
#include <cstddef>
#include <cstdint>
#include <vector>

class QPainter;

namespace tendon::gui {

/// Maps a value to a row of pixels: row = (place - low) * scale + offset. On a linear axis, the
/// place of a value is value * factor; on a logarithmic axis, it is the logarithm of that product.
/// Values of 0 or less have no logarithm; they are drawn in the lowest row.
///
/// `low`, the lower end of the axis, is subtracted first. Without this, an axis far away from 0
/// would have row numbers so large that a double could not distinguish neighbouring rows.
struct RowScale {
  double low = 0;
  double scale = 1;
  double offset = 0;
  double factor = 1;
  ValueScale values = ValueScale::kLinear;
};

/// The dashes of a line, in columns. A line without gaps has no dashes.
struct Dashes {
  int dash = 0;
  int gap = 0;
  std::int64_t first = 0;  ///< column of the pattern at the first column of the image

  [[nodiscard]] bool isGap(int column) const {
    if (gap == 0) return false;
    const std::int64_t rest = (first + column) % (dash + gap);
    return (rest < 0 ? rest + dash + gap : rest) >= dash;
  }
};

/// Draws envelopes as smooth lines into an image, and then paints the image at once.
///
/// Qt draws a line at a cost per point, and at a much higher cost if the line is thick or
/// antialiased. Here the cost of a curve is per column of pixels. Each column has kSlicesPerColumn
/// slices. A slice is the band between its lowest and highest value, widened by a round pen. The
/// opacity of a pixel is the fraction of the pixel that the bands cover.
class SpanRaster {
 public:
  static constexpr std::size_t kSlicesPerColumn = 4;

  /// Starts with an empty image of this size in device pixels.
  void begin(QSize size);
  /// Draws on top of the image. The envelope must have kSlicesPerColumn slices per column; `radius`
  /// is half the line width in device pixels.
  void draw(const Envelope& envelope, const RowScale& rows, double radius, const QColor& color,
            const Dashes& dashes = {});
  /// Paints the rows of the image that were drawn on; `top_left` is in logical pixels.
  void paint(QPainter& painter, const QPointF& top_left, double device_pixel_ratio) const;
  /// Returns the drawn picture. The result shares the memory of this object.
  [[nodiscard]] QImage image() const;

 private:
  // Tops and bottoms of the bands, in rows. They are in separate arrays so that the compiler can
  // vectorise the widening.
  struct Bands {
    std::vector<float> tops;
    std::vector<float> bottoms;

    void clear(std::size_t count);
  };

  void mapBands(const Envelope& envelope, const RowScale& rows);
  void widenBands(double radius);
  void drawColumn(int x, std::uint32_t color);

  QSize size_;
  std::size_t stride_ = 0;  // pixels per row
  std::vector<std::uint32_t> pixels_;
  int first_row_ = 0;  // first row that was drawn on
  int end_row_ = 0;
  std::size_t margin_ = 0;  // number of empty bands at both ends, as many as the pen is wide
  Bands thin_;
  Bands wide_;
  std::vector<float> reach_;
  std::vector<int> changes_;  // changes of the coverage from row to row; all 0 between two columns
};

}  // namespace tendon::gui
