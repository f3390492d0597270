#include <gcm_gui/plot/controls/legend_entries.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/controls/rate_badge.h>
#include <gcm_gui/plot/series/sample_statistics.h>
#include <gcm_gui/plot/series/time_shift.h>

#include <QString>
#include <QStringList>

namespace tendon::gui {
namespace {

constexpr int kFigure = 8;  // characters of each number in the statistics
constexpr int kLogarithmicDigits = 5;

// For a curve with states, returns the share of the samples in each state.
QString SharesOf(const Curve& curve, const TimeSpan& span) {
  constexpr double kPercent = 100;
  const SampleRing& samples = curve.samples();
  const std::uint64_t count = samples.lowerBound(span.to_ns + 1) - samples.lowerBound(span.from_ns);
  if (count == 0) return {};
  QStringList shares;
  for (const auto& [value, times] : OccurrencesOf(samples, span.from_ns, span.to_ns)) {
    const double share = kPercent * static_cast<double>(times) / static_cast<double>(count);
    shares << QStringLiteral("%1 %2 %").arg(curve.names()->textOf(ExactNumber::Signed(value)),
                                            QString::number(share, 'f', 1));
  }
  shares << RateText(RateOf(samples, span.from_ns, span.to_ns));
  return shares.join(QStringLiteral("  "));
}

QString FiguresOf(const CurveSet& curves, const Curve& curve, const TimeSpan& span) {
  if (curve.names() != nullptr) return SharesOf(curve, span);
  const auto plain = StatisticsOf(curve.samples(), span.from_ns, span.to_ns);
  if (!plain) return {};
  const SampleStatistics found = plain->scaled(curve.scaling());
  const auto text = [&](const ExactNumber& number) {
    return ' ' + NumberOf(number, curve, curves).rightJustified(kFigure - 1);
  };
  return Words::tr("min%1  max%2  mean%3  σ%4  rms%5  p-p%6  %7")
      .arg(text(found.lowest), text(found.highest), text(found.mean), text(found.deviation),
           text(found.rms), text(found.span()), RateText(found.rate));
}

}  // namespace

QString NumberOf(const ExactNumber& number, const Curve& curve, const CurveSet& curves) {
  if (curve.names() != nullptr) return curve.names()->textOf(number);
  if (number.isInteger()) return number.text();
  // On a logarithmic axis, the number of significant digits is fixed.
  if (curves.scale() == ValueScale::kLogarithmic) {
    return QString::number(number.nearest(), 'g', kLogarithmicDigits);
  }
  const UnitAxis& axis = curves.axisOf(curve);
  const double factor = axis.frame.factor();
  return LegendValue(number.nearest(),
                     {.low = axis.range.low / factor, .high = axis.range.high / factor});
}

std::vector<LegendEntry> LegendEntriesOf(const CurveSet& curves, std::optional<std::int64_t> at_ns,
                                         const TimeSpan& seen, bool statistics) {
  std::vector<LegendEntry> entries;
  for (const auto& curve : curves.curves()) {
    // Samples of a recording beyond the visible time were read in advance.
    const auto value = at_ns                 ? curve->numberAt(*at_ns)
                       : curve->isRecorded() ? curve->numberAt(seen.to_ns)
                                             : curve->latestNumber();
    const bool stale = curve->isStale() && !at_ns;
    const bool old = curve->isStandingStill() && !at_ns;
    const bool is_waited_for = stale && (!old || curve->samples().empty());
    const QString why = is_waited_for ? curve->staleReason()
                        : old         ? curve->standstill()
                                      : QString();
    QStringList name{ShortName(curve->path())};
    if (curve->isRecorded()) name << RoundedShiftText(curve->shift());
    if (!why.isEmpty()) name << why;
    entries.push_back({.path = curve->path(),
                       .recording = RecordingName(curve->path()),
                       .name = name.join(QStringLiteral(" · ")),
                       .value = value && !stale ? NumberOf(*value, *curve, curves) : QString(),
                       .unit = stale || curve->names() != nullptr ? QString() : curve->shownUnit(),
                       .color_index = curve->colorIndex(),
                       .stale = stale,
                       .old = old,
                       .shown = curve->isVisible(),
                       .figures = statistics ? FiguresOf(curves, *curve, seen) : QString()});
  }
  return entries;
}

}  // namespace tendon::gui
