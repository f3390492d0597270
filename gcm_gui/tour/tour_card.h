#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QPushButton;

namespace tendon::gui {

/// What the tour says of one thing, with the ways on, back and out: buttons, and the keys Enter or
/// Right, Left, and Escape. While it has the focus, no key without Ctrl or Alt means anything else
/// to the window, and Tab stays within the card.
class TourCard : public QFrame {
  Q_OBJECT

 public:
  explicit TourCard(QWidget* parent);

  /// `number` from 1 to `count`.
  void show(const QString& title, const QString& text, int number, int count);
  /// As wide as a line that is read well, as high as its words need.
  [[nodiscard]] QSize wantedSize() const;
  /// The focus goes to the button that goes on.
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

}  // namespace tendon::gui
