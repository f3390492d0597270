#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/connect/connect_mode.h>

#include <QTimer>
#include <QWidget>

namespace tendon::gui {

/// One line above the graph. In connect mode it shows what to do next, otherwise the latest notice.
class NoticeLine : public QWidget {
  Q_OBJECT

 public:
  NoticeLine(const ConnectMode& mode, const ActivityModel& activity, QWidget* parent = nullptr);

  [[nodiscard]] QString text() const { return before_ + path_ + after_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 public Q_SLOTS:
  /// Shows the text for some seconds.
  void showNotice(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();
  void showMode();
  void onActionFinished(const Action& finished);

  const ConnectMode& mode_;
  QString notice_;
  QTimer fade_;
  // The text on the line is `before_`, then the path, then the rest.
  QString before_;
  QString path_;
  QString after_;
};

}  // namespace tendon::gui
