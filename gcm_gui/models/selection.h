#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

namespace tendon::gui {

/// The selected paths, shared by all views: tree, graph, tables and inspector. A path stays
/// selected even while its object does not exist. GUI thread.
class Selection : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// The selected paths in the order of selection. The last one is the current one.
  [[nodiscard]] const QStringList& paths() const { return paths_; }
  [[nodiscard]] QString current() const { return paths_.isEmpty() ? QString() : paths_.last(); }
  [[nodiscard]] bool contains(const QString& path) const { return paths_.contains(path); }

 public Q_SLOTS:
  void select(const QString& path) { setPaths(path.isEmpty() ? QStringList() : QStringList(path)); }
  void setPaths(const QStringList& paths) {
    if (paths == paths_) return;
    paths_ = paths;
    Q_EMIT changed(paths_);
  }
  void clear() { setPaths({}); }

 Q_SIGNALS:
  void changed(const QStringList& paths);

 private:
  QStringList paths_;
};

}  // namespace tendon::gui
