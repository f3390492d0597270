#include <gcm_gui/plot/canvas/span_raster.h>

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace tendon::gui {
namespace {

constexpr auto kSlices = SpanRaster::kSlicesPerColumn;
constexpr int kFullBand = 64;  // the value of a band that covers a whole row
constexpr int kFullPixel = kFullBand * static_cast<int>(kSlices);
constexpr float kNowhere = 1e9F;  // the top of an empty band; its bottom is -kNowhere
constexpr double kOutside = 64;   // rows outside the picture; values are cut off there

// Blends `color` with `below`; both are premultiplied. The opacity is `coverage` / 256.
std::uint32_t Blend(std::uint32_t below, std::uint32_t color, std::uint32_t coverage) {
  constexpr std::uint32_t kPairs = 0x00ff00ff;
  const std::uint32_t rest = 256 - coverage;
  const std::uint32_t even = ((color & kPairs) * coverage + (below & kPairs) * rest) >> 8;
  const std::uint32_t odd = ((color >> 8) & kPairs) * coverage + ((below >> 8) & kPairs) * rest;
  return (even & kPairs) | (odd & ~kPairs);
}

// Bands are widened in blocks of this size, so that the compiler can vectorise the loop.
constexpr std::size_t kBlock = 64;

// Widens a block of bottoms (`direction` 1) or of tops (`direction` -1). For tops, the picture is
// turned upside down, so that a top becomes a bottom. Reads from `thin` one block, plus the width
// of the pen.
void Widen(const float* thin, const std::vector<float>& reach, float direction, float* wide) {
  std::array<float, kBlock> lowest;
  lowest.fill(-kNowhere);
  for (std::size_t k = 0; k < reach.size(); ++k) {
    for (std::size_t i = 0; i < kBlock; ++i) {
      const float reached = direction * thin[i + k] + reach[k];
      lowest[i] = reached > lowest[i] ? reached : lowest[i];
    }
  }
  for (std::size_t i = 0; i < kBlock; ++i) wide[i] = direction * lowest[i];
}

}  // namespace

void SpanRaster::begin(QSize size) {
  if (size != size_) {
    size_ = size;
    // The distance between two rows in memory is an odd number of cache lines. Columns are drawn
    // downwards: if the distance were a power of two, all pixels of a column would be in a few
    // cache sets.
    constexpr std::size_t kLine = 16;
    stride_ = ((static_cast<std::size_t>(size.width()) + kLine - 1) / kLine | 1) * kLine;
    pixels_.assign(stride_ * static_cast<std::size_t>(size.height()), 0);
    changes_.assign(static_cast<std::size_t>(size.height()) + 2, 0);
  } else if (first_row_ < end_row_) {
    const auto row = [this](int y) {
      return pixels_.begin() + static_cast<std::ptrdiff_t>(stride_) * y;
    };
    std::fill(row(first_row_), row(end_row_), 0);
  }
  first_row_ = size.height();
  end_row_ = 0;
}

void SpanRaster::draw(const Envelope& envelope, const RowScale& rows, double radius,
                      const QColor& color, const Dashes& dashes) {
  if (envelope.lowest() > envelope.highest()) return;
  margin_ = static_cast<std::size_t>(std::floor(radius * kSlices));
  mapBands(envelope, rows);
  widenBands(radius);
  const int columns = std::min(size_.width(), static_cast<int>(envelope.low().size() / kSlices));
  for (int x = 0; x < columns; ++x) {
    if (!dashes.isGap(x)) drawColumn(x, color.rgb());
  }
}

void SpanRaster::Bands::clear(std::size_t count) {
  tops.assign(count, kNowhere);
  bottoms.assign(count, -kNowhere);
}

void SpanRaster::mapBands(const Envelope& envelope, const RowScale& rows) {
  const std::span<const double> low = envelope.low();
  const std::span<const double> high = envelope.high();
  const double last = size_.height() + kOutside;
  const std::size_t blocks = (low.size() + kBlock - 1) / kBlock;
  thin_.clear(blocks * kBlock + 2 * margin_);
  const auto row = [&](double place) { return (place - rows.low) * rows.scale + rows.offset; };
  const auto logarithmic_row = [&](double value) {
    return value > 0 ? row(std::log10(value)) : size_.height() - 1.0;
  };
  for (std::size_t i = 0; i < low.size(); ++i) {
    if (low[i] > high[i]) continue;
    const bool linear = rows.values == ValueScale::kLinear;
    const double from = linear ? row(low[i] * rows.factor) : logarithmic_row(low[i]);
    const double to = linear ? row(high[i] * rows.factor) : logarithmic_row(high[i]);
    const double a = std::clamp(from, -kOutside, last);
    const double b = std::clamp(to, -kOutside, last);
    thin_.tops[margin_ + i] = static_cast<float>(std::min(a, b));
    thin_.bottoms[margin_ + i] = static_cast<float>(std::max(a, b));
  }
}

// Widens the bands as if a round pen were drawn along them. The new end of a band is the farthest
// point that the pen reaches from a neighbouring band. The farther the neighbour, the shorter the
// reach.
void SpanRaster::widenBands(double radius) {
  reach_.clear();
  for (std::size_t k = 0; k <= 2 * margin_; ++k) {
    const double across = (static_cast<double>(k) - static_cast<double>(margin_)) / kSlices;
    const double squared = std::max(0.0, radius * radius - across * across);
    reach_.push_back(static_cast<float>(std::sqrt(squared)));
  }
  const std::size_t count = thin_.tops.size() - 2 * margin_;
  wide_.tops.resize(count);
  wide_.bottoms.resize(count);
  for (std::size_t i = 0; i < count; i += kBlock) {
    Widen(thin_.tops.data() + i, reach_, -1, wide_.tops.data() + i);
    Widen(thin_.bottoms.data() + i, reach_, 1, wide_.bottoms.data() + i);
  }
}

// Each end of a band changes the coverage of the rows below it, in 64ths of a band. The sum of the
// changes from the top down to a row is the coverage of its pixel, in 256ths.
void SpanRaster::drawColumn(int x, std::uint32_t color) {
  const float* tops = wide_.tops.data() + static_cast<std::size_t>(x) * kSlices;
  const float* bottoms = wide_.bottoms.data() + static_cast<std::size_t>(x) * kSlices;
  const auto height = static_cast<float>(size_.height());
  int first = size_.height() * kFullBand;
  int last = 0;
  const auto change = [&](float row, int direction) {
    const int at = static_cast<int>(std::clamp(row, 0.0F, height) * kFullBand);
    int* change_at = changes_.data() + at / kFullBand;
    change_at[0] += direction * (kFullBand - at % kFullBand);
    change_at[1] += direction * (at % kFullBand);
    return at;
  };
  for (std::size_t i = 0; i < kSlices; ++i) {
    if (tops[i] >= bottoms[i]) continue;
    first = std::min(first, change(tops[i], 1));
    last = std::max(last, change(bottoms[i], -1));
  }
  if (first >= last) return;
  const int from = first / kFullBand;
  const int to = (last + kFullBand - 1) / kFullBand;
  first_row_ = std::min(first_row_, from);
  end_row_ = std::max(end_row_, to);
  int covered = 0;
  std::uint32_t* pixel = pixels_.data() + stride_ * static_cast<std::size_t>(from) + x;
  for (int y = from; y < to; ++y, pixel += stride_) {
    covered += std::exchange(changes_[static_cast<std::size_t>(y)], 0);
    *pixel =
        covered == kFullPixel ? color : Blend(*pixel, color, static_cast<std::uint32_t>(covered));
  }
  changes_[static_cast<std::size_t>(to)] = 0;
}

void SpanRaster::paint(QPainter& painter, const QPointF& top_left,
                       double device_pixel_ratio) const {
  if (first_row_ >= end_row_) return;
  const QRect rows(0, first_row_, size_.width(), end_row_ - first_row_);
  painter.save();
  // Copies pixel by pixel, without scaling.
  painter.scale(1 / device_pixel_ratio, 1 / device_pixel_ratio);
  painter.drawImage(top_left * device_pixel_ratio + rows.topLeft(), image(), rows);
  painter.restore();
}

QImage SpanRaster::image() const {
  return {reinterpret_cast<const uchar*>(pixels_.data()), size_.width(), size_.height(),
          static_cast<qsizetype>(stride_ * sizeof(std::uint32_t)),
          QImage::Format_ARGB32_Premultiplied};
}

}  // namespace tendon::gui
