#pragma once

#include <tendon/recording/recorder.h>

#include <QString>
#include <QStringList>
#include <cstdint>

namespace tendon::gui {

struct RecordingProgress;

/// Returns the length of a recording as text: "0:07", "12:30", "1:02:05".
[[nodiscard]] QString LengthText(double seconds);

/// Returns a size as text, with powers of 1000: "1.2 MB".
[[nodiscard]] QString BytesText(std::uint64_t bytes);

/// Returns one line for each table and event with losses. The line names the places of the losses:
/// "robot/arm/state: 12 rows lost in its process, 3 in this window, because the disk was too slow".
[[nodiscard]] QStringList LossLines(const recording::Losses& losses);

/// Returns a sentence if the disk will soon be full; otherwise an empty text.
[[nodiscard]] QString DiskWarning(const RecordingProgress& progress);

}  // namespace tendon::gui
