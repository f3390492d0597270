#pragma once

#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/session/signal_source.h>

#include <QMap>
#include <QSet>
#include <QString>
#include <QWidget>

namespace tendon::gui {

class ImageView;

/// The newest pictures in the columns of one component, below each other; hidden if there are none.
class ImageList : public QWidget {
  Q_OBJECT

 public:
  explicit ImageList(QWidget* parent = nullptr);

  /// From now on, shows only these columns.
  void setColumns(const QSet<QString>& columns);
  /// The reason why the pictures are old, shown below each.
  void setStandstill(StaleReason why);

 public Q_SLOTS:
  void showValues(const QString& column, const tendon::gui::ColumnValues& values);

 private:
  QSet<QString> columns_;
  QString still_;
  QMap<QString, ImageView*> views_;
};

}  // namespace tendon::gui
