#include <gcm_console/output/curve_picture.h>

#include <gcm_console/output/table.h>
#include <gcm_console/output/text.h>
#include <tendon/payload/numeric_axis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace console {
namespace {

constexpr int kFewestColumns = 8;  // minimum width of a curve, in characters
// The minimum width of the scale beside a curve, including the gap.
constexpr std::size_t kFewestMargin = 12;
constexpr std::size_t kScaleGap = 2;  // characters
constexpr int kRowsOfALabel = 3;      // one label for about this many rows

/// A curve together with its scale.
struct Drawing {
  const NumberCurve& curve;
  tendon::NumericAxis axis;
};

tendon::NumericAxis AxisOf(const NumberCurve& curve, int most_labels) {
  std::vector<tendon::NumericValue> values;
  for (const auto& sample : curve.samples) {
    if (sample.value) values.push_back(*sample.value);
  }
  return tendon::NumericAxis::Fitted(curve.schema, values, most_labels);
}

std::string Aligned(const std::string& text, std::size_t width) {
  return std::string(width - std::min(text.size(), width), ' ') + text +
         std::string(kScaleGap, ' ');
}

/// Returns the width of the scale. It is the same for all curves, so that they are aligned.
std::size_t MarginOf(const std::vector<Drawing>& drawings) {
  std::size_t widest = kFewestMargin - kScaleGap;
  for (const Drawing& drawing : drawings) {
    for (const auto& label : drawing.axis.labels()) widest = std::max(widest, label.text.size());
  }
  return widest;
}

/// Returns the label beside each row. If labels overlap, the outer ones are kept.
std::vector<std::string> TextsOf(const tendon::NumericAxis& axis, int height) {
  std::vector<std::string> texts(static_cast<std::size_t>(height) / 4);
  const auto& labels = axis.labels();
  const auto put = [&](const tendon::NumericAxis::Label& label) {
    const auto row = static_cast<std::size_t>(std::lround((1.0 - label.part) * (height - 1))) / 4;
    if (texts[row].empty()) texts[row] = Plain(label.text);
  };
  if (!labels.empty()) put(labels.back());
  for (const auto& label : labels) put(label);
  return texts;
}

BrailleCanvas CanvasOf(const Drawing& drawing, double window, int columns, int rows) {
  BrailleCanvas canvas(columns, rows);
  const auto& samples = drawing.curve.samples;
  const bool is_stepped = IsStepped(drawing.curve.schema);
  struct Dot {
    int x = 0;
    int y = 0;
  };
  Dot before;
  bool has_before = false;
  for (const auto& sample : samples) {
    const auto part = sample.value ? drawing.axis.PartOf(*sample.value) : std::nullopt;
    if (!part) {
      has_before = false;
      continue;
    }
    const double since = samples.back().time - sample.time;
    const double age = since < window ? since / window : 1.0;
    const Dot dot{.x = canvas.width() - 1 - static_cast<int>(age * (canvas.width() - 1)),
                  .y = static_cast<int>(std::lround((1.0 - *part) * (canvas.height() - 1)))};
    if (!has_before) before = dot;
    if (is_stepped) {
      canvas.Line(before.x, before.y, dot.x, before.y);
      before.x = dot.x;
    }
    canvas.Line(before.x, before.y, dot.x, dot.y);
    before = dot;
    has_before = true;
  }
  return canvas;
}

/// Returns the title with the newest value: "robot/arm/state.Joints.position[0] = 0.25 rad".
std::string TitleOf(const NumberCurve& curve) {
  if (curve.samples.empty()) return curve.title + "  no values yet";
  const auto& newest = curve.samples.back().value;
  if (!newest) return curve.title + "  no value now";
  return curve.title + " = " + Plain(ToString(curve.schema, *newest)) +
         (curve.unit.empty() ? "" : " " + Plain(curve.unit));
}

}  // namespace

BrailleCanvas::BrailleCanvas(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      cells_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0U) {}

void BrailleCanvas::Set(int x, int y) {
  // The bits of the dots in Unicode: first the upper three dots of the left column, then the upper
  // three dots of the right column, then the lowest two dots.
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

std::string PictureOf(const std::vector<NumberCurve>& curves, double window, int columns,
                      int rows) {
  const int share = curves.empty() ? 0 : (rows - 1) / static_cast<int>(curves.size()) - 1;
  const int each = std::max(share, kFewestCurveRows);
  std::vector<Drawing> drawings;
  for (const NumberCurve& curve : curves) {
    drawings.push_back({curve, AxisOf(curve, std::max(each / kRowsOfALabel, 1))});
  }
  const std::size_t margin = MarginOf(drawings);
  const int left = std::max(columns - static_cast<int>(margin + kScaleGap), kFewestColumns);
  std::ostringstream picture;
  for (const Drawing& drawing : drawings) {
    picture << TitleOf(drawing.curve) << '\n';
    if (drawing.curve.samples.empty()) continue;
    const BrailleCanvas canvas = CanvasOf(drawing, window, left, each);
    const auto texts = TextsOf(drawing.axis, canvas.height());
    for (int row = 0; row < each; ++row) {
      picture << Aligned(texts[static_cast<std::size_t>(row)], margin) << canvas.Row(row) << '\n';
    }
  }
  const std::string from = "-" + Short(window) + " s";
  const int gap = left - static_cast<int>(from.size()) - 3;
  picture << std::string(margin + kScaleGap, ' ') << from
          << std::string(static_cast<std::size_t>(std::max(gap, 1)), ' ') << "now\n";
  return picture.str();
}

}  // namespace console
