#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/legend/legend_entries.h>
#include <gcm_gui/plot/rate_badge.h>
#include <gcm_gui/plot/series/statistics.h>

#include <QString>

namespace tendon::gui {
namespace {

constexpr int kFigure = 8;  // characters of a number of the statistics
constexpr int kLogarithmicDigits = 5;

// On a logarithmic axis digits count from the first one, whatever the size.
QString TextOf(double value, const CurveSet& curves, const Curve& curve) {
  if (curves.scale() == ValueScale::kLogarithmic) {
    return QString::number(value, 'g', kLogarithmicDigits);
  }
  return LegendValue(value, curves.axisOf(curve).range);
}

QString FiguresOf(const CurveSet& curves, const Curve& curve, const TimeSpan& span) {
  const auto plain = StatisticsOf(curve.samples(), span.from_ns, span.to_ns);
  if (!plain) return {};
  const Statistics found = plain->scaled(curve.scaling());
  const auto text = [&](double value) {
    return TextOf(value, curves, curve).rightJustified(kFigure);
  };
  return Words::tr("min%1  max%2  mean%3  σ%4  rms%5  p-p%6  %7")
      .arg(text(found.lowest), text(found.highest), text(found.mean), text(found.deviation),
           text(found.rms), text(found.span()), RateText(found.rate));
}

}  // namespace

std::vector<LegendEntry> LegendEntriesOf(const CurveSet& curves, std::optional<std::int64_t> at_ns,
                                         std::optional<TimeSpan> statistics) {
  std::vector<LegendEntry> entries;
  for (const auto& curve : curves.curves()) {
    const std::optional<double> value = at_ns ? curve->valueAt(*at_ns) : curve->latestValue();
    const bool stale = curve->isStale() && !at_ns;
    entries.push_back({.path = curve->path(),
                       .name = stale ? ShortName(curve->path()) + " · " + curve->staleReason()
                                     : ShortName(curve->path()),
                       .value = value && !stale ? TextOf(*value, curves, *curve) : QString(),
                       .unit = stale ? QString() : curve->shownUnit(),
                       .color_index = curve->colorIndex(),
                       .stale = stale,
                       .shown = curve->isVisible(),
                       .figures = statistics ? FiguresOf(curves, *curve, *statistics) : QString()});
  }
  return entries;
}

}  // namespace tendon::gui
