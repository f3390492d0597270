#include <gcm_gui/plot/series/time_shift.h>

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <array>

namespace tendon::gui {
namespace {

constexpr std::int64_t kOneMillisecond = 1'000'000;
constexpr std::int64_t kOneSecond = 1'000'000'000;
constexpr std::int64_t kOneMinute = 60 * kOneSecond;
constexpr std::int64_t kOneHour = 60 * kOneMinute;
constexpr std::int64_t kOneDay = 24 * kOneHour;
constexpr int kSecondDecimals = 9;  // of a second
constexpr QChar kMinus(0x2212);

QString SecondsText(std::int64_t ns) {
  QString text = QString::number(qlonglong{ns / kOneSecond});
  QString fraction =
      QString::number(qlonglong{ns % kOneSecond}).rightJustified(kSecondDecimals, '0');
  while (fraction.endsWith('0')) fraction.chop(1);
  return fraction.isEmpty() ? text : text + '.' + fraction;
}

}  // namespace

QString ShiftText(std::int64_t shift_ns) {
  if (shift_ns == 0) return QStringLiteral("0 s");
  std::int64_t rest =
      std::min(shift_ns < 0 ? -std::max(shift_ns, -kLongestShift) : shift_ns, kLongestShift);
  QStringList parts;
  const auto add = [&](std::int64_t unit, const char* name, int digits) {
    const std::int64_t count = rest / unit;
    if (count == 0 && parts.isEmpty()) return;
    rest %= unit;
    const QString number = QString::number(qlonglong{count});
    parts << (parts.isEmpty() ? number : number.rightJustified(digits, '0')) + ' ' + name;
  };
  add(kOneDay, "d", 1);
  add(kOneHour, "h", 1);
  add(kOneMinute, "min", 2);
  if (rest > 0 || parts.isEmpty()) parts << SecondsText(rest) + QStringLiteral(" s");
  return (shift_ns < 0 ? kMinus : QChar('+')) + parts.join(' ');
}

QString RoundedShiftText(std::int64_t shift_ns) {
  const std::int64_t half = shift_ns < 0 ? -kOneMillisecond / 2 : kOneMillisecond / 2;
  return ShiftText(MovedTime(shift_ns, half) / kOneMillisecond * kOneMillisecond);
}

std::optional<std::int64_t> ShiftIn(const QString& text) {
  // Each number has few enough digits that its product with the unit does not overflow.
  static const QRegularExpression form(
      QStringLiteral("^([-+−]?)\\s*(?:(\\d{1,5})\\s*d)?\\s*(?:(\\d{1,6})\\s*h)?\\s*"
                     "(?:(\\d{1,8})\\s*min)?\\s*(?:(\\d{1,10})(?:\\.(\\d{0,9}))?\\s*s?)?$"));
  const QRegularExpressionMatch match = form.match(text.trimmed());
  if (!match.hasMatch()) return std::nullopt;
  constexpr std::array kUnits{kOneDay, kOneHour, kOneMinute, kOneSecond};
  std::int64_t shift = 0;
  bool has_number = false;
  for (std::size_t i = 0; i < kUnits.size(); ++i) {
    const QString number = match.captured(static_cast<int>(i) + 2);
    has_number = has_number || !number.isEmpty();
    if (number.toLongLong() > kLongestShift / kUnits.at(i)) return std::nullopt;
    shift = MovedTime(shift, number.toLongLong() * kUnits.at(i));
  }
  shift = MovedTime(shift, match.captured(6).leftJustified(kSecondDecimals, '0').toLongLong());
  if (!has_number || shift > kLongestShift) return std::nullopt;
  const QString sign = match.captured(1);
  return sign == QStringLiteral("-") || sign == kMinus ? -shift : shift;
}

}  // namespace tendon::gui
