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

/// From a value to a row of pixels: row = (place - low) * scale + offset, of its place on the axis,
/// value * factor or its logarithm. A value that has no place is drawn along the lowest row.
///
/// The place at which the axis begins is subtracted first: the row at place 0 may be so far outside
/// that a double cannot tell it from its neighbours.
struct RowScale {
  double low = 0;
  double scale = 1;
  double offset = 0;
  double factor = 1;
  ValueScale values = ValueScale::kLinear;
};

/// Draws envelopes as smooth lines into a picture of its own, which is painted in one go.
///
/// A pen stroke of Qt costs by the point and much more when it is thick or smooth; here a curve
/// costs by the column. Each pixel column has kSlicesPerColumn slices; a slice is the band between
/// its lowest and highest value, widened by a round pen, and a pixel is as opaque as bands cover
/// it.
class SpanRaster {
 public:
  static constexpr std::size_t kSlicesPerColumn = 4;

  /// An empty picture of so many device pixels.
  void begin(QSize size);
  /// Above what was drawn before. The envelope has kSlicesPerColumn slices a column; `radius` in
  /// device pixels is half the thickness of the line.
  void draw(const Envelope& envelope, const RowScale& rows, double radius, const QColor& color);
  /// In logical pixels. Touches only the rows that were drawn on.
  void paint(QPainter& painter, const QPointF& top_left, double device_pixel_ratio) const;
  /// For tests; shares the memory of this object.
  [[nodiscard]] QImage image() const;

 private:
  // Tops and bottoms, in rows; apart from each other so that the compiler can widen many at once.
  struct Bands {
    std::vector<float> tops;
    std::vector<float> bottoms;

    void clear(std::size_t count);
  };

  void mapBands(const Envelope& envelope, const RowScale& rows);
  void widenBands(double radius);
  void drawColumn(int x, std::uint32_t color);

  QSize size_;
  std::size_t stride_ = 0;  // pixels from row to row
  std::vector<std::uint32_t> pixels_;
  int first_row_ = 0;  // drawn on
  int end_row_ = 0;
  std::size_t margin_ = 0;  // empty bands at both ends, as wide as the pen
  Bands thin_;
  Bands wide_;
  std::vector<float> reach_;
  std::vector<int> changes_;  // of the coverage from row to row; all 0 between two columns
};

}  // namespace tendon::gui
