#include <gcm_gui/plot/canvas/gap_bands.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_scale_map.h>

#include <QFontMetricsF>
#include <QPainter>
#include <QSet>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr double kGapLayer = 15;  // above the grid, below the curves
constexpr double kNarrowest = 2;
constexpr double kTint = 0.16;
constexpr double kHatch = 0.5;
constexpr double kSilentTint = 0.10;
constexpr double kSilentHatch = 0.3;
constexpr double kLabelSpace = 8;

QString GapText(std::uint64_t lost, bool is_standstill) {
  if (lost > 0) return QString::number(lost) + Words::tr(" lost");
  return is_standstill ? Words::tr("did not run") : Words::tr("restarted");
}

}  // namespace

GapBands::GapBands(const CurveSet& curves, const TimeWindow& window)
    : curves_(curves), window_(window) {
  setZ(kGapLayer);
  setItemAttribute(Legend, false);
  setItemAttribute(AutoScale, false);
}

void GapBands::draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap&,
                    const QRectF& canvas_rect) const {
  const Theme& theme = Theme::instance();
  QSet<QString> sources;  // handled already; all columns of a table have the same gaps
  for (const auto& curve : curves_.curves()) {
    const QString source = SourceOf(curve->path());
    // A band over the whole height would look like a gap of the live curves.
    if (curve->isRecorded()) continue;
    if (curve->samples().empty() || !curve->isVisible() || sources.contains(source)) continue;
    sources << source;
    const std::vector<Band> bands = bandsOf(*curve, x_map, canvas_rect);
    for (const Band& band : bands) {
      const QRectF rect(band.left, canvas_rect.top(), band.right - band.left, canvas_rect.height());
      const Token token = band.lost > 0 ? Token::kBad : Token::kStale;
      painter->fillRect(rect & canvas_rect, theme.color(token, kTint));
      painter->fillRect(rect & canvas_rect, QBrush(theme.color(token, kHatch), Qt::BDiagPattern));
    }
    drawLabels(*painter, bands, canvas_rect);
    if (!curve->isSilent()) continue;
    const SampleRing& samples = curve->samples();
    const double silent_since = x_map.transform(
        static_cast<double>(samples.time(samples.endIndex() - 1) - window_.origin()) / 1e9);
    const QRectF silence(QPointF(silent_since, canvas_rect.top()), canvas_rect.bottomRight());
    if (silence.width() > 0) {
      painter->fillRect(silence & canvas_rect, theme.color(Token::kStale, kSilentTint));
      painter->fillRect(silence & canvas_rect,
                        QBrush(theme.color(Token::kStale, kSilentHatch), Qt::BDiagPattern));
    }
  }
}

// Returns the bands; bands that would touch each other are merged.
std::vector<GapBands::Band> GapBands::bandsOf(const Curve& curve, const QwtScaleMap& x_map,
                                              const QRectF& rect) const {
  const auto x_of = [&](std::int64_t time_ns) {
    return x_map.transform(static_cast<double>(time_ns - window_.origin()) / 1e9);
  };
  std::vector<Band> bands;
  for (const Gap& gap : curve.samples().gaps()) {
    // The rows have arrived, and only the curve is interrupted. Therefore, there is no band.
    if (gap.cause == Gap::Cause::kNoValue) continue;
    Band band{.left = x_of(gap.from_ns),
              .right = x_of(gap.to_ns),
              .lost = gap.lost,
              .is_standstill = gap.cause == Gap::Cause::kStandstill};
    if (band.right < rect.left()) continue;
    if (band.left > rect.right()) break;
    band.right = std::max(band.right, band.left + kNarrowest);
    if (!bands.empty() && band.left < bands.back().right + 1) {
      bands.back().right = band.right;
      bands.back().lost += band.lost;
      bands.back().is_standstill = bands.back().is_standstill && band.is_standstill;
    } else {
      bands.push_back(band);
    }
  }
  return bands;
}

// Draws the labels. Overlapping labels become one, with the sum of the lost rows.
void GapBands::drawLabels(QPainter& painter, const std::vector<Band>& bands,
                          const QRectF& rect) const {
  std::vector<Band> labels;
  const QFontMetricsF metrics(Theme::instance().small());
  const auto half_width = [&](const Band& band) {
    return (metrics.horizontalAdvance(GapText(band.lost, band.is_standstill)) + kLabelSpace) / 2;
  };
  const auto centre = [](const Band& band) { return (band.left + band.right) / 2; };
  for (const Band& band : bands) {
    if (!labels.empty() &&
        centre(band) - centre(labels.back()) < half_width(band) + half_width(labels.back())) {
      labels.back().right = band.right;
      labels.back().lost += band.lost;
      labels.back().is_standstill = labels.back().is_standstill && band.is_standstill;
    } else {
      labels.push_back(band);
    }
  }
  painter.save();
  painter.setFont(Theme::instance().small());
  for (const Band& label : labels) {
    painter.setPen(Theme::instance().color(label.lost > 0 ? Token::kBad : Token::kDim));
    const double width = 2 * half_width(label);
    const double left = std::clamp(centre(label) - width / 2, rect.left(),
                                   std::max(rect.left(), rect.right() - width));
    painter.drawText(QRectF(left, rect.top() + 2, width, metrics.height()), Qt::AlignCenter,
                     GapText(label.lost, label.is_standstill));
  }
  painter.restore();
}

}  // namespace tendon::gui
