#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/reports/counts_text.h>

#include <chrono>

namespace tendon::gui {

QStringList CountsLines(const ConnectionCounts& counts) {
  QStringList lines{Words::tr("stands for ") + AgeText(counts.age.count())};
  if (counts.round_trip.count() >= 0) {
    const double seconds = std::chrono::duration<double>(counts.round_trip).count();
    lines << Words::tr("round trip ") + DurationText(seconds);
  }
  lines << Words::tr("%1 calls and events").arg(counts.taken);
  if (counts.capacity > 0) {
    lines << Words::tr("%1 of %2 wait").arg(counts.waiting).arg(counts.capacity);
  }
  lines << Words::tr("%1 refused, %2 replaced, %3 events lost")
               .arg(counts.refused)
               .arg(counts.replaced)
               .arg(counts.lost_events);
  return lines;
}

}  // namespace tendon::gui
