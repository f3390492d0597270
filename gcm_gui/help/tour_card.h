#pragma once

#include <QFrame>
#include <QRect>
#include <QSize>
#include <QString>

class QLabel;
class QPushButton;

namespace tendon::gui {

/// The tour's text about one widget, with buttons and keys to continue (Enter or Right), to go back
/// (Left) and to end (Escape). While the card has the focus, the window receives no key without
/// Ctrl or Alt, and Tab stays within the card.
class TourCard : public QFrame {
  Q_OBJECT

 public:
  explicit TourCard(QWidget* parent);

  /// `number` counts from 1 to `count`.
  void show(const QString& title, const QString& text, int number, int count);
  /// The size for a readable line length.
  [[nodiscard]] QSize wantedSize() const;
  /// Sets the focus to the button that continues.
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

/// The place for a card of this size beside `shown`: the first of right, left, below and above that
/// fits into `room`; otherwise over the lower part of `shown`. Always within `room`.
[[nodiscard]] QRect CardBeside(const QRect& shown, const QSize& card, const QRect& room);

}  // namespace tendon::gui
