#pragma once

#include <QFrame>
#include <QRect>
#include <QSize>
#include <QString>

class QLabel;
class QPushButton;

namespace tendon::gui {

/// The card with the tour's text about one widget. Its buttons and keys continue the tour (Enter or
/// Right), go back (Left) and end it (Escape). While the card has the focus, the window receives
/// only keys with Ctrl or Alt, and Tab stays within the card.
class TourCard : public QFrame {
  Q_OBJECT

 public:
  explicit TourCard(QWidget* parent);

  /// `number` counts from 1 to `count`.
  void show(const QString& title, const QString& text, int number, int count);
  /// Returns the size at which the lines are easy to read.
  [[nodiscard]] QSize wantedSize() const;
  /// Sets the focus to the button "next".
  void takeFocus();

 Q_SIGNALS:
  void nextRequested();
  void backRequested();
  void endRequested();

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  [[nodiscard]] QPushButton* addButton(const char* name, const QString& text);
  bool press(int key, QPushButton& focused);

  QLabel* title_;
  QLabel* text_;
  QLabel* place_;
  QPushButton* skip_;
  QPushButton* back_;
  QPushButton* next_;
};

/// Returns a position for a card of this size beside `shown`: to the right, to the left, below or
/// above, whichever fits first into `room`. If none fits, the card covers the lower part of
/// `shown`. The result is always within `room`.
[[nodiscard]] QRect CardBeside(const QRect& shown, const QSize& card, const QRect& room);

}  // namespace tendon::gui
