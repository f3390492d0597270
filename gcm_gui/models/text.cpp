#include <gcm_gui/models/text.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <tendon/gcm/staleness.h>

#include <QDateTime>
#include <chrono>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kLastExact = 1e15;  // a double can represent every integer up to this limit
constexpr double kMaxPlain = 1e12;   // larger than seconds since 1970, which must stay readable

/// Formats a number with as many decimals as are needed for four digits.
QString FourDigits(double value) {
  const double size = std::abs(value);
  const int decimals = size < 10 ? 3 : size < 100 ? 2 : size < 1000 ? 1 : 0;
  return QString::number(value, 'f', decimals);
}

/// Formats a duration with its unit. The limits between the units are chosen so that rounding never
/// gives 1000 of the smaller unit.
Quantity DurationOf(double seconds) {
  const double size = std::abs(seconds);
  if (size < 999.5e-9) return {QString::number(seconds * 1e9, 'f', 0), QStringLiteral("ns")};
  if (size < 99.95e-6) return {QString::number(seconds * 1e6, 'f', 1), QStringLiteral("µs")};
  if (size < 999.5e-6) return {QString::number(seconds * 1e6, 'f', 0), QStringLiteral("µs")};
  if (size < 0.99995) return {FourDigits(seconds * 1e3), QStringLiteral("ms")};
  return {QString::number(seconds, 'f', 2), QStringLiteral("s")};
}

/// Returns false for states and counts, because they are shown with all digits.
bool IsRounded(const NumericValue& value) {
  return value.is_real() || value.kind() == NumericValue::Kind::kDuration;
}

}  // namespace

QString ToQString(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString ToQString(const InterfaceName& name) { return ToQString(ToString(name)); }

QString NumberText(double value) {
  const double size = std::abs(value);
  if (!std::isfinite(value)) return QString::number(value);
  if (value == std::floor(value) && size < kLastExact) return QString::number(value, 'f', 0);
  if (size >= kMaxPlain) return QString::number(value, 'e', 3);
  if (size >= 1) return FourDigits(value);
  return size >= 0.01 ? QString::number(value, 'f', 4) : QString::number(value, 'g', 4);
}

Quantity QuantityOf(const NumericField& field, const std::optional<NumericValue>& value) {
  const QString unit = ToQString(field.unit);
  if (!value) return {QStringLiteral("–"), unit};
  if (!IsRounded(*value)) return {ToQString(ToString(field.schema, *value)), unit};
  const double real = value->real();
  if (field.unit == "s" && real != 0 && std::abs(real) < 1) return DurationOf(real);
  return {NumberText(real), unit};
}

QString WholeText(const NumericField& field, const std::optional<NumericValue>& value) {
  if (!value || !IsRounded(*value)) return {};
  const Quantity whole{ToQString(ToString(*value)), ToQString(field.unit)};
  const Quantity shown = QuantityOf(field, value);
  if (whole.number == shown.number && whole.unit == shown.unit) return {};
  return whole.unit.isEmpty() ? whole.number : whole.number + ' ' + whole.unit;
}

QString RateOfPeriodText(double period) {
  if (period <= 0) return {};
  const double rate = 1 / period;
  if (rate >= 1000) return QString::number(rate / 1000, 'g', 4) + QStringLiteral(" kHz");
  return QString::number(rate, 'g', 4) + QStringLiteral(" Hz");
}

QString DurationText(double seconds) {
  const auto [number, unit] = DurationOf(seconds);
  return number + ' ' + unit;
}

QString AgeText(std::int64_t nanoseconds) {
  return ToQString(tendon::AgeText(std::chrono::nanoseconds(nanoseconds)));
}

QString ClockText(std::int64_t when) {
  return QDateTime::fromMSecsSinceEpoch(when / 1'000'000).toString(QStringLiteral("HH:mm:ss.zzz"));
}

QString CountText(std::int64_t count, const QString& one, const QString& many) {
  return count == 0 ? QString() : (count == 1 ? one : many).arg(count);
}

QString TypesText(const MemberDescription& member, TypeNames names) {
  const auto name = [names](const std::string& type) {
    if (type == kPayload<None>.name) return QString();
    const QString whole = ToQString(type);
    return names == TypeNames::kWhole ? whole : whole.section('.', -1);
  };
  const QString in = name(member.in_type);
  const QString out = name(member.out_type);
  if (in.isEmpty()) return out;
  return out.isEmpty() ? in : in + QStringLiteral(" → ") + out;
}

QString ExpiryText(const MemberDescription& member) {
  if (member.expires_after <= 0) return {};
  const bool is_short = member.expires_after < 1;
  const QString time = QString::number(member.expires_after * (is_short ? 1000 : 1), 'g', 4);
  return Words::tr("The action ends unless the command is called again within %1")
      .arg(time + (is_short ? QStringLiteral(" ms") : QStringLiteral(" s")));
}

QString ShellWord(QString word) {
  return '\'' + word.replace('\'', QStringLiteral("'\\''")) + '\'';
}

QString CallLine(const QString& path, const QString& json) {
  const QString line = QStringLiteral("gcm call ") + path;
  return json.isEmpty() ? line : line + ' ' + ShellWord(json);
}

std::int64_t WallClock() { return ShownWallTime(); }

QStringList CountsLines(const ConnectionCounts& counts) {
  QStringList lines{Words::tr("connected for ") + AgeText(counts.age.count())};
  if (counts.round_trip.count() >= 0) {
    const double seconds = std::chrono::duration<double>(counts.round_trip).count();
    lines << Words::tr("round trip ") + DurationText(seconds);
  }
  lines << Words::tr("%1 calls and events").arg(counts.taken);
  if (counts.capacity > 0) {
    lines << Words::tr("mailbox: %1 of %2 used").arg(counts.waiting).arg(counts.capacity);
  }
  lines << Words::tr("%1 refused, %2 replaced, %3 events lost")
               .arg(counts.refused)
               .arg(counts.replaced)
               .arg(counts.lost_events);
  return lines;
}

}  // namespace tendon::gui
