#include <gcm_gui/recording/recording_words.h>

#include <gcm_console/output/recording_text.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/series/row_losses.h>
#include <gcm_gui/recording/recording_runner.h>

#include <cmath>

namespace tendon::gui {
namespace {

constexpr std::uint64_t kLittleSpace = 500'000'000;  // bytes
constexpr double kShortWhile = 600.0;                // s until the disk is full

}  // namespace

QString LengthText(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds);
  const auto two = [](std::int64_t number) {
    return QStringLiteral("%1").arg(number, 2, 10, QChar('0'));
  };
  const QString rest = ':' + two(whole % 60);
  const std::int64_t minutes = whole / 60;
  if (minutes < 60) return QString::number(minutes) + rest;
  return QString::number(minutes / 60) + ':' + two(minutes % 60) + rest;
}

QString BytesText(std::uint64_t bytes) { return ToQString(console::SizeText(bytes)); }

QStringList LossLines(const recording::Losses& losses) {
  QStringList lines;
  for (const auto& [path, lost] : losses.rows) {
    if (lost.all() == 0) continue;
    const QString places =
        LossPlaces({.table = lost.table, .network = lost.network, .viewer = lost.viewer},
                   Words::tr("%1 in this window, because the disk was too slow"));
    lines << Words::tr("%1: rows lost: %2").arg(ToQString(path), places);
  }
  for (const auto& [path, lost] : losses.events) {
    if (lost > 0) lines << Words::tr("%1: events lost: %2").arg(ToQString(path)).arg(lost);
  }
  if (losses.log > 0) lines << Words::tr("Records of the log lost: %1").arg(losses.log);
  return lines;
}

QString DiskWarning(const RecordingProgress& progress) {
  const std::uint64_t left = progress.status.disk_free;
  const double seconds = progress.rate > 0 ? static_cast<double>(left) / progress.rate : HUGE_VAL;
  if (left >= kLittleSpace && seconds >= kShortWhile) return {};
  if (seconds >= kShortWhile) return Words::tr("The disk is almost full.");
  return Words::tr("At this rate, the disk is full in %1 (minutes and seconds).")
      .arg(LengthText(seconds));
}

}  // namespace tendon::gui
