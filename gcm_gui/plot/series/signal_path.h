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

/// The state table of a signal: `robot/arm/state`.
[[nodiscard]] QString SourceOf(const QString& path);
/// The name in a legend: `arm.Joints.position[0]`.
[[nodiscard]] QString ShortName(const QString& path);
/// The column of a signal: `Joints`.
[[nodiscard]] QString ColumnOf(const QString& path);

/// The MIME type of dragged values: one per line, path and unit separated by a tab.
inline constexpr auto kPathMimeType = "application/x-tendon-path";
/// The MIME type for the id of the source plot, in digits; added when values are dragged out of a
/// plot.
inline constexpr auto kPlotMimeType = "application/x-tendon-plot";
[[nodiscard]] QByteArray EncodedPaths(const QList<CurveKey>& keys);
/// Empty if there are none. Skips lines without a path.
[[nodiscard]] QList<CurveKey> PathsIn(const QMimeData& data);

}  // namespace tendon::gui
