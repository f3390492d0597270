#pragma once

#include <QString>
#include <QWidget>

namespace tendon::gui {

/// A coloured line across the window with the word REPLAY, so that users do not mistake a recording
/// for a running system.
class ReplayStripe final : public QWidget {
  Q_OBJECT

 public:
  explicit ReplayStripe(QWidget* parent = nullptr);

  /// `file` is the name of the file, `about` is further information about the file, and `time` is
  /// the time of day of the shown moment.
  void show(const QString& file, const QString& about, const QString& time);
  /// The whole text of the line, for screen readers.
  [[nodiscard]] QString text() const;

  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString file_;
  QString about_;
  QString time_;
};

}  // namespace tendon::gui
