#pragma once

#include <QString>
#include <QWidget>

class QLabel;
class QPushButton;

namespace tendon::gui {

class ReplaySession;

/// Replaces the graph while there are no components to show: while a recording is being opened, if
/// it cannot be opened, or if it contains no components.
class ReplayPage final : public QWidget {
  Q_OBJECT

 public:
  /// `session` must outlive this object.
  explicit ReplayPage(ReplaySession& session, QWidget* parent = nullptr);

  [[nodiscard]] QString text() const;

 Q_SIGNALS:
  void openRequested();

 private:
  void refresh();

  ReplaySession& session_;
  QLabel* title_;
  QLabel* text_;
  QPushButton* open_;
};

}  // namespace tendon::gui
