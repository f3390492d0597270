#pragma once

#include <tendon/recording/recorder.h>

#include <QString>
#include <QStringList>
#include <cstdint>

namespace tendon::gui {

struct RecordingProgress;

/// The length of a recording from seconds: "0:07", "12:30", "1:02:05".
[[nodiscard]] QString LengthText(double seconds);

/// "1.2 MB", powers of 1000.
[[nodiscard]] QString BytesText(std::uint64_t bytes);

/// A line for each table and event with losses, which says where they occurred: "robot/arm/state:
/// 12 rows lost in its process, 3 in this window, because the disk was too slow".
[[nodiscard]] QStringList LossLines(const recording::Losses& losses);

/// A sentence if the disk will soon be full, otherwise empty.
[[nodiscard]] QString DiskWarning(const RecordingProgress& progress);

}  // namespace tendon::gui
