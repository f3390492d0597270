#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QTimer>

namespace tendon::gui {

class MainWindow;

/// A diagnostic for tests that drive the real program with a real mouse. Writes a JSON file with
/// the positions of objects on the screen and the state of the window. The file is written only
/// after changes, and at most five times a second.
///
///     window, widgets   rectangles [x, y, width, height] by object name; a tab is `name/title`
///     rows              of the catalogue, by path
///     nodes, ports      of the graph, by path; a port is its disc, with `role` and `number`
///     candidates        of the connect mode, in the list, by path
///     facts             of the GCM, processes, connections, curves, selection, connect mode,
///                       recording, replay (only in a window that shows a recording)
class UiDescription : public QObject {
  Q_OBJECT

 public:
  UiDescription(MainWindow& window, const QString& file);

 private:
  void write();
  [[nodiscard]] QJsonObject widgets() const;
  [[nodiscard]] QJsonObject rows() const;
  [[nodiscard]] QJsonObject nodes() const;
  [[nodiscard]] QJsonObject ports() const;
  [[nodiscard]] QJsonObject candidates() const;
  [[nodiscard]] QJsonObject facts() const;

  MainWindow& window_;
  QString file_;
  QByteArray written_;
  QTimer timer_;
};

}  // namespace tendon::gui
