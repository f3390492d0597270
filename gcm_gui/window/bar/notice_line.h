#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/connect/connect_mode.h>

#include <QTimer>
#include <QWidget>

namespace tendon::gui {

/// One line above the graph: what the connect mode waits for, else what has just happened.
class NoticeLine : public QWidget {
  Q_OBJECT

 public:
  NoticeLine(const ConnectMode& mode, const ActivityModel& activity, QWidget* parent = nullptr);

  [[nodiscard]] QString text() const { return before_ + path_ + after_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 public Q_SLOTS:
  /// For some seconds.
  void tell(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();
  void showMode();
  void hear(const Action& finished);

  const ConnectMode& mode_;
  QString notice_;
  QTimer fade_;
  // What is shown: a path between words.
  QString before_;
  QString path_;
  QString after_;
};

}  // namespace tendon::gui
