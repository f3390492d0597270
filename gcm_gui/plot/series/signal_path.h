#pragma once

#include <QList>
#include <QString>
#include <cstdint>
#include <optional>

class QMimeData;

namespace tendon::gui {

/// The signal of a curve: a path such as `robot/arm/state.Joints.position[0]`, and its unit. If the
/// curve shows a recording beside the shown system, the path is a RecordedPath().
struct CurveKey {
  QString path;
  QString unit;

  bool operator==(const CurveKey&) const = default;
};

/// Returns the path of a signal in a recording: `/home/ann/run.mcap//robot/arm/state.Joints`. No
/// path of a signal contains `//`.
[[nodiscard]] QString RecordedPath(const QString& file, const QString& signal);
/// Returns the absolute path of the file of a recorded signal; empty for a signal of the shown
/// system.
[[nodiscard]] QString RecordingOf(const QString& path);
/// Returns the name of the file of a recorded signal: `run.mcap`.
[[nodiscard]] QString RecordingName(const QString& path);
/// Returns the path without the recording: `robot/arm/state.Joints`.
[[nodiscard]] QString SignalOf(const QString& path);

/// Returns the state table of a signal: `robot/arm/state`.
[[nodiscard]] QString SourceOf(const QString& path);
/// Returns the name of a signal in a legend, without its recording: `arm.Joints.position[0]`.
[[nodiscard]] QString ShortName(const QString& path);
/// Returns a path for people: `run.mcap · robot/arm/state.Joints.position[0]`.
[[nodiscard]] QString FullName(const QString& path);
/// Returns the column of a signal: `Joints`.
[[nodiscard]] QString ColumnOf(const QString& path);

/// The MIME type of dragged values: one line for each value, with path and unit separated by a tab.
inline constexpr auto kPathMimeType = "application/x-tendon-path";
/// The MIME type for the id of a plot, in digits. A drag of values from a plot has this type.
inline constexpr auto kPlotMimeType = "application/x-tendon-plot";
/// The MIME type for the recording of dragged values: one line with the shown moment in ns since
/// 1970, and one line with the file. Drags from a window that shows a recording have it.
inline constexpr auto kRecordingMimeType = "application/x-tendon-recording";
[[nodiscard]] QByteArray EncodedPaths(const QList<CurveKey>& keys);
/// Sets `data` to a drag of these values of the shown system.
void SetPaths(QMimeData& data, const QList<CurveKey>& keys);
/// Returns the dragged values; empty if there are none. Lines without a path are skipped. Values
/// that come from the window of another recording have recorded paths.
[[nodiscard]] QList<CurveKey> PathsIn(const QMimeData& data);
/// If the dragged values come from the window of another recording, returns the moment that this
/// window shows, in ns since 1970.
[[nodiscard]] std::optional<std::int64_t> RecordedMomentIn(const QMimeData& data);

}  // namespace tendon::gui
