#pragma once

#include <QFrame>
#include <QPointer>

class QScrollArea;
class QToolButton;

namespace tendon::gui {

class HeadRow;

/// Something to be read and done over a part of the window; no dialog: all else goes on and can be
/// used. As high as it needs, from below. Escape closes it and gives the focus back.
class OverlayCard : public QFrame {
  Q_OBJECT

 public:
  /// Stands over `place`, a part of its window; `body` becomes its own, and is given a
  /// layout before the card is opened. Hidden at first.
  OverlayCard(QWidget& place, QWidget* body);

  void close();

 Q_SIGNALS:
  void closed();
  /// One sentence for the user.
  void notice(const QString& text);

 protected:
  [[nodiscard]] QWidget& body() { return *body_; }
  [[nodiscard]] HeadRow& head() { return *head_; }
  /// The last thing in the head.
  [[nodiscard]] QToolButton& leave() { return *leave_; }
  /// Behind what stands in the head already, before the one that closes it.
  void addToHead(QWidget* widget);
  void open();
  /// Enter, where the focus is on nothing that it presses.
  virtual void enter() {}
  /// To what the body needs now.
  void fit();

  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget& place_;
  QWidget* body_;
  HeadRow* head_;
  QToolButton* leave_;
  QScrollArea* scroll_;
  QPointer<QWidget> before_;  // had the focus
};

}  // namespace tendon::gui
