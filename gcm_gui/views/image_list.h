#pragma once

#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/session/signal_source.h>

#include <QMap>
#include <QSet>
#include <QString>
#include <QWidget>

namespace tendon::gui {

class ImageView;

/// Shows the newest pictures of the columns of one component, one below another. Hidden if there
/// are none.
class ImageList : public QWidget {
  Q_OBJECT

 public:
  explicit ImageList(QWidget* parent = nullptr);

  /// Sets the columns whose pictures are shown from now on.
  void setColumns(const QSet<QString>& columns);
  /// Sets the reason why the pictures are old. It is shown below each picture.
  void setStandstill(StaleReason why);

 public Q_SLOTS:
  void showValues(const QString& column, const tendon::gui::ColumnValues& values);

 private:
  QSet<QString> columns_;
  QString still_;
  QMap<QString, ImageView*> views_;
};

}  // namespace tendon::gui
