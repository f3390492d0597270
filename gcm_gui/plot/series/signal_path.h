#pragma once

#include <QList>
#include <QString>

class QMimeData;

namespace tendon::gui {

/// What a curve shows: a path such as `robot/arm/state.Joints.position[0]`, and its unit.
struct CurveKey {
  QString path;
  QString unit;

  bool operator==(const CurveKey&) const = default;
};

/// The state table whose rows a signal comes with: `robot/arm/state`.
[[nodiscard]] QString SourceOf(const QString& path);
/// What a legend needs: `arm.Joints.position[0]`.
[[nodiscard]] QString ShortName(const QString& path);
/// The column: `Joints`.
[[nodiscard]] QString ColumnOf(const QString& path);

/// Dragged values: one a line, path and unit separated by a tabulator.
inline constexpr auto kPathMimeType = "application/x-tendon-path";
/// With them, when they are dragged out of a plot: its id, in digits.
inline constexpr auto kPlotMimeType = "application/x-tendon-plot";
[[nodiscard]] QByteArray EncodedPaths(const QList<CurveKey>& keys);
/// Empty when there are none. Lines without a path are left out.
[[nodiscard]] QList<CurveKey> PathsIn(const QMimeData& data);

}  // namespace tendon::gui
