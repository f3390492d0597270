#pragma once

#include <QFrame>
#include <QPointer>

class QScrollArea;
class QToolButton;

namespace tendon::gui {

class HeaderRow;

/// A card over the lower part of a widget, as high as its contents. It is not modal: the rest of
/// the window stays usable. Escape closes it and returns the focus.
class OverlayCard : public QFrame {
  Q_OBJECT

 public:
  /// Covers a part of `place`. Takes ownership of `body`, which must have a layout before the card
  /// is opened. Hidden at first.
  OverlayCard(QWidget& place, QWidget* body);

  void close();

 Q_SIGNALS:
  void closed();
  /// One sentence for the user.
  void notice(const QString& text);

 protected:
  [[nodiscard]] QWidget& body() { return *body_; }
  [[nodiscard]] HeaderRow& head() { return *head_; }
  /// The close button, the last one in the head.
  [[nodiscard]] QToolButton& leave() { return *leave_; }
  /// Adds a widget to the head, before the close button.
  void addToHead(QWidget* widget);
  void open();
  /// Called on Enter, if the focused widget does not use Enter itself.
  virtual void enter() {}
  /// Fits the height to the present contents.
  void fit();

  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget& place_;
  QWidget* body_;
  HeaderRow* head_;
  QToolButton* leave_;
  QScrollArea* scroll_;
  QPointer<QWidget> before_;  // had the focus before
};

}  // namespace tendon::gui
