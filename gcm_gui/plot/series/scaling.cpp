#include <gcm_gui/plot/series/scaling.h>

#include <gcm_gui/language/words.h>

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

// Beyond these limits, the sum of value and offset would consist only of rounding errors.
constexpr double kMinFactor = 1e-12;
constexpr double kMaxFactor = 1e12;
constexpr double kMaxOffset = 1e15;

}  // namespace

QString ExactText(double value) {
  const QString brief = QString::number(value, 'g', 15);
  return brief.toDouble() == value ? brief
                                   : QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString TextOf(const Scaling& scaling) {
  QStringList parts;
  if (scaling.factor != 1) parts << QStringLiteral("×") + ExactText(scaling.factor);
  if (scaling.offset != 0) parts << (scaling.offset > 0 ? "+" : "") + ExactText(scaling.offset);
  return parts.join(' ');
}

QString UnitOf(const QString& unit, const Scaling& scaling) {
  return QStringList{unit, TextOf(scaling)}.join(' ').trimmed();
}

std::optional<QString> RefusalOf(const CurveLook& look) {
  const auto& [factor, offset] = look.scaling;
  if (factor == 0) return Words::tr("A scale of 0 would draw a flat line: choose another scale");
  if (!(std::abs(factor) >= kMinFactor && std::abs(factor) <= kMaxFactor)) {
    return Words::tr("The scale must lie between %1 and %2, with either sign")
        .arg(QString::number(kMinFactor), QString::number(kMaxFactor));
  }
  if (!(std::abs(offset) <= kMaxOffset)) {
    return Words::tr("The offset must lie between -%1 and %1").arg(QString::number(kMaxOffset));
  }
  if (look.axis.size() > kLongestAxis) {
    return Words::tr("The name of an axis has at most %1 letters").arg(kLongestAxis);
  }
  const bool is_printable = std::all_of(look.axis.begin(), look.axis.end(),
                                        [](QChar letter) { return letter.isPrint(); });
  if (!is_printable)
    return Words::tr("The name of an axis must be one line without control characters");
  return std::nullopt;
}

std::optional<double> NumberIn(const QString& text) {
  bool is_number = false;
  const double value = text.trimmed().toDouble(&is_number);
  if (!is_number || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace tendon::gui
