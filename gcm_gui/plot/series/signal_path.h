#pragma once

#include <QList>
#include <QString>

class QMimeData;

namespace tendon::gui {

/// The signal of a curve: a path such as `robot/arm/state.Joints.position[0]`, and its unit.
struct CurveKey {
  QString path;
  QString unit;

  bool operator==(const CurveKey&) const = default;
};

/// Returns the state table of a signal: `robot/arm/state`.
[[nodiscard]] QString SourceOf(const QString& path);
/// Returns the name of a signal in a legend: `arm.Joints.position[0]`.
[[nodiscard]] QString ShortName(const QString& path);
/// Returns the column of a signal: `Joints`.
[[nodiscard]] QString ColumnOf(const QString& path);

/// The MIME type of dragged values: one line for each value, with path and unit separated by a tab.
inline constexpr auto kPathMimeType = "application/x-tendon-path";
/// The MIME type for the id of a plot, in digits. A drag has it if the values come from a plot.
inline constexpr auto kPlotMimeType = "application/x-tendon-plot";
[[nodiscard]] QByteArray EncodedPaths(const QList<CurveKey>& keys);
/// Returns the dragged values; empty if there are none. Lines without a path are skipped.
[[nodiscard]] QList<CurveKey> PathsIn(const QMimeData& data);

}  // namespace tendon::gui
