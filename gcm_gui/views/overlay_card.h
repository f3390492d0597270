#pragma once

#include <QFrame>
#include <QPointer>

class QScrollArea;
class QToolButton;

namespace tendon::gui {

class HeaderRow;

/// A card over the lower part of a widget, as high as its contents. It is not modal: the user can
/// still use the rest of the window. Escape closes the card and restores the previous focus.
class OverlayCard : public QFrame {
  Q_OBJECT

 public:
  /// Creates a hidden card that covers a part of `place`. Takes ownership of `body`, which must
  /// have a layout before the card is opened.
  OverlayCard(QWidget& place, QWidget* body);

  void close();

 Q_SIGNALS:
  void closed();
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 protected:
  [[nodiscard]] QWidget& body() { return *body_; }
  [[nodiscard]] HeaderRow& head() { return *head_; }
  /// The button that closes the card; it is the last one in the header.
  [[nodiscard]] QToolButton& leave() { return *leave_; }
  /// Adds a widget to the header, before the close button.
  void addToHead(QWidget* widget);
  void open();
  /// Called when the user presses Enter and the focused widget does not use Enter itself.
  virtual void enter() {}
  /// Changes the height of the card to the height of its contents.
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
  QPointer<QWidget> before_;  // the widget that had the focus before
};

}  // namespace tendon::gui
